// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/resolve.hpp>
//
#include "support/catch.hpp"
#include "support/mesh_parts.hpp"
#include "support/meshes.hpp"
#include "support/region_checker.hpp"

#include <cmath>
#include <string>

using namespace cleave;
using support::block;
using support::inside_out;
using support::together;

namespace {

/// Resolved, with everything that a region promises verified.
template <class T>
Region<3> resolved(const PolygonMesh<T>& mesh, WindingRule rule) {
    Region<3> r = resolve(mesh, rule);
    support::RegionChecker<3>(r).verify();
    return r;
}

/// The volumes by the three rules.
template <class T>
std::array<Rational, 3> volumes(const PolygonMesh<T>& mesh) {
    std::array<Rational, 3> v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = *measure(resolved(mesh, all_winding_rules[i]));
    return v;
}

using V = std::array<Rational, 3>;

}  // namespace

TEST_CASE("resolve: a mesh that does not cross itself comes back as it went in") {
    const Region<3> r = resolved(meshes::cube<double>(0, 2), WindingRule::positive);
    CHECK(r.face_count() == 6);
    CHECK(*measure(r) == 8);
    CHECK(r.surface().is_conforming);
    for (std::uint32_t f = 0; f < 6; ++f) CHECK(r.boundary().faces.faces[f].source == Source{0, f});
    CHECK(equal(resolved(meshes::pentomino(), WindingRule::even_odd), to_region(meshes::pentomino())));
    CHECK(resolve(Mesh(), WindingRule::positive).is_empty());
}

TEST_CASE("resolve: two overlapping cubes") {
    CHECK(volumes(together(meshes::cube<double>(0, 2), meshes::cube<double>(1, 3))) == V{15, 15, 14});
    CHECK(volumes(together(meshes::cube<double>(0, 2), inside_out(meshes::cube<double>(1, 3)))) == V{7, 14, 14});
}

TEST_CASE("resolve: a cube twice, and a cube with its opposite") {
    const Mesh cube = meshes::cube<double>(0, 2);
    CHECK(volumes(together(cube, cube)) == V{8, 8, 0});
    CHECK(volumes(together(cube, inside_out(cube))) == V{0, 0, 0});
    CHECK(volumes(together(together(cube, inside_out(cube)), cube)) == V{8, 8, 8});
    // Different triangulations of the same faces.
    const Mesh other = meshes::cube<double>(-1, 1);
    CHECK(volumes(together(meshes::triangle_cube(), other)) == V{8, 8, 0});
    CHECK(resolved(together(cube, cube), WindingRule::positive).face_count() == 6);
}

TEST_CASE("resolve: inside out") {
    CHECK(volumes(inside_out(meshes::cube<double>(0, 2))) == V{0, 8, 8});
    CHECK(resolved(inside_out(meshes::tetrahedron()), WindingRule::positive).is_empty());
}

TEST_CASE("resolve: nested shells") {
    const Mesh outer = block({0, 0, 0}, {6, 6, 6});
    const Mesh inner = block({1, 1, 1}, {5, 5, 5});
    const Mesh core = block({2, 2, 2}, {4, 4, 4});
    CHECK(volumes(together(outer, inner)) == V{216, 216, 152});  // winding number 2 inside
    CHECK(volumes(together(outer, inside_out(inner))) == V{152, 152, 152});
    CHECK(volumes(together(together(outer, inner), core)) == V{216, 216, 160});
    CHECK(volumes(together(together(outer, inside_out(inner)), core)) == V{160, 160, 160});
    CHECK(volumes(together(together(outer, inside_out(inner)), inside_out(core))) == V{152, 160, 160});
}

TEST_CASE("resolve: an inverted cube that sticks out of the outer one") {
    const Mesh m = together(block({0, 0, 0}, {4, 4, 4}), inside_out(block({2, 1, 1}, {6, 3, 3})));
    CHECK(volumes(m) == V{56, 64, 64});
}

TEST_CASE("resolve: coplanar faces that overlap") {
    // Two boxes on one floor, crossing; two whose sides share a plane, side by side; one on top of another.
    CHECK(volumes(together(block({0, 0, 0}, {3, 3, 2}), block({1, 1, 0}, {5, 2, 3}))) == V{26, 26, 22});
    CHECK(volumes(together(block({0, 0, 0}, {2, 2, 2}), block({2, 1, 0}, {4, 3, 2}))) == V{16, 16, 16});
    CHECK(volumes(together(block({0, 0, 0}, {3, 3, 1}), block({1, 1, 1}, {2, 2, 2}))) == V{10, 10, 10});
    CHECK(volumes(together(block({0, 0, 0}, {3, 3, 1}), inside_out(block({1, 1, 1}, {2, 2, 2})))) == V{9, 10, 10});
    CHECK(volumes(together(block({0, 0, 0}, {3, 3, 1}), inside_out(block({1, 1, 0}, {2, 2, 1})))) == V{8, 8, 8});
}

TEST_CASE("resolve: touching at a corner, along an edge, at a face") {
    const Mesh cube = block({0, 0, 0}, {2, 2, 2});
    CHECK(volumes(together(cube, block({2, 2, 2}, {3, 3, 3}))) == V{9, 9, 9});
    CHECK(volumes(together(cube, block({2, 2, 0}, {3, 3, 2}))) == V{10, 10, 10});
    CHECK(volumes(together(cube, block({2, 0, 0}, {4, 2, 2}))) == V{16, 16, 16});
    CHECK(volumes(together(cube, block({2, 2, 1}, {3, 3, 3}))) == V{10, 10, 10});
    // An apex on the face of another solid, from outside and from inside.
    Mesh apex =
        meshes::mesh({{1, 1, 2}, {3, 1, 4}, {1, 3, 4}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    const Rational volume = *measure(resolved(apex, WindingRule::non_zero));
    CHECK(volumes(together(cube, apex))[1] == 8 + volume);
    for (auto& p : apex.points) p[2] = 4 - p[2];
    CHECK(volumes(together(block({-1, -1, -1}, {4, 4, 2}), inside_out(apex)))[1] == 75);
    CHECK(volumes(together(block({-1, -1, -1}, {4, 4, 2}), apex))[1] == 75 - volume);
}

TEST_CASE("resolve: exact fractions") {
    using Point = std::array<Rational, 3>;
    RationalMesh a = meshes::cube<Rational>(0, 1);
    RationalMesh b = a;
    for (Point& p : b.points)
        for (Rational& x : p) x = x + Rational(1) / 3;
    const Rational common = Rational(8) / 27;
    CHECK(volumes(together(a, b)) == V{Rational(2 - common), Rational(2 - common), Rational(2 - common * 2)});
}

TEST_CASE("resolve: a ring whose cross-section turns inside out half-way") {
    // A triangle carried around the z axis through itself: the surface crosses itself, and is closed and oriented.
    constexpr std::uint32_t n = 16;
    Mesh m;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double t = 2 * 3.141592653589793 * i / n;
        const double size = std::cos(2 * t) + 0.25;  // negative for a part of the way
        for (std::uint32_t k = 0; k < 3; ++k) {
            const double u = 2 * 3.141592653589793 * k / 3 + 0.3;
            const double r = 4 + size * std::cos(u);
            m.points.push_back({std::round(64 * r * std::cos(t)) / 64, std::round(64 * r * std::sin(t)) / 64,
                                std::round(64 * size * std::sin(u)) / 64});
        }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = 3 * i;
        const std::uint32_t b = 3 * ((i + 1) % n);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t l = (k + 1) % 3;
            m.add_face({a + k, b + k, b + l});
            m.add_face({a + k, b + l, a + l});
        }
    }
    CHECK_FALSE(find_self_intersections(m).empty());
    const Region<3> odd = resolved(m, WindingRule::even_odd);
    const Region<3> positive = resolved(m, WindingRule::positive);
    const Region<3> negative = resolved(inside_out(m), WindingRule::positive);
    const Region<3> either = resolved(m, WindingRule::non_zero);
    CHECK(*measure(positive) > 0);
    CHECK(*measure(negative) > 0);
    CHECK(*measure(either) == *measure(positive) + *measure(negative));
    CHECK((positive & negative).is_empty());
    CHECK(equal(either, positive | negative));
    CHECK(*measure(odd) <= *measure(either));
}

TEST_CASE("resolve: a flat face whose outline crosses itself, and one that is not flat") {
    // A prism over a bow tie: its two halves face opposite ways.
    const Mesh tie =
        meshes::mesh({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, {2, 2, 1}, {2, 0, 1}, {0, 2, 1}},
                     {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
    CHECK(volumes(tie) == V{1, 2, 2});
    Mesh bent = meshes::cube<double>(0, 2);
    bent.points[7][2] = 3;
    CHECK(volumes(bent)[0] == *measure(to_region(bent)));
}

TEST_CASE("resolve: what is not closed is refused, in the strict mode also what is not flat") {
    Mesh open = meshes::without_face(meshes::cube<double>(0, 2), 3);
    MeshReport report;
    ResolveOptions options;
    options.report = &report;
    CHECK_THROWS_AS(resolve(open, WindingRule::positive, options), MeshError);
    CHECK(report.open_edges.size() == 4);
    Mesh bent = meshes::cube<double>(0, 2);
    bent.points[7][2] = 3;
    options.strictness = Strictness::strict;
    CHECK_THROWS_AS(resolve(bent, WindingRule::positive, options), MeshError);
}

TEST_CASE("resolve: stops on request") {
    std::stop_source stop;
    stop.request_stop();
    ProgressReporter progress(stop.get_token());
    ResolveOptions options;
    options.progress = &progress;
    CHECK_THROWS_AS(resolve(meshes::cube<double>(0, 2), WindingRule::positive, options), Cancelled);
}

TEST_CASE("resolve: random solids in one mesh are what Boolean functions of them are") {
    support::Dice dice(11);
    for (std::size_t n = 0; n < scaled(120); ++n) {
        const support::MeshParts<double> parts = support::draw_parts(dice, 4, dice.between(2, 5));
        const Mesh mesh = parts.mesh();
        for (const WindingRule rule : all_winding_rules) {
            CAPTURE(n, to_text(rule));
            const Region<3> found = resolved(mesh, rule);
            CHECK(equal(found, parts.expected(rule)));
        }
    }
}

TEST_CASE("resolve: random solids at points of a grid have the parts' winding numbers") {
    support::Dice dice(12);
    for (std::size_t n = 0; n < scaled(30); ++n) {
        const support::MeshParts<double> parts = support::draw_parts(dice, 5, 4);
        std::vector<support::ExactRegion<3>> solids;
        for (const Mesh& solid : parts.solids) solids.emplace_back(to_region(solid));
        for (const WindingRule rule : all_winding_rules) {
            const support::ExactRegion<3> found(resolve(parts.mesh(), rule));
            for (int i = 0; i < 125; ++i) {
                const support::Coordinates<3> p{support::rational(2 * (i % 5) - 1, 3),
                                                support::rational(3 * (i / 5 % 5) - 1, 4),
                                                support::rational(4 * (i / 25) - 1, 5)};
                int winding = 0;
                bool on_boundary = false;
                for (std::size_t k = 0; k < solids.size(); ++k) {
                    const support::Where where = solids[k].locate(p);
                    on_boundary = on_boundary || where == support::Where::boundary;
                    if (where == support::Where::inside) winding += parts.signs[k];
                }
                if (on_boundary) continue;
                CAPTURE(n, i, to_text(rule), winding);
                CHECK((found.locate(p) == support::Where::inside) == is_inside(rule, winding));
            }
        }
    }
}

namespace {

/// Coordinates times 60, so that points between the grid's are integers too.
using Grid = std::array<std::int64_t, 3>;

std::int64_t det(const Grid& a, const Grid& b, const Grid& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// How often the triangles run around p, by the crossings of a ray; nothing where it meets an edge or p is on one.
std::optional<int> winding_number(const std::vector<std::array<Grid, 3>>& triangles, const Grid& p) {
    constexpr Grid ray{1009, 10007, 100003};
    int winding = 0;
    for (const auto& t : triangles) {
        std::array<Grid, 3> d;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t x = 0; x < 3; ++x) d[i][x] = t[i][x] - p[x];
        if (det(d[0], d[1], d[2]) == 0) {  // p is on its plane; a triangle without area is on every plane
            const Grid u{t[1][0] - t[0][0], t[1][1] - t[0][1], t[1][2] - t[0][2]};
            const Grid v{t[2][0] - t[0][0], t[2][1] - t[0][1], t[2][2] - t[0][2]};
            if (det(u, v, {1, 0, 0}) == 0 && det(u, v, {0, 1, 0}) == 0 && det(u, v, {0, 0, 1}) == 0) continue;
            return std::nullopt;
        }
        int left = 0;
        int right = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int64_t s = det(ray, d[i], d[(i + 1) % 3]);
            if (s == 0) return std::nullopt;
            ++(s > 0 ? left : right);
        }
        if (left != 0 && right != 0) continue;
        // Left all round: the ray leaves through the plus side of the triangle's plane, if it is ahead.
        const bool ahead = (det(d[0], d[1], d[2]) > 0) == (left != 0);
        if (ahead) winding += left != 0 ? 1 : -1;
    }
    return winding;
}

}  // namespace

TEST_CASE("resolve: random closed surfaces that cross themselves anyhow") {
    // The octahedron's and the icosahedron's triangles on corners drawn from small integers: many triangles have no
    // area, and corners coincide.
    const std::vector<std::array<std::uint32_t, 3>> octahedron{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                               {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    const std::vector<std::array<std::uint32_t, 3>> icosahedron{
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    support::Dice dice(14);
    std::size_t compared = 0;
    for (std::size_t n = 0; n < scaled(100); ++n) {
        const auto& faces = n % 2 == 0 ? octahedron : icosahedron;
        const int range = dice.between(1, 6);
        Mesh m;
        for (int i = 0; i < 12; ++i)
            m.points.push_back(
                {double(dice.below(range + 1)), double(dice.below(range + 1)), double(dice.below(range + 1))});
        for (const auto& f : faces) m.add_face(f);
        std::vector<std::array<Grid, 3>> triangles;
        for (std::size_t f = 0; f < m.face_count(); ++f) {
            auto& t = triangles.emplace_back();
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t x = 0; x < 3; ++x) t[c][x] = 60 * std::int64_t(m.points[m.face(f)[c]][x]);
        }
        for (const WindingRule rule : all_winding_rules) {
            CAPTURE(n, to_text(rule));
            const support::ExactRegion<3> found(resolved(m, rule));
            for (int i = 0; i < 40; ++i) {
                const Grid p{dice.below(60 * range), dice.below(60 * range), dice.below(60 * range)};
                const auto winding = winding_number(triangles, p);
                if (!winding) continue;
                ++compared;
                const support::Coordinates<3> q{support::rational(p[0], 60), support::rational(p[1], 60),
                                                support::rational(p[2], 60)};
                CHECK((found.locate(q) == support::Where::inside) == is_inside(rule, *winding));
            }
        }
    }
    CHECK(compared > scaled(8000));
}

TEST_CASE("resolve: random fractions") {
    support::Dice dice(13);
    for (std::size_t n = 0; n < scaled(15); ++n) {
        support::MeshParts<Rational> parts = support::draw_parts<Rational>(dice, 3, 4);
        for (std::size_t k = 0; k < parts.solids.size(); ++k)
            for (auto& p : parts.solids[k].points)
                for (Rational& x : p) x = x / int(3 + k % 2);
        for (const WindingRule rule : all_winding_rules) {
            CAPTURE(n, to_text(rule));
            CHECK(equal(resolved(parts.mesh(), rule), parts.expected(rule)));
        }
    }
}
