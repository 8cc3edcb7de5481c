// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/edge_balance.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/property.hpp"

using namespace cleave;
using support::property;

TEST_CASE("edge_balance: a line has one hash, whichever of its points name it") {
    property("for doubles and rationals", [] {
        std::array<int, 3> p, d;
        for (int& x : p) x = support::draw_int(-9, 10);
        for (int& x : d) x = support::draw_int(-9, 10);
        RC_PRE(d[0] != 0 || d[1] != 0 || d[2] != 0);
        const auto at = [&](int t) {
            return std::array<double, 3>{p[0] / 4.0 + d[0] * t / 8.0, p[1] / 4.0 + d[1] * t / 8.0,
                                         p[2] / 4.0 + d[2] * t / 8.0};
        };
        const auto exactly_at = [&](int t) {
            std::array<Rational, 3> q;
            for (std::size_t x = 0; x < 3; ++x) q[x] = Rational(p[x]) / 3 + Rational(d[x] * t) / 7;
            return q;
        };
        const int s = support::draw_int(-5, 6), t = support::draw_int(1, 6), u = support::draw_int(6, 20);
        const auto hash = cleave::detail::line_hash(at(0), at(1));
        RC_ASSERT(cleave::detail::line_hash(at(s), at(s + t)) == hash);
        RC_ASSERT(cleave::detail::line_hash(at(u), at(s)) == hash);
        const auto exact_hash = cleave::detail::line_hash(exactly_at(0), exactly_at(1));
        RC_ASSERT(cleave::detail::line_hash(exactly_at(u), exactly_at(s)) == exact_hash);
        // A parallel line is another line.
        auto a = at(0), b = at(1);
        const std::size_t axis = d[0] != 0 ? 1 : 0;
        a[axis] += 1;
        b[axis] += 1;
        RC_ASSERT(cleave::detail::line_hash(a, b) != hash);
    });
}

TEST_CASE("edge_balance: a point with very many edges") {
    // A double cone: both apexes have an edge to every point of the rim.
    constexpr std::uint32_t rim = 20000;
    Mesh mesh;
    mesh.points = {{0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t i = 0; i < rim; ++i) mesh.points.push_back({double(i), double(i) * i, 0});
    for (std::uint32_t i = 0; i < rim; ++i) {
        const std::uint32_t a = 2 + i, b = 2 + (i + 1) % rim;
        mesh.add_face({0, a, b});
        mesh.add_face({1, b, a});
    }
    MeshReport report;
    report.point_count = mesh.point_count();
    check_edges(mesh, report);
    REQUIRE(report.is_closed());
    REQUIRE(report.t_junctions.empty());
    report = MeshReport{};
    check_edges(meshes::without_face(mesh, 777), report);
    REQUIRE(report.open_edges.size() == 3);
}

TEST_CASE("edge_balance: an open sheet of many faces lists its rim") {
    // A grid of triangles: the inner edges cancel, the rim's do not, not even along the lines of its sides.
    constexpr std::uint32_t n = 100;
    Mesh mesh;
    for (std::uint32_t y = 0; y <= n; ++y) {
        for (std::uint32_t x = 0; x <= n; ++x) mesh.points.push_back({x * 0.1, y * 0.1, 0.3});
    }
    for (std::uint32_t y = 0; y < n; ++y) {
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = b + n, d = c + 1;
            mesh.add_face({a, b, d});
            mesh.add_face({a, d, c});
        }
    }
    MeshReport report;
    check_edges(mesh, report);
    REQUIRE(report.open_edges.size() == 4 * n);
    REQUIRE(report.t_junctions.empty());
    REQUIRE(std::is_sorted(report.open_edges.begin(), report.open_edges.end(), [](const auto& a, const auto& b) {
        return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    }));
    // As a soup the same edges are open.
    MeshReport loose;
    check_edges(meshes::soup(mesh), loose);
    REQUIRE(loose.open_edges.size() == 4 * n);
}
