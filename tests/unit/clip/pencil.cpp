// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/pencil.hpp>

#include "support/catch.hpp"
#include "support/property.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

using support::property;

namespace {

using Plane2 = std::array<std::int64_t, 3>;
using Plane3 = std::array<std::int64_t, 4>;
using Point3 = std::array<std::int64_t, 3>;

std::int64_t value(const Plane3& h, const Point3& p) {
    return h[0] * p[0] + h[1] * p[1] + h[2] * p[2] + h[3];
}

/// The plane through three points.
Plane3 through(const Point3& a, const Point3& b, const Point3& c) {
    const Point3 u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Point3 v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point3 n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    return {n[0], n[1], n[2], -(n[0] * a[0] + n[1] * a[1] + n[2] * a[2])};
}

template <class Coefficients>
std::vector<Coefficients> all_through(const Coefficients& g, const Coefficients& h) {
    return cleave::planes_through(g, h, [](const Coefficients& c) { return c; });
}

Point3 draw_point() {
    const std::vector<int> x = support::draw_ints(3, -9, 10);
    return {x[0], x[1], x[2]};
}

}  // namespace

TEST_CASE("pencil: a turned plane contains the line and the direction of its axis") {
    property("for planes through two points", [] {
        const Point3 a = draw_point();
        const Point3 b = draw_point();
        const Plane3 g = through(a, b, draw_point());
        const Plane3 h = through(a, b, draw_point());
        RC_PRE(g[0] != 0 || g[1] != 0 || g[2] != 0);
        RC_PRE(h[0] != 0 || h[1] != 0 || h[2] != 0);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::optional<Plane3> turned = cleave::turned_plane(g, h, i);
            const Point3 n{g[1] * h[2] - g[2] * h[1], g[2] * h[0] - g[0] * h[2], g[0] * h[1] - g[1] * h[0]};
            const bool parallel = n == Point3{0, 0, 0};
            RC_ASSERT(turned.has_value() == (!parallel && g[i] != 0 && h[i] != 0));
            if (!turned) continue;
            RC_ASSERT((*turned)[i] == 0);
            RC_ASSERT(value(*turned, a) == 0);
            RC_ASSERT(value(*turned, b) == 0);
        }
    });
}

TEST_CASE("pencil: two planes of the cube's corner give no new plane, two slanted ones give three") {
    CHECK(all_through(Plane3{1, 0, 0, 0}, Plane3{0, 1, 0, 0}).empty());
    const std::vector<Plane3> planes = all_through(Plane3{1, 1, 1, 0}, Plane3{1, 2, -1, 3});
    CHECK(planes == std::vector<Plane3>{{0, -1, 2, -3}, {1, 0, 3, -3}, {-2, -3, 0, -3}});
}

TEST_CASE("pencil: parallel and equal planes have no line to turn about") {
    CHECK(all_through(Plane3{1, 2, 3, 4}, Plane3{2, 4, 6, 5}).empty());
    CHECK(all_through(Plane3{1, 2, 3, 4}, Plane3{-1, -2, -3, -4}).empty());
}

TEST_CASE("pencil: in the plane the line is a point, and the turned lines are the axis-parallel ones through it") {
    // x + y = 3 and x - y = 1 meet in (2, 1).
    const std::vector<Plane2> lines = all_through(Plane2{1, 1, -3}, Plane2{1, -1, -1});
    CHECK(lines == std::vector<Plane2>{{0, 2, -2}, {-2, 0, 4}});
}
