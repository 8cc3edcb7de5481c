// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/interning.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

#include <cleave/geometry/cross_point.hpp>
#include <cleave/geometry/relation.hpp>

#include <array>
#include <vector>

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("interning: coincident planes share all but the orientation bit", "", ExactTypes) {
    using N = TestType;
    InternedPlanes<3, N> planes;
    const PlaneId a = planes.intern(make_plane<N>(2, 0, 0, -2));
    const PlaneId b = planes.intern(make_plane<N>(0.5, 0, 0, -0.5));
    const PlaneId c = planes.intern(make_plane<N>(-3, 0, 0, 3));
    const PlaneId d = planes.intern(make_plane<N>(1, 0, 0, 1));
    CHECK(a == 0);
    CHECK(b == a);
    CHECK(c == flipped(a));
    CHECK(unoriented(d) == 1);
    CHECK(planes.size() == 2);
    CHECK(planes.plane(a) == make_plane<N>(1, 0, 0, -1));
    CHECK(planes.plane(c) == make_plane<N>(-1, 0, 0, 1));
    CHECK_THROWS_AS(planes.plane(4), ContractViolation);
}

TEST_CASE("interning: A-T16, a point is one point whichever of its planes made it") {
    // The apex of a square pyramid is on four walls: four triples of planes, one point.
    const std::array<Plane<3, Integer>, 4> walls{make_plane<Integer>(2, 0, 1, -2), make_plane<Integer>(-2, 0, 1, -2),
                                                 make_plane<Integer>(0, 2, 1, -2), make_plane<Integer>(0, -2, 1, -2)};
    InternedPoints<3, Integer> points;
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        std::array<Plane<3, Integer>, 3> three;
        for (std::size_t i = 0, k = 0; i < 4; ++i) {
            if (i != left_out) three[k++] = walls[i];
        }
        const auto apex = meet(three);
        REQUIRE(apex);
        CHECK(points.intern(*apex) == 0);
    }
    CHECK(points.size() == 1);
    CHECK(points.point(0) == make_point<Integer>(0, 0, 2));
    CHECK(points.intern(make_point<Integer>(0, 0, -2)) == 1);
}

TEST_CASE("interning: ids agree exactly where values do") {
    property("planes in D = 2", [](const std::vector<Plane<2, Rational>>& planes) {
        InternedPlanes<2, Rational> table;
        std::vector<PlaneId> ids;
        for (const auto& h : planes) ids.push_back(table.intern(h));
        for (std::size_t i = 0; i < planes.size(); ++i) {
            RC_ASSERT(table.plane(ids[i]) == planes[i]);
            for (std::size_t j = 0; j < planes.size(); ++j) {
                RC_ASSERT((ids[i] == ids[j]) == (planes[i] == planes[j]));
                RC_ASSERT((unoriented(ids[i]) == unoriented(ids[j])) == is_coincident(relation(planes[i], planes[j])));
            }
        }
    });
    property("points in D = 4", [](const std::vector<Point<4, Integer>>& points) {
        InternedPoints<4, Integer> table;
        std::vector<PointId> ids;
        for (const auto& p : points) ids.push_back(table.intern(p));
        for (std::size_t i = 0; i < points.size(); ++i) {
            RC_ASSERT(table.point(ids[i]) == points[i]);
            for (std::size_t j = 0; j < points.size(); ++j) {
                RC_ASSERT((ids[i] == ids[j]) == (points[i] == points[j]));
            }
        }
    });
}

TEST_CASE("interning: a vector that was never interned is not found") {
    InternedVectors<2> table;
    CHECK_FALSE(table.find({1, 2}));
    CHECK(table.intern({1, 2}) == 0);
    CHECK(table.intern({2, 1}) == 1);
    CHECK(table.find({1, 2}) == 0U);
    CHECK_FALSE(table.find({-1, 2}));
    CHECK(table.size() == 2);
}
