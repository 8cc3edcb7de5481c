// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/point_location.hpp>
//
#include <cleave/region/transform.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>

#include "support/catch.hpp"
#include "support/tree_set.hpp"

#include <array>
#include <cstddef>

using namespace cleave;

namespace {

/// Locates points on a half-integer grid around the region, and the same points moved off it, as a tree does.
void check_points(const Region<3>& region) {
    const Boundary<3>* const boundary = &region.surface();
    SurfaceOperands operands({&boundary, 1});
    PointLocation location(operands, 0);
    support::TreeSet<3> tree(region);
    std::size_t asked = 0;
    for (int n = 0; n < 9 * 9 * 9; ++n) {
        std::array<Rational, 3> x{Rational(n % 9 - 2) / 2, Rational(n / 9 % 9 - 2) / 2, Rational(n / 81 - 2) / 2};
        if (n % 3 == 1) x[0] += Rational(1) / 7;
        const Location truth = tree.at(x);
        if (truth == Location::boundary) continue;
        ++asked;
        const PointId p = add_point<Rational, 3>(operands.kernel(), x);
        if (location.contains(p) != (truth == Location::inside)) {
            CAPTURE(n);
            CHECK(location.contains(p) == (truth == Location::inside));
        }
    }
    CHECK(asked > 100);
}

}  // namespace

TEST_CASE("point location: rays through edges, vertices and along walls") {
    const Region<3> cube = box<3>({0, 0, 0}, {2, 2, 2});
    check_points(cube);
    check_points(~cube);
    check_points(simplex<3>({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}));
    // Columns of corners above each other, a room, and a shell apart.
    check_points((cube - box<3>({Rational(1, 2), Rational(1, 2), Rational(1, 2)}, {1, 1, Rational(3, 2)})) |
                 box<3>({0, 0, 2}, {1, 1, 3}) | box<3>({3, 3, 3}, {4, 4, 4}));
}

TEST_CASE("point location: faces with planes of their own and corners that are no doubles") {
    const AffineMap<3, Integer> turn = rational_rotation<3, Integer>(0, 2, 3, 1);
    check_points(transform(turn, box<3>({0, 0, 0}, {2, 2, 2})));
    check_points(transform(turn, box<3>({0, 0, 0}, {2, 2, 2})) |
                 simplex<3>({{0, 0, 0}, {3, 0, 1}, {0, 3, 1}, {1, 0, 3}}));
}

TEST_CASE("point location: vertices of another operand") {
    const Region<3> inner = box<3>({1, 1, 1}, {2, 2, 2});
    const Region<3> outer = box<3>({0, 0, 0}, {4, 4, 4});
    const std::array<const Boundary<3>*, 2> boundaries{&inner.surface(), &outer.surface()};
    SurfaceOperands operands(boundaries);
    PointLocation location(operands, 1);
    for (PointId p = 0; p < inner.surface().points.size(); ++p) CHECK(location.contains(0, p));
    PointLocation other(operands, 0);
    for (PointId p = 0; p < outer.surface().points.size(); ++p) CHECK_FALSE(other.contains(1, p));
}
