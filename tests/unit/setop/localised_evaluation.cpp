// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/localised_evaluation.hpp>
//
#include <cleave/query/measure.hpp>
#include <cleave/query/representation.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <vector>

using namespace cleave;

namespace {

/// A cube of side 2 around c, turned about two axes.
Region<3> turned_cube(const std::array<Rational, 3>& c) {
    const auto turn = compose(rational_rotation<3, Integer>(0, 1, 5, 2), rational_rotation<3, Integer>(1, 2, 8, 3));
    return transform(compose(translation<Integer>(c[0], c[1], c[2]), turn), box<3>({-1, -1, -1}, {1, 1, 1}));
}

/// The operation by this evaluation, whatever the operands: the engine has a faster one for those that conform.
Region<3> localised(Operation operation, const Region<3>& a, const Region<3>& b, const OperationOptions& options) {
    const std::array<const Boundary<3>*, 2> operands{&a.boundary(), &b.boundary()};
    return Region<3>(LocalisedEvaluation<3>(operands, BooleanFunction::from(operation, 2), options).finish());
}

/// By every operation: the set of boundary filtering, no point twice, and measures that add up.
OperationCounts check_operations(const Region<3>& a, const Region<3>& b) {
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    for (const Operation operation : all_operations) {
        const Region<3> r = localised(operation, a, b, options);
        CHECK(canonical(r) == canonical(apply(Engine::boundary_filter, operation, a, b)));
        const std::vector<std::array<Rational, 3>> points = vertices(r);
        CHECK(std::adjacent_find(points.begin(), points.end()) == points.end());
    }
    CHECK(Rational(*measure(a) + *measure(b)) == Rational(*measure(a | b) + *measure(a & b)));
    return counts;
}

}  // namespace

TEST_CASE("localised evaluation: faces that cross properly, each by its edges and cuts") {
    const OperationCounts counts = check_operations(turned_cube({0, 0, 0}), box<3>({0, 0, 0}, {3, 3, 3}));
    CHECK(counts.faces_crossed >= 6);
    CHECK(counts.faces_filtered == 0);
    CHECK(counts.points_located == 0);
    // Two cubes around one centre: every face of both is crossed, by most of the other's.
    const OperationCounts all = check_operations(turned_cube({0, 0, 0}), box<3>({-1, -1, -1}, {1, 1, 1}));
    CHECK(all.faces_crossed == 12);
    CHECK(all.faces_filtered == 0);
    // Through one face only, in a closed curve inside it: nothing on that face's edges tells where its rim is.
    const OperationCounts curve = check_operations(turned_cube({5, 5, 10}), box<3>({0, 0, 0}, {10, 10, 10}));
    CHECK(curve.faces_crossed > 4);
    CHECK(curve.faces_filtered == 0);
    CHECK(curve.points_located > 0);
}

TEST_CASE("localised evaluation: faces in special position are filtered, the others are not") {
    // A boss on the top of a block, and something that crosses both.
    const Region<3> block = box<3>({0, 0, 0}, {10, 10, 10});
    const Region<3> boss = box<3>({4, 4, 10}, {6, 6, 12});
    const OperationCounts counts = check_operations(block, boss);
    CHECK(counts.faces_crossed == 0);
    CHECK(counts.faces_filtered == 6);  // the two in contact, and the boss's walls, whose edges lie on the top
    const OperationCounts both = check_operations(block, boss | turned_cube({10, 0, 0}));
    CHECK(both.faces_crossed > 0);
    CHECK(both.faces_filtered > 0);
}

TEST_CASE("localised evaluation: cutting faces for location makes no point twice") {
    // The top has a pocket in line with two shelves: cut into convex faces for locating, it gets points where the
    // shelves' corners are, in the middle of its own edges. The block apart has to be located.
    const Region<3> block = box<3>({0, 0, 0}, {4, 4, 4}) - box<3>({1, 1, 3}, {2, 2, 5});
    const Region<3> shelves = box<3>({4, 1, 2}, {6, 2, 4}) | box<3>({1, 4, 2}, {2, 6, 4});
    const Region<3> part = block | shelves | box<3>({20, 0, 0}, {21, 1, 1});
    const Region<3> tools = turned_cube({6, Rational(3, 2), 3}) | turned_cube({Rational(3, 2), 6, 3});
    const OperationCounts counts = check_operations(part, tools);
    CHECK(counts.faces_crossed > 0);
    CHECK(counts.faces_filtered == 0);
    CHECK(counts.points_located > 0);
}
