// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/section.hpp>
//
#include <cleave/query/measure.hpp>
#include <cleave/query/representation.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/extrude.hpp>
#include <cleave/shape/simplex.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"
#include "support/region_checker.hpp"

#include <algorithm>
#include <array>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// The section of a union is the union of sections and so on, at positions off all planes and on them.
template <int D>
void check_sections(unsigned seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const bool bounded = dice.below(2) == 0;
    const Region<D> a = region_of<D>(random_convex<D>(dice, bounded).planes);
    const Region<D> b = region_of<D>(random_convex<D>(dice, bounded).planes);
    const int axis = dice.below(D);
    for (const Rational& at : {Rational(dice.between(-3, 3)), Rational(Rational(dice.between(-6, 6)) / 7)}) {
        const Region<D - 1> sa = section(a, axis, at);
        const Region<D - 1> sb = section(b, axis, at);
        for (const Operation op : all_operations)
            CHECK(canonical(section(apply(op, a, b), axis, at)) == canonical(apply(op, sa, sb)));
        CHECK(canonical(section(~a, axis, at)) == canonical(~sa));
    }
}

}  // namespace

TEST_CASE("section: boxes and simplices") {
    CHECK(canonical(verified(section(box<2>({0, 1}, {2, 3}), 0, 1))) == canonical(box<1>({1}, {3})));
    CHECK(canonical(verified(section(box<3>({0, 1, 2}, {3, 4, 6}), 1, 2))) == canonical(box<2>({0, 2}, {3, 6})));
    CHECK(section(box<3>({0, 1, 2}, {3, 4, 6}), 1, 5).is_empty());
    const Region<3> corner = simplex<3>({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}});
    CHECK(canonical(section(corner, 2, Rational(1, 3))) ==
          canonical(simplex<2>({{{0, 0}, {Rational(8, 3), 0}, {0, Rational(8, 3)}}})));
    const Region<4> shell = box<4>({0, 0, 0, 0}, {3, 3, 3, 3}) - box<4>({1, 1, 1, 1}, {2, 2, 2, 2});
    CHECK(canonical(section(shell, 3, Rational(3, 2))) ==
          canonical(box<3>({0, 0, 0}, {3, 3, 3}) - box<3>({1, 1, 1}, {2, 2, 2})));
}

TEST_CASE("section: in the plane of a face it is the limit from below") {
    const Region<2> square = box<2>({0, 0}, {2, 2});
    CHECK(canonical(section(square, 1, 2)) == canonical(box<1>({0}, {2})));
    CHECK(section(square, 1, 0).is_empty());
    const Region<2> stairs = square | box<2>({1, 2}, {3, 4});
    CHECK(canonical(section(stairs, 1, 2)) == canonical(box<1>({0}, {2})));
    CHECK(canonical(section(~stairs, 1, 2)) == canonical(~box<1>({0}, {2})));
    // A pyramid's apex has no section, its base has one.
    const Region<3> pyramid = simplex<3>({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}});
    CHECK(section(pyramid, 2, 3).is_empty());
    CHECK(section(pyramid, 2, 0).is_empty());
    Matrix<4, 4, Integer> m = identity_matrix<4, Integer>();
    m(2, 2) = Integer(-1);
    CHECK(canonical(section(transform(AffineMap<3, Integer>(m), pyramid), 2, 0)) ==
          canonical(simplex<2>({{{0, 0}, {3, 0}, {0, 3}}})));
}

TEST_CASE("section: unbounded sets, empty and full") {
    CHECK(canonical(section(half_space(make_plane<Integer>(1, 2, -4)), 0, 2)) ==
          canonical(half_space(make_plane<Integer>(1, -1))));
    CHECK(section(half_space(make_plane<Integer>(0, 0, 1, -4)), 2, 3).is_full());
    CHECK(section(half_space(make_plane<Integer>(0, 0, 1, -4)), 2, 5).is_empty());
    CHECK(section(Region<3>::full(), 0, 0).is_full());
    CHECK(section(Region<3>::empty(), 0, 0).is_empty());
}

TEST_CASE("section: it commutes with set operations and undoes extrusion") {
    for (unsigned seed = 0; seed < scaled(60); ++seed) {
        check_sections<2>(seed);
        check_sections<3>(seed);
    }
    for (unsigned seed = 0; seed < scaled(6); ++seed) check_sections<4>(seed);
    const Region<3> base = box<3>({0, 0, 0}, {2, 2, 2}) - simplex<3>({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}});
    CHECK(canonical(section(extrude(base, -1, 1), 3, Rational(1, 5))) == canonical(base));
    CHECK(canonical(section(extrude(base), 3, 100)) == canonical(base));
}

TEST_CASE("section: the measure of a 4-D union is the integral of its sections' volumes") {
    const Region<4> a = simplex<4>({{0, 0, 0, 0}, {4, 0, 0, 0}, {0, 4, 0, 0}, {0, 0, 4, 0}, {0, 0, 0, 4}});
    const Region<4> b = simplex<4>({{1, 1, 1, -1}, {5, 1, 1, -1}, {1, 5, 1, -1}, {1, 1, 5, -1}, {1, 1, 1, 3}});
    const Region<4> sum = a | b;
    // Every vertex of the union has an integer height or that of a meet of an edge with a facet; between them the
    // volume is a cubic. Those heights, from the vertices themselves:
    std::vector<Rational> breaks;
    for (const auto& v : vertices(sum)) breaks.push_back(v[3]);
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    Rational integral = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const Rational step = (breaks[i + 1] - breaks[i]) / 5;
        std::array<Rational, 4> v;
        for (int k = 0; k < 4; ++k) {
            const Rational height = breaks[i] + (k + 1) * step;
            v[std::size_t(k)] = *measure(section(sum, 3, height));
            CHECK(canonical(section(sum, 3, height)) == canonical(section(a, 3, height) | section(b, 3, height)));
        }
        // The open rule 5h/24 (11, 1, 1, 11) is exact for cubics.
        integral += 5 * step / 24 * (11 * v[0] + v[1] + v[2] + 11 * v[3]);
    }
    CHECK(integral == *measure(sum));
    CHECK(integral == Rational(*measure(a) + *measure(b) - *measure(a & b)));
    CHECK(canonical(apply(Engine::tree_merge, Operation::union_, a, b)) == canonical(sum));
}
