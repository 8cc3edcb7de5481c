// SPDX-License-Identifier: Apache-2.0
// Operands on two sides of a plane: the merged tree is theirs and one node.
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"

#include <cmath>

using namespace cleave;
using namespace support;

namespace {

template <int D>
void check_separated(const Region<D>& a, const Region<D>& b) {
    for (const Region<D>& x : {a, Region<D>(~a)})
        for (const Region<D>& y : {b, Region<D>(~b)})
            for (const Operation operation : all_operations) {
                OperationCounts counts;
                OperationOptions options;
                options.counts = &counts;
                const Region<D> merged = apply(Engine::tree_merge, operation, x, y, options);
                CHECK(counts.merged_nodes == counts.tree_nodes + 1);
                CHECK(counts.result_nodes <= counts.merged_nodes);
                CHECK(canonical(merged) == canonical(apply(operation, x, y)));
            }
}

template <int D>
Region<D> random_bounded(Dice& dice) {
    Region<D> r = region_of<D>(random_convex<D>(dice, true).planes);
    return r | region_of<D>(random_convex<D>(dice, true).planes);
}

template <int D>
Region<D> moved(const Region<D>& r, int axis, int by) {
    Matrix<D + 1, D + 1, Integer> m = identity_matrix<D + 1, Integer>();
    m(axis, D) = Integer(by);
    return transform(AffineMap<D, Integer>(std::move(m)), r);
}

template <int D>
void check_random(unsigned seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const Region<D> a = random_bounded<D>(dice);
    const Region<D> b = random_bounded<D>(dice);
    if (a.is_empty() || b.is_empty()) return;
    check_separated(a, moved(b, dice.below(D), dice.below(2) == 0 ? 100 : -100));
}

}  // namespace

TEST_CASE("separated operands: nodes(A) + nodes(B) + 1 nodes, by every operation") {
    for (unsigned seed = 0; seed < scaled(20); ++seed) {
        check_random<1>(seed);
        check_random<2>(seed);
        check_random<3>(seed);
    }
    for (unsigned seed = 0; seed < scaled(3); ++seed) check_random<4>(seed);
}

TEST_CASE("separated operands: a gap of one bit, and none at all") {
    // There is no double between the two, so the trees are merged as ever.
    const double next = std::nextafter(1.0, 2.0);
    const Rational one_bit = number_traits<Rational>::from_double(next);
    for (const Rational& x : {Rational(1), one_bit, Rational(3, 2)}) {
        const Region<2> a = box<2>({0, 0}, {1, 1});
        const Region<2> b = box<2>({x, 0}, {3, 1});
        OperationCounts counts;
        OperationOptions options;
        options.counts = &counts;
        const Region<2> both = apply(Engine::tree_merge, Operation::union_, a, b, options);
        CHECK(canonical(both) == canonical(a | b));
        CHECK(measure(both) == Rational(4 - x));
        CHECK(counts.merged_nodes <= counts.tree_nodes + 1);
    }
}

TEST_CASE("separated operands: unbounded ones are never taken for separated") {
    // A half-line's boundary is one finite point, apart from that of a segment inside or outside it.
    const Region<1> ray = half_space(make_plane<Integer>(1, 0));
    for (const Region<1>& segment : {box<1>({-3}, {-2}), box<1>({2}, {3})})
        for (const Operation operation : all_operations) {
            CHECK(canonical(apply(Engine::tree_merge, operation, ray, segment)) ==
                  canonical(apply(operation, ray, segment)));
            CHECK(canonical(apply(Engine::tree_merge, operation, segment, ~ray)) ==
                  canonical(apply(operation, segment, ~ray)));
        }
    CHECK(canonical(ray | box<1>({-3}, {-2})) == canonical(ray));
    const Region<2> left = half_space(make_plane<Integer>(1, 0, 0));
    const Region<2> right = half_space(make_plane<Integer>(-1, 0, 5));
    CHECK(canonical(apply(Engine::tree_merge, Operation::union_, left, right)) == canonical(left | right));
    CHECK(apply(Engine::tree_merge, Operation::intersection, left, right).is_empty());
    const Region<2> b = box<2>({100, 100}, {101, 101});
    CHECK(canonical(apply(Engine::tree_merge, Operation::union_, left, b)) == canonical(left | b));
}
