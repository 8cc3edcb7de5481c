// SPDX-License-Identifier: Apache-2.0
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <limits>

using namespace cleave;
using namespace support;

TEST_CASE("box: an interval, a rectangle, a cuboid") {
    const Region<1> i = verified(box<1>({-1}, {3}));
    CHECK(i.face_count() == 2);
    CHECK(ExactRegion<1>(i).measure() == 4);
    const Region<2> r = verified(box<2>({0, 1}, {2, 4}));
    CHECK(r.face_count() == 4);
    CHECK(ExactRegion<2>(r).measure() == 6);
    CHECK(ExactRegion<2>(r).boundary_measure() == 10);
    const Region<3> c = verified(box<3>({0, 0, 0}, {2, 2, Rational(1, 3)}));
    CHECK(c.face_count() == 6);
    CHECK(ExactRegion<3>(c).measure() == Rational(4, 3));
    CHECK(c.boundary().points.size() == 8);
}

TEST_CASE("box: faces come in the order -x, +x, -y, +y, -z, +z") {
    const ExactRegion<3> c(box<3>({0, 0, 0}, {1, 1, 1}));
    for (std::size_t f = 0; f < 6; ++f) {
        Coordinates<3> expected{0, 0, 0};
        expected[f / 2] = f % 2 == 0 ? -1 : 1;
        CHECK(normal<3>(c.faces()[f].plane) == expected);
    }
}

TEST_CASE("box: corners in any order") {
    CHECK(equal_sets(box<1>({3}, {-1}), box<1>({-1}, {3})));
    CHECK(equal_sets(box<2>({2, 1}, {0, 4}), box<2>({0, 1}, {2, 4})));
    CHECK(equal_sets(box<3>({2, 0, 5}, {0, 3, 1}), box<3>({0, 0, 1}, {2, 3, 5})));
}

TEST_CASE("box: without extent along an axis it is empty") {
    CHECK(box<1>({2}, {2}).is_empty());
    CHECK(box<2>({0, 1}, {2, 1}).is_empty());
    CHECK(box<3>({0, 0, 0}, {0, 1, 1}).is_empty());
    CHECK(box<3>({1, 2, 3}, {1, 2, 3}).is_empty());
}

TEST_CASE("box: corners of other number types") {
    const Region<3, double> d = box<3>(std::array{0.1, 0.0, 0.0}, std::array{0.25, 1.0, 1.0});
    const Rational tenth = number_traits<Rational>::from_double(0.1);
    CHECK(ExactRegion<3>(d).measure() == Rational(Rational(1, 4) - tenth));
    const Region<2, Integer> n = box<2>(std::array{Integer(0), Integer(0)}, std::array{Integer(3), Integer(2)});
    CHECK(ExactRegion<2>(n).measure() == 6);
    CHECK(equal_sets(Region<2>(n), box<2>({0, 0}, {3, 2})));
}

TEST_CASE("box: infinite coordinates are refused") {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS((box<3>(std::array{0.0, 0.0, 0.0}, std::array{1.0, infinity, 1.0})), NumberError);
    CHECK_THROWS_AS((box<1>(std::array{nan}, std::array{1.0})), NumberError);
}
