// SPDX-License-Identifier: Apache-2.0
#include <cleave/shape/extrude.hpp>
//
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>

#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <limits>

using namespace cleave;
using namespace support;

TEST_CASE("extrude: a segment becomes a box, one dimension at a time") {
    const Region<1> segment = box<1>({1}, {3});
    const Region<2> plate = extrude(segment, 0, Rational(1, 3));
    CHECK(canonical(verified(plate)) == canonical(box<2>({1, 0}, {3, Rational(1, 3)})));
    const Region<3> brick = extrude(plate, 2, -1);  // in either order
    CHECK(canonical(verified(brick)) == canonical(box<3>({1, 0, -1}, {3, Rational(1, 3), 2})));
    const Region<4> four = extrude(brick, 0, 5);
    CHECK(canonical(four) == canonical(box<4>({1, 0, -1, 0}, {3, Rational(1, 3), 2, 5})));
    CHECK(canonical(extrude(four, 7, 8)) == canonical(box<5>({1, 0, -1, 0, 7}, {3, Rational(1, 3), 2, 5, 8})));
}

TEST_CASE("extrude: bases in several parts, with holes and cavities") {
    const Region<1> two = box<1>({0}, {1}) | box<1>({2}, {5});
    CHECK(measure(verified(extrude(two, 0, 2))) == Rational(8));
    const Region<2> frame = box<2>({0, 0}, {3, 3}) - box<2>({1, 1}, {2, 2});
    CHECK(measure(verified(extrude(frame, 0, 2))) == Rational(16));
    const Region<3> shell = box<3>({0, 0, 0}, {3, 3, 3}) - box<3>({1, 1, 1}, {2, 2, 2});
    const Region<4> prism_of_shell = extrude(shell, Rational(1, 2), 2);
    CHECK(measure(prism_of_shell) == Rational(39));
    CHECK(canonical(prism_of_shell) ==
          canonical(box<4>({0, 0, 0, Rational(1, 2)}, {3, 3, 3, 2}) - box<4>({1, 1, 1, Rational(1, 2)}, {2, 2, 2, 2})));
}

TEST_CASE("extrude: set operations on bases are those on what is swept") {
    const Region<3> a = simplex<3>({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}});
    const Region<3> b = box<3>({-1, 0, 0}, {1, 1, 4});
    for (const Operation op : all_operations) {
        const std::string expected = canonical(apply(op, extrude(a, 0, 2), extrude(b, 0, 2)));
        CHECK(canonical(extrude(apply(op, a, b), 0, 2)) == expected);
        CHECK(canonical(extrude(apply(op, a, b))) == canonical(apply(op, extrude(a), extrude(b))));
    }
}

TEST_CASE("extrude: unbounded bases, and without bounds") {
    const Region<1> ray = half_space(make_plane<Integer>(-1, 2));  // x >= 2
    const Region<2> strip = extrude(ray, 0, 1);
    CHECK(canonical(strip) ==
          canonical(half_spaces<2, Integer>(std::vector<Plane<2, Integer>>{
              make_plane<Integer>(-1, 0, 2), make_plane<Integer>(0, -1, 0), make_plane<Integer>(0, 1, -1)})));
    const Region<2> wedge = half_space(make_plane<Integer>(1, 0, 0)) & half_space(make_plane<Integer>(0, 1, 0));
    CHECK(canonical(extrude(wedge, 0, 1)) == canonical(half_spaces<3, Integer>(std::vector<Plane<3, Integer>>{
                                                 make_plane<Integer>(1, 0, 0, 0), make_plane<Integer>(0, 1, 0, 0),
                                                 make_plane<Integer>(0, 0, -1, 0), make_plane<Integer>(0, 0, 1, -1)})));
    CHECK(canonical(extrude(Region<2>::full(), 0, 1)) ==
          canonical(half_space(make_plane<Integer>(0, 0, 1, -1)) - half_space(make_plane<Integer>(0, 0, 1, 0))));
    CHECK(canonical(extrude(extrude(half_space(make_plane<Integer>(3, -1))))) ==
          canonical(half_space(make_plane<Integer>(3, 0, 0, -1))));
    const Region<3> tube = extrude(box<2>({0, 0}, {1, 1}));
    CHECK(canonical(tube & extrude(Region<2>::full(), 0, 1)) == canonical(box<3>({0, 0, 0}, {1, 1, 1})));
    CHECK(!tube.is_bounded());
    CHECK(extrude(Region<3>::full()).is_full());
    CHECK(extrude(Region<3>::empty()).is_empty());
}

TEST_CASE("extrude: without height or base it is empty; bounds are numbers") {
    CHECK(extrude(box<2>({0, 0}, {1, 1}), 1, 1).is_empty());
    CHECK(extrude(Region<1>::full(), 1, 1).is_empty());
    CHECK(extrude(Region<3>::empty(), 0, 1).is_empty());
    const Region<1, double> segment(box<1>({0}, {1}));
    CHECK_THROWS_AS(extrude(segment, 0.0, std::numeric_limits<double>::infinity()), NumberError);
}
