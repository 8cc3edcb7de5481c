// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/plane_table.hpp>
//
#include "support/catch.hpp"

using namespace cleave;

TEST_CASE("plane table: multiples of a plane are one plane, negative ones its flip") {
    PlaneTable<3> table;
    const PlaneId h = table.intern({Integer(2), Integer(-4), Integer(6), Integer(8)});
    CHECK(table.exact(unoriented(h)) == PlaneTable<3>::Coefficients{Integer(1), Integer(-2), Integer(3), Integer(4)});
    CHECK(table.intern({Integer(1), Integer(-2), Integer(3), Integer(4)}) == h);
    CHECK(table.intern({Integer(-3), Integer(6), Integer(-9), Integer(-12)}) == flipped(h));
    CHECK(table.intern({Integer(1), Integer(-2), Integer(3), Integer(5)}) != h);
    CHECK(table.size() == 2);
}

TEST_CASE("plane table: leading zeros and a zero offset") {
    PlaneTable<3> table;
    const PlaneId up = table.intern({Integer(0), Integer(0), Integer(7), Integer(0)});
    CHECK(up == flipped(table.intern({Integer(0), Integer(0), Integer(-1), Integer(0)})));
    CHECK(table.axis(unoriented(up)) == 2);
    CHECK(table.axis_position(unoriented(up)) == 0.0);
}

TEST_CASE("plane table: an axis-parallel plane knows its position only where that is a double") {
    PlaneTable<2> table;
    const PlaneId half = table.intern({Integer(2), Integer(0), Integer(-1)});
    CHECK(table.axis_position(unoriented(half)) == 0.5);
    CHECK(table.intern_axis_plane(0, 0.5) == half);
    const PlaneId third = table.intern({Integer(3), Integer(0), Integer(-1)});
    CHECK(table.axis(unoriented(third)) == 0);
    CHECK(std::isnan(table.axis_position(unoriented(third))));
    const PlaneId long_one = table.intern({Integer(1), Integer(0), Integer::scaled(1, 60) + Integer(1)});
    CHECK(std::isnan(table.axis_position(unoriented(long_one))));
    CHECK(table.axis(unoriented(table.intern({Integer(1), Integer(1), Integer(0)}))) == -1);
}

TEST_CASE("plane table: coefficients too far apart for the filter's error model have no approximation") {
    PlaneTable<2> table;
    const PlaneId steep = table.intern({Integer(1), Integer::scaled(1, 2000), Integer(1)});
    CHECK(std::isnan(table.approximation(unoriented(steep))[0]));
    const PlaneId plain = table.intern({Integer(3), Integer(4), Integer(5)});
    CHECK(table.approximation(unoriented(plain))[1] == 0.5);  // 4 / 2^3
}

TEST_CASE("plane table: planes come over from another table with their ids' meaning") {
    PlaneTable<3> one;
    PlaneTable<3> two;
    const PlaneId a = one.intern({Integer(1), Integer(2), Integer(3), Integer(4)});
    two.intern({Integer(0), Integer(1), Integer(0), Integer(0)});
    const std::uint32_t k = two.intern_from(one, unoriented(a));
    CHECK(k == 1);
    CHECK(two.exact(k) == one.exact(unoriented(a)));
    CHECK(two.intern_from(one, unoriented(a)) == k);
    CHECK(two.bits() == std::pair<std::size_t, std::size_t>(2, 3));
}

TEST_CASE("plane table: many planes stay apart") {
    PlaneTable<2> table;
    for (int a = -9; a <= 9; ++a)
        for (int b = -9; b <= 9; ++b)
            for (int c = -9; c <= 9; ++c)
                if (a != 0 || b != 0) {
                    const PlaneId h = table.intern({Integer(a), Integer(b), Integer(c)});
                    const auto& n = table.exact(unoriented(h));
                    REQUIRE(n[0] * Integer(b) == n[1] * Integer(a));
                    REQUIRE(n[0] * Integer(c) == n[2] * Integer(a));
                    REQUIRE(n[1] * Integer(c) == n[2] * Integer(b));
                }
}
