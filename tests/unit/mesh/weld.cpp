// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/weld.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/property.hpp"

#include <cmath>
#include <limits>
#include <map>

using namespace cleave;
using support::property;

TEST_CASE("weld: equal points become the first of them, near ones stay apart") {
    const double near = std::nextafter(1.0, 2.0);
    const std::vector<std::array<double, 3>> points{{1, 2, 3}, {near, 2, 3}, {1, 2, 3}, {3, 2, 1}, {near, 2, 3}};
    REQUIRE(first_equal_points<double>(points) == std::vector<std::uint32_t>{0, 1, 0, 3, 1});
}

TEST_CASE("weld: minus zero is zero") {
    const std::vector<std::array<double, 3>> points{{0.0, 1, -0.0}, {-0.0, 1, 0.0}, {-0.0, 1, -0.0}};
    REQUIRE(first_equal_points<double>(points) == std::vector<std::uint32_t>{0, 0, 0});
}

TEST_CASE("weld: points that are not finite stand for themselves, and many cost no more than few") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::array<double, 3>> points(200000, {nan, 0, 0});
    const std::vector<std::uint32_t> first = first_equal_points<double>(points);
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) FAIL("point " << i << " was merged");
    }
    REQUIRE(first.size() == points.size());
}

TEST_CASE("weld: rationals that round to the same double are different points") {
    const Rational third = Rational(1) / 3;
    const Rational close = third + Rational(1) / Rational(1e40);
    REQUIRE(to_double(third) == to_double(close));
    const std::vector<std::array<Rational, 3>> points{
        {third, 0, 0}, {close, 0, 0}, {Rational(2) / 6, 0, 0}, {close, 0, 0}};
    REQUIRE(first_equal_points<Rational>(points) == std::vector<std::uint32_t>{0, 1, 0, 1});
}

TEST_CASE("weld: a soup of faces becomes the mesh it came from") {
    const Mesh cube = meshes::cube();
    const Mesh soup = meshes::soup(cube);
    REQUIRE(soup.points.size() == 24);
    const Mesh welded = weld(soup);
    REQUIRE(welded.points.size() == 8);
    REQUIRE(welded.first == soup.first);
    for (std::size_t i = 0; i < welded.corners.size(); ++i) {
        REQUIRE(welded.points[welded.corners[i]] == soup.points[soup.corners[i]]);
    }
    // Nothing to merge: nothing changes.
    REQUIRE(weld(welded) == welded);
}

TEST_CASE("weld: agrees with an ordered map on random points") {
    property("the least index of an equal point", [](const std::vector<std::array<signed char, 3>>& raw) {
        std::vector<std::array<double, 3>> points;
        for (const auto& p : raw) points.push_back({double(p[0] % 3), double(p[1] % 3), double(p[2] % 3)});
        std::map<std::array<double, 3>, std::uint32_t> seen;
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < points.size(); ++i)
            expected.push_back(seen.try_emplace(points[i], i).first->second);
        RC_ASSERT(first_equal_points<double>(points) == expected);
    });
}

TEST_CASE("weld: points are surely distinct only where no two are equal") {
    property("random points, and the same with one of them once more", [](const std::vector<std::array<int, 3>>& raw) {
        std::vector<std::array<double, 3>> points;
        for (const auto& p : raw) points.push_back({p[0] % 9 / 2.0, p[1] % 9 / 2.0, p[2] % 9 / 2.0});
        std::map<std::array<double, 3>, int> seen;
        for (const auto& p : points) ++seen[{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0}];
        if (seen.size() < points.size()) RC_ASSERT(!are_surely_distinct<double>(points));
        // Hashes of 44 bits: none of these few is that of another.
        if (seen.size() == points.size()) RC_ASSERT(are_surely_distinct<double>(points));
        if (points.empty()) return;
        std::array<double, 3> again = points[points.size() / 2];
        for (double& x : again) x = x == 0 ? -x : x;
        points.push_back(again);
        RC_ASSERT(!are_surely_distinct<double>(points));
    });
}
