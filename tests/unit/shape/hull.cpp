// SPDX-License-Identifier: Apache-2.0
#include <cleave/shape/hull.hpp>

#include "support/catch.hpp"
#include "support/region_generators.hpp"

#include <algorithm>

using namespace cleave;
using namespace support;

TEST_CASE("convex hull: of numbers, from the least to the largest") {
    CHECK(equal_sets(verified(convex_hull<1>({{3}, {-1}, {2}, {3}})), box<1>({-1}, {3})));
    CHECK(convex_hull<1>({{2}, {2}}).is_empty());
    CHECK(convex_hull<1>(std::vector<Coordinates<1>>()).is_empty());
}

TEST_CASE("convex hull: in the plane only extreme points become corners") {
    const Region<2> square = verified(convex_hull<2>({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}, {1, 2}}));
    CHECK(square.face_count() == 4);
    CHECK(equal_sets(square, box<2>({0, 0}, {2, 2})));
    CHECK(verified(convex_hull<2>({{0, 0}, {4, 0}, {2, 1}, {0, 3}})).face_count() == 3);
    CHECK(convex_hull<2>({{0, 0}, {1, 1}, {5, 5}, {3, 3}}).is_empty());
    CHECK(convex_hull<2>({{0, 0}, {1, 1}}).is_empty());
}

TEST_CASE("convex hull: coplanar points give one polygon") {
    std::vector<Coordinates<3>> grid;
    for (int i = 0; i < 27; ++i) grid.push_back({i % 3, i / 3 % 3, i / 9});
    for (int rotation = 0; rotation < 5; ++rotation) {
        std::rotate(grid.begin(), grid.begin() + 7, grid.end());
        const Region<3> cube = verified(convex_hull<3>(grid));
        CHECK(cube.face_count() == 6);
        CHECK(cube.boundary().points.size() == 8);
        CHECK(equal_sets(cube, box<3>({0, 0, 0}, {2, 2, 2})));
    }
    const Region<3> octahedron =
        verified(convex_hull<3>({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}}));
    CHECK(octahedron.face_count() == 8);
    CHECK(ExactRegion<3>(octahedron).measure() == Rational(4, 3));
}

TEST_CASE("convex hull: points in one plane have no interior") {
    CHECK(convex_hull<3>({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {5, 5, 1}}).is_empty());
    CHECK(convex_hull<3>({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}).is_empty());
    CHECK(convex_hull<3>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).is_empty());
    CHECK(convex_hull<3>({{1, 2, 3}}).is_empty());
}

namespace {

/// At most this many points with coordinates 0 .. 4.
template <int D>
std::vector<std::array<int, std::size_t(D)>> draw_points(std::size_t most) {
    std::vector<std::array<int, std::size_t(D)>> points(draw_index(most + 1));
    const std::vector<int> drawn = draw_crowded_ints(points.size() * std::size_t(D), 0, 5);
    auto next = drawn.begin();
    for (auto& p : points)
        for (int& x : p) x = *next++;
    return points;
}

/// Whether every point is in the hull, every corner of the hull is a point, and no corner can be spared.
template <int D>
void check_hull(const std::vector<std::array<int, std::size_t(D)>>& drawn) {
    std::vector<Coordinates<D>> points;
    for (const auto& x : drawn) {
        points.emplace_back();
        for (std::size_t i = 0; i < std::size_t(D); ++i) points.back()[i] = x[i];
    }
    const Region<D> hull = verified(convex_hull<D>(points));
    const ExactRegion<D> exact(hull);
    for (const auto& f : exact.faces())
        for (const Coordinates<D>& p : points) RC_ASSERT((value<D>(f.plane, p) <= 0));  // convex, and contains them
    for (const Coordinates<D>& corner : exact.points()) RC_ASSERT(std::count(points.begin(), points.end(), corner) > 0);
    RC_ASSERT(exact.plane_count() == hull.face_count());
    // It is empty only if every simplex of the points is.
    bool flat = true;
    std::array<Coordinates<D>, std::size_t(D) + 1> chosen;
    std::vector<std::size_t> pick(1 + std::size_t(D), 0);
    for (bool more = !points.empty(); more && flat;) {
        for (std::size_t i = 0; i < pick.size(); ++i) chosen[i] = points[pick[i]];
        flat = orientation<D>(chosen) == 0;
        more = false;
        for (std::size_t i = 0; i < pick.size() && !more; ++i) {
            more = ++pick[i] < points.size();
            if (!more) pick[i] = 0;
        }
    }
    RC_ASSERT(hull.is_empty() == flat);
}

}  // namespace

TEST_CASE("convex hull: of random points with small integer coordinates") {
    law("dimension 2", 200, [] { check_hull<2>(draw_points<2>(8)); });
    law("dimension 3", 100, [] { check_hull<3>(draw_points<3>(10)); });
}
