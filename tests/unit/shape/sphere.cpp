// SPDX-License-Identifier: Apache-2.0
#include <cleave/shape/sphere.hpp>

#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <cleave/query/measure.hpp>

using namespace cleave;
using namespace support;

TEST_CASE("circle points: exactly on the circle, in order, a quarter turn maps them to themselves") {
    for (const std::uint32_t count : {4U, 8U, 12U, 20U, 64U, 1000U}) {
        const std::vector<RationalPoint<2>> points = circle_points(count);
        REQUIRE(points.size() == count);
        CHECK(points.front() == RationalPoint<2>{1, 0});
        for (std::size_t i = 0; i < count; ++i) {
            const RationalPoint<2>& p = points[i];
            const RationalPoint<2>& q = points[(i + 1) % count];
            CHECK(Rational(p[0] * p[0] + p[1] * p[1]) == 1);
            CHECK(Rational(p[0] * q[1] - p[1] * q[0]) > 0);
            CHECK(points[(i + count / 4) % count] == RationalPoint<2>{Rational(-p[1]), p[0]});
            // No step is longer than one and a quarter equal ones: with chord c and angle a, c < a = 6.284 / count.
            const Rational dx = q[0] - p[0];
            const Rational dy = q[1] - p[1];
            const Rational longest = Rational(1571, 250) * Rational(5, 4) / int(count);
            CHECK(Rational(dx * dx + dy * dy) < Rational(longest * longest));
        }
    }
    CHECK_THROWS_AS(circle_points(6), ContractViolation);
    CHECK_THROWS_AS(circle_points(0), ContractViolation);
}

TEST_CASE("disc: convex, with its corners on the circle") {
    const Region<2> d = verified(disc({1, 2}, 3, 24));
    CHECK(d.face_count() == 24);
    const ExactRegion<2> exact(d);
    for (const Coordinates<2>& p : exact.points()) {
        const Coordinates<2> r = subtract(p, Coordinates<2>{1, 2});
        CHECK(dot(r, r) == 9);
    }
    CHECK(equal_sets(disc({0, 0}, 1, 4), polygon<Rational>({{1, 0}, {0, 1}, {-1, 0}, {0, -1}})));
    CHECK(disc({0, 0}, 1, 5).face_count() == 8);
    CHECK(equal_sets(disc({0, 0}, -1, 8), disc({0, 0}, 1, 8)));
    CHECK(disc({0, 0}, 0).is_empty());
}

TEST_CASE("sphere: convex, with its corners on the sphere and plane faces") {
    const SphereOptions options{12, 6};
    const Region<3> s = verified(sphere({1, 2, 3}, Rational(5, 2), options));
    CHECK(s.face_count() == 12 * 6);
    const ExactRegion<3> exact(s);
    CHECK(exact.points().size() == 12 * 5 + 2);
    CHECK(exact.plane_count() == 12 * 6);
    for (const Coordinates<3>& p : exact.points()) {
        const Coordinates<3> r = subtract(p, Coordinates<3>{1, 2, 3});
        CHECK(dot(r, r) == Rational(25, 4));
    }
    for (const auto& f : exact.faces())
        for (const Coordinates<3>& p : exact.points()) CHECK(value<3>(f.plane, p) <= 0);
    CHECK(exact.centroid() == Coordinates<3>{1, 2, 3});
}

TEST_CASE("sphere: the coarsest one is an octahedron") {
    const Region<3> s = verified(sphere({0, 0, 0}, 1, {1, 1}));
    CHECK(s.face_count() == 8);
    CHECK(ExactRegion<3>(s).measure() == Rational(4, 3));
}

TEST_CASE("sphere: finer ones approach the ball's volume from below") {
    Rational before(0);
    for (const std::uint32_t stacks : {2U, 4U, 8U, 16U}) {
        const Rational volume = *measure(sphere({0, 0, 0}, 1, {2 * stacks, stacks}));
        CHECK(volume > before);
        CHECK(volume < Rational(2618, 625));  // 4/3 pi = 4.18879...
        before = volume;
    }
    CHECK(before > Rational(41, 10));
}

TEST_CASE("sphere: a number of faces to start from") {
    CHECK(SphereOptions::with_faces(1).stacks == 2);
    for (const std::uint32_t count : {8U, 100U, 512U, 5000U}) {
        const SphereOptions o = SphereOptions::with_faces(count);
        CHECK(o.slices * o.stacks >= count);
        CHECK(2 * (o.stacks - 2) * (o.stacks - 2) < count);
    }
    CHECK(sphere({0, 0, 0}, 1, SphereOptions::with_faces(500)).face_count() == 512);
}

TEST_CASE("sphere: without radius it is empty, a negative one counts as its absolute value") {
    CHECK(sphere({0, 0, 0}, 0).is_empty());
    CHECK(equal_sets(sphere({0, 0, 0}, -2, {8, 4}), sphere({0, 0, 0}, 2, {8, 4})));
}

TEST_CASE("sphere: operations on a ball and its mirror image, its quarter turn, itself") {
    const Region<3> a = sphere({0, 0, 0}, 1, {8, 6});
    const Region<3> b = sphere({Rational(1, 2), 0, 0}, 1, {8, 6});
    const Rational common = ExactRegion<3>(checked(Operation::intersection, a, b)).measure();
    CHECK(Rational(ExactRegion<3>(checked(Operation::union_, a, b)).measure() + common) ==
          Rational(2 * ExactRegion<3>(a).measure()));
    CHECK(checked(Operation::difference, a, a).is_empty());
    CHECK(checked(Operation::union_, a, a).face_count() == a.face_count());
}
