// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/double_plane.hpp>
//
#include <cleave/geometry/kernel.hpp>
#include <cleave/geometry/plane_table.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

using namespace cleave;
using support::Dice;

TEST_CASE("plane through points of doubles: the join of the points, whatever their scale") {
    Dice dice(6);
    int flat = 0;
    for (int n = 0; n < 3000; ++n) {
        std::array<std::array<double, 3>, 3> p{};
        const int low = n % 4 == 0 ? -1000 : -20;
        const int high = n % 4 == 1 ? 900 : 20;
        for (auto& q : p)
            for (double& x : q)
                x = n % 2 == 0 ? std::ldexp(dice.between(-9, 9), dice.between(low, high)) : dice.between(-2, 2);
        Kernel<3> kernel;
        std::array<PointId, 3> id{};
        for (std::size_t i = 0; i < 3; ++i) id[i] = kernel.add_point(p[i]);
        const std::optional<PlaneId> joined = kernel.join(std::span<const PointId, 3>(id));
        const std::array<Integer, 4> plane = plane_through(p[0], p[1], p[2]);
        if (!joined) {
            ++flat;
            CHECK(std::all_of(plane.begin(), plane.end(), [](const Integer& x) { return x.is_zero(); }));
            continue;
        }
        CHECK(kernel.planes.intern(plane) == *joined);
    }
    CHECK(flat > 0);
}

TEST_CASE("plane in machine words: the primitive plane that integers of any length give") {
    Dice dice(11);
    std::size_t small = 0;
    std::size_t large = 0;
    std::size_t flipped = 0;
    for (int n = 0; n < 6000; ++n) {
        const auto coordinate = [&] {
            switch (n % 5) {
                case 0:  // many bits
                    return std::ldexp(dice.between(-1000000, 1000000), -20) +
                           std::ldexp(dice.between(-1000000, 1000000), -52);
                case 1:  // common divisors, zeros, faces along axes
                    return double(dice.between(-3, 3));
                case 2:  // fractions whose common divisor is a power of two
                    return 0.25 * dice.between(-20, 20);
                case 3:  // integers whose common divisor is large
                    return 1048576.0 * 3 * 5 * 7 * dice.between(-9, 9);
                default:  // more than 62 bits at times
                    return std::ldexp(dice.between(-900, 900), dice.between(-30, 30));
            }
        };
        std::array<std::array<double, 3>, 3> p{};
        for (auto& q : p)
            for (double& x : q) x = coordinate();
        const std::array<Integer, 4> plane = plane_through(p[0], p[1], p[2]);
        if (std::all_of(plane.begin(), plane.end(), [](const Integer& x) { return x.is_zero(); })) continue;
        PlaneTable<3> table;
        const PlaneId expected = table.intern(plane);
        const std::optional<PrimitivePlane> found = small_plane_through(p[0], p[1], p[2]);
        if (!found) {
            ++large;
            continue;
        }
        ++small;
        flipped += found->is_flipped ? 1U : 0U;
        CHECK(found->coefficients == table.exact(unoriented(expected)));
        CHECK(found->is_flipped == is_flipped(expected));
    }
    CHECK(small > 4000);
    CHECK(large > 100);
    CHECK(flipped > 1000);
}

TEST_CASE("plane in machine words: at the end of its range") {
    // 62 bits from the lowest to the highest; one more is too many.
    const double top = std::ldexp(1.0, 61);
    const std::array<double, 3> p{top, -top, 1}, q{-top, 3, top}, r{5, top, -top};
    PlaneTable<3> table;
    const PlaneId expected = table.intern(plane_through(p, q, r));
    const std::optional<PrimitivePlane> found = small_plane_through(p, q, r);
    REQUIRE(found);
    CHECK(found->coefficients == table.exact(unoriented(expected)));
    CHECK(found->is_flipped == is_flipped(expected));
    CHECK_FALSE(small_plane_through({2 * top, -top, 1}, q, r));
    CHECK_FALSE(small_plane_through({0, 0, 1}, {0, 1e-300, 0}, {1, 0, 0}));
    // All coefficients divisible by more than a word.
    const double big = std::ldexp(3486784401.0, 28);  // 3^20
    const std::optional<PrimitivePlane> scaled = small_plane_through({big, 0, 0}, {0, big, 0}, {0, 0, big});
    if (scaled) CHECK(scaled->coefficients[0] == Integer(1));
    CHECK(table.intern(plane_through({big, 0, 0}, {0, big, 0}, {0, 0, big})) ==
          table.intern({Integer(1), Integer(1), Integer(1), -Integer::scaled(3486784401, 28)}));
}
