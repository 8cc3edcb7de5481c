// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/self_intersections.hpp>
//
#include <cleave/mesh/to_region.hpp>

#include "support/catch.hpp"
#include "support/mesh_parts.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <optional>
#include <string>

using namespace cleave;
using support::block;
using support::Dice;
using support::together;
using Kind = SelfContactKind;

namespace {

template <class T>
std::vector<SelfContact> contacts(const PolygonMesh<T>& mesh) {
    return find_self_intersections(mesh, {true, nullptr});
}

template <class T>
std::size_t count(const PolygonMesh<T>& mesh, Kind kind) {
    const std::vector<SelfContact> all = contacts(mesh);
    return std::size_t(std::count_if(all.begin(), all.end(), [&](const SelfContact& c) { return c.kind == kind; }));
}

/// Two triangles on corners of their own.
Mesh pair(std::array<std::array<double, 3>, 3> a, std::array<std::array<double, 3>, 3> b) {
    Mesh m;
    m.points.insert(m.points.end(), a.begin(), a.end());
    m.points.insert(m.points.end(), b.begin(), b.end());
    m.add_face({0, 1, 2});
    m.add_face({3, 4, 5});
    return m;
}

std::optional<Kind> meet(std::array<std::array<double, 3>, 3> a, std::array<std::array<double, 3>, 3> b) {
    std::optional<Kind> found;
    // However the corners are named and the triangles are ordered; and in exact fractions.
    for (int i = 0; i < 3; ++i) {
        std::rotate(a.begin(), a.begin() + 1, a.end());
        for (int j = 0; j < 3; ++j) {
            std::rotate(b.begin(), b.begin() + 1, b.end());
            for (const bool mirrored : {false, true}) {
                if (mirrored) std::swap(b[0], b[1]);
                for (const Mesh& m : {pair(a, b), pair(b, a)}) {
                    RationalMesh exact;
                    exact.corners = m.corners;
                    exact.first = m.first;
                    for (const auto& p : m.points)
                        exact.points.push_back({Rational(p[0]) / 3, Rational(p[1]) / 3, Rational(p[2]) / 3});
                    const auto list = contacts(m);
                    CHECK(list == contacts(exact));
                    REQUIRE(list.size() <= 1);
                    const std::optional<Kind> kind = list.empty() ? std::optional<Kind>() : list.front().kind;
                    if (i + j > 0 || mirrored) CHECK(kind == found);
                    found = kind;
                }
                if (mirrored) std::swap(b[0], b[1]);
            }
        }
    }
    return found;
}

constexpr std::array<std::array<double, 3>, 3> ground{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

using Vec = std::array<Rational, 3>;

Vec minus(const Vec& a, const Vec& b) {
    return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2])};
}
Rational det(const Vec& a, const Vec& b, const Vec& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}
Vec cross(const Vec& a, const Vec& b) {
    return {Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
            Rational(a[0] * b[1] - a[1] * b[0])};
}
Rational dot(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

using Triangle = std::array<Vec, 3>;

/// The part of a convex polygon on the side h(x) <= 0.
template <class Value>
std::vector<Vec> clip(const std::vector<Vec>& polygon, Value&& h) {
    std::vector<Vec> out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec& p = polygon[i];
        const Vec& q = polygon[(i + 1) % polygon.size()];
        const Rational a = h(p);
        const Rational b = h(q);
        if (a <= 0) out.push_back(p);
        if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
            Vec x;
            for (std::size_t k = 0; k < 3; ++k) x[k] = p[k] + (q[k] - p[k]) * Rational(a / (a - b));
            out.push_back(x);
        }
    }
    return out;
}

/// What two triangles have in common, as the points that span it: one triangle cut down by the planes of the other.
std::vector<Vec> common(const Triangle& a, const Triangle& b) {
    const Vec n = cross(minus(b[1], b[0]), minus(b[2], b[0]));
    std::vector<Vec> rest(a.begin(), a.end());
    rest = clip(rest, [&](const Vec& x) { return dot(n, minus(x, b[0])); });
    rest = clip(rest, [&](const Vec& x) { return Rational(-dot(n, minus(x, b[0]))); });
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec m = cross(minus(b[(i + 1) % 3], b[i]), n);
        rest = clip(rest, [&](const Vec& x) { return dot(m, minus(x, b[i])); });
    }
    std::sort(rest.begin(), rest.end());
    rest.erase(std::unique(rest.begin(), rest.end()), rest.end());
    return rest;
}

bool is_inside(const Triangle& t, const Vec& p) {
    const Vec n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    for (std::size_t i = 0; i < 3; ++i)
        if (!(dot(cross(minus(t[(i + 1) % 3], t[i]), n), minus(p, t[i])) < 0)) return false;
    return true;
}

/// The contact of two triangles by rational arithmetic alone.
std::optional<Kind> oracle(const Triangle& a, const Triangle& b) {
    const std::vector<Vec> both = common(a, b);
    if (both.empty()) return std::nullopt;
    Vec middle{Rational(0), Rational(0), Rational(0)};
    for (const Vec& p : both)
        for (std::size_t k = 0; k < 3; ++k) middle[k] = middle[k] + p[k] / int(both.size());
    const bool coplanar = std::all_of(b.begin(), b.end(), [&](const Vec& p) {
        return det(minus(a[1], a[0]), minus(a[2], a[0]), minus(p, a[0])) == 0;
    });
    if (is_inside(a, middle) && is_inside(b, middle)) return coplanar ? Kind::overlap : Kind::crossing;
    const bool shared = std::all_of(both.begin(), both.end(), [&](const Vec& p) {
        return std::find(a.begin(), a.end(), p) != a.end() && std::find(b.begin(), b.end(), p) != b.end();
    });
    if (shared) return std::nullopt;
    return Kind::touch;
}

}  // namespace

TEST_CASE("self-intersections: sound meshes have none") {
    CHECK(contacts(meshes::cube()).empty());
    CHECK(contacts(meshes::triangle_cube()).empty());
    CHECK(contacts(meshes::pentomino()).empty());
    CHECK(contacts(meshes::soup(meshes::triangle_cube())).empty());
    CHECK(contacts(meshes::tetrahedron<Rational>()).empty());
    CHECK(contacts(Mesh()).empty());
}

TEST_CASE("self-intersections: every kind of contact of two triangles") {
    // Apart, on one plane, in parallel planes.
    CHECK(meet(ground, {{{5, 5, 0}, {6, 5, 0}, {5, 6, 0}}}) == std::nullopt);
    CHECK(meet(ground, {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}}) == std::nullopt);
    CHECK(meet(ground, {{{3, 3, -1}, {3, 3, 1}, {5, 3, 0}}}) == std::nullopt);
    // An edge pierces the face; two edges each; a corner in common besides; an edge in common cannot.
    CHECK(meet(ground, {{{1, 1, -1}, {1, 1, 1}, {9, 9, 0}}}) == Kind::crossing);
    CHECK(meet(ground, {{{1, 1, -1}, {1, 1, 9}, {-9, -9, 4}}}) == Kind::crossing);
    CHECK(meet(ground, {{{1, 1, -1}, {2, 1, -1}, {1, 1, 3}}}) == Kind::crossing);
    CHECK(meet(ground, {{{0, 0, 0}, {2, 1, 1}, {1, 2, -1}}}) == Kind::crossing);
    CHECK(meet(ground, {{{0, 0, 0}, {-2, 1, 1}, {-1, 2, -1}}}) == std::nullopt);
    CHECK(meet(ground, {{{0, 0, 0}, {-2, -1, 1}, {-1, -2, -1}}}) == std::nullopt);
    CHECK(meet(ground, {{{0, 0, 0}, {4, 0, 0}, {2, 2, 2}}}) == std::nullopt);
    CHECK(meet(ground, {{{0, 0, 0}, {4, 0, 0}, {2, -2, 0}}}) == std::nullopt);
    // Through an edge and a corner of the other: still inner points.
    CHECK(meet(ground, {{{0, 0, -1}, {2, 2, 1}, {2, 2, -1}}}) == Kind::crossing);
    // Overlaps.
    CHECK(meet(ground, ground) == Kind::overlap);
    CHECK(meet(ground, {{{0, 0, 0}, {4, 0, 0}, {2, 2, 0}}}) == Kind::overlap);
    CHECK(meet(ground, {{{1, 1, 0}, {9, 9, 0}, {9, 8, 0}}}) == Kind::overlap);
    CHECK(meet(ground, {{{-1, -1, 0}, {9, -1, 0}, {-1, 9, 0}}}) == Kind::overlap);
    // Touches: a corner in the face, on an edge; an edge in the face; edges across; parts of edges.
    CHECK(meet(ground, {{{1, 1, 0}, {1, 2, 3}, {2, 1, 3}}}) == Kind::touch);
    CHECK(meet(ground, {{{2, 0, 0}, {1, 2, 3}, {2, 1, 3}}}) == Kind::touch);
    CHECK(meet(ground, {{{2, 0, 0}, {1, -2, 0}, {3, -2, 0}}}) == Kind::touch);
    CHECK(meet(ground, {{{1, 1, 0}, {2, 1, 0}, {2, 1, 3}}}) == Kind::touch);
    CHECK(meet(ground, {{{2, 0, -1}, {2, 0, 1}, {2, -3, 0}}}) == Kind::touch);
    CHECK(meet(ground, {{{1, 0, 0}, {3, 0, 0}, {2, 0, 3}}}) == Kind::touch);
    CHECK(meet(ground, {{{0, 0, 0}, {3, 0, 0}, {2, 0, 3}}}) == Kind::touch);
    CHECK(meet(ground, {{{-1, 0, 0}, {5, 0, 0}, {2, -3, 0}}}) == Kind::touch);
    CHECK(meet(ground, {{{0, 0, 0}, {2, 2, 0}, {2, 2, 3}}}) == Kind::touch);
}

TEST_CASE("self-intersections: faces of more than three corners") {
    const Mesh crossing = together(block({0, 0, 0}, {2, 2, 2}), block({1, 1, 1}, {3, 3, 3}));
    // Three faces of each cube cross three of the other's.
    CHECK(count(crossing, Kind::crossing) == 6);
    CHECK(find_self_intersections(crossing).size() == 6);
    CHECK(find_self_intersections(crossing).front() == SelfContact{1, 8, Kind::crossing});
    // A corner in the middle of a diagonal is in the middle of the face.
    const Mesh spike = together(block({0, 0, 0}, {2, 2, 2}),
                                meshes::mesh({{1, 1, 2}, {1, 2, 3}, {0, 1, 3}, {2, 1, 3}}, {{0, 1, 2}, {0, 2, 3}}));
    CHECK(count(spike, Kind::touch) == 2);
    CHECK(find_self_intersections(spike).empty());
    // Through the diagonal alone, and along it.
    const Mesh blade =
        together(block({0, 0, 0}, {2, 2, 2}), meshes::mesh({{1, 1, 1}, {1, 1, 3}, {1.5, 1, 3}}, {{0, 1, 2}}));
    CHECK(count(blade, Kind::crossing) == 1);
    for (const int turned : {0, 1}) {
        Mesh along = block({0, 0, 0}, {2, 2, 2});
        const double y = turned == 0 ? 0 : 2;
        along = together(along, meshes::mesh({{0, y, 1}, {2, 2 - y, 1}, {2, 2 - y, 4}, {0, y, 4}}, {{0, 1, 2, 3}}));
        CHECK(count(along, Kind::crossing) == 1);
    }
    // An edge from corner to corner of a face is inside it, whichever way the face falls into triangles.
    for (const int turned : {0, 1}) {
        const double y = turned == 0 ? 0 : 2;
        const Mesh fin =
            together(block({0, 0, 0}, {2, 2, 2}), meshes::mesh({{0, y, 2}, {2, 2 - y, 2}, {1, 1, 4}}, {{0, 1, 2}}));
        CHECK(count(fin, Kind::touch) == 1);
        CHECK(contacts(fin).size() == 1);
    }
    // One cube twice: faces overlap, those that meet at an edge have it in common.
    const Mesh twice = together(meshes::cube(), meshes::cube());
    CHECK(contacts(twice).size() == 6);
    CHECK(count(twice, Kind::overlap) == 6);
    // Cubes side by side, shifted: one pair of faces overlaps, four others touch.
    const Mesh shifted = together(block({0, 0, 0}, {2, 2, 2}), block({2, 1, 1}, {4, 3, 3}));
    CHECK(count(shifted, Kind::overlap) == 1);
    CHECK(count(shifted, Kind::crossing) == 0);
    CHECK(count(shifted, Kind::touch) > 0);
}

TEST_CASE("self-intersections: a face that is not flat may cross itself") {
    // A bow tie.
    const Mesh tie = meshes::mesh({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2, 3}});
    const auto found = contacts(tie);
    REQUIRE(found.size() == 1);
    CHECK(found.front() == SelfContact{0, 0, Kind::overlap});
}

TEST_CASE("self-intersections: bad indices and points are refused") {
    Mesh m = meshes::cube();
    m.corners[3] = 99;
    CHECK_THROWS_AS(find_self_intersections(m), MeshError);
    m = meshes::cube();
    m.points[2][1] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(find_self_intersections(m), MeshError);
}

TEST_CASE("self-intersections: stops on request, tells how far it is") {
    std::stop_source stop;
    stop.request_stop();
    ProgressReporter stopped(stop.get_token());
    CHECK_THROWS_AS(find_self_intersections(meshes::cube(), {false, &stopped}), Cancelled);
    double last = -1;
    ProgressReporter progress([&](std::string_view, double fraction) { last = fraction; });
    CHECK(find_self_intersections(meshes::cube(), {false, &progress}).empty());
    CHECK(last == 1);
}

TEST_CASE("to_region: checks for self-intersections when asked to") {
    const Mesh m = together(block({0, 0, 0}, {2, 2, 2}), block({1, 1, 1}, {3, 3, 3}));
    MeshOrigin origin;
    origin.file = "two.off";
    for (std::uint32_t f = 0; f < m.face_count(); ++f) origin.face_lines.push_back(20 + f);
    ToRegionOptions options;
    options.origin = &origin;
    CHECK_NOTHROW(to_region(m, options));
    options.check_self_intersections = true;
    std::string message;
    std::size_t pairs = 0;
    try {
        static_cast<void>(to_region(m, options));
    } catch (const SelfIntersectionError& error) {
        message = error.what();
        pairs = error.contacts().size();
    }
    CHECK(pairs == 6);
    for (const char* part : {"two.off: ", "6 pairs of faces", "face 1 (line 21) crosses face 8 (line 28)", "and 3 more",
                             "`resolve` the mesh"}) {
        CAPTURE(message, part);
        CHECK(message.find(part) != std::string::npos);
    }
    CHECK_NOTHROW(to_region(meshes::cube(), options));
    CHECK_NOTHROW(to_region(together(block({0, 0, 0}, {2, 2, 2}), block({2, 2, 2}, {3, 3, 3})), options));
}

TEST_CASE("self-intersections: random triangles on small integers, the same as by rational arithmetic") {
    Dice dice(21);
    std::array<std::size_t, 4> seen{};
    for (std::size_t n = 0; n < scaled(4000); ++n) {
        Mesh m;
        const int range = dice.between(1, 5);
        for (int i = 0; i < 5; ++i)
            m.points.push_back({double(dice.below(range + 1)), double(dice.below(range + 1)),
                                double(dice.below(dice.below(2) == 0 ? range + 1 : 2))});
        for (int i = 0; i < 2; ++i) {
            std::array<std::uint32_t, 3> face{};
            for (auto& c : face) c = std::uint32_t(dice.below(5));
            m.add_face(face);
        }
        std::array<Triangle, 2> t;
        bool flat = false;
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t x = 0; x < 3; ++x) t[i][c][x] = Rational(m.points[m.face(i)[c]][x]);
            const Vec normal = cross(minus(t[i][1], t[i][0]), minus(t[i][2], t[i][0]));
            flat = flat || (normal[0] == 0 && normal[1] == 0 && normal[2] == 0);
        }
        const std::vector<SelfContact> found = contacts(m);
        REQUIRE(found.size() <= 1);
        std::optional<Kind> expected;
        if (!flat) expected = oracle(t[0], t[1]);
        ++seen[expected ? std::size_t(*expected) + 1 : 0];
        CAPTURE(n);
        CHECK((found.empty() ? std::nullopt : std::optional<Kind>(found.front().kind)) == expected);
    }
    for (const std::size_t s : seen) CHECK(s > 0);
}

TEST_CASE("self-intersections: in large meshes the same as by trying all pairs of faces") {
    Dice dice(22);
    for (std::size_t n = 0; n < scaled(20); ++n) {
        Mesh m;
        for (int i = 0; i < 40; ++i)
            m.points.push_back({double(dice.below(9)), double(dice.below(9)), double(dice.below(9))});
        for (int i = 0; i < 60; ++i)
            m.add_face({std::uint32_t(dice.below(40)), std::uint32_t(dice.below(40)), std::uint32_t(dice.below(40))});
        std::vector<SelfContact> expected;
        for (std::uint32_t a = 0; a < 60; ++a)
            for (std::uint32_t b = a + 1; b < 60; ++b) {
                Mesh two;
                two.points = m.points;
                two.add_face(m.face(a));
                two.add_face(m.face(b));
                for (const SelfContact& c : contacts(two)) expected.push_back({a, b, c.kind});
            }
        CHECK(contacts(m) == expected);
    }
}
