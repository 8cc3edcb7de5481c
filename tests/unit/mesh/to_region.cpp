// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/to_region.hpp>
//
#include <cleave/query/measure.hpp>

#include "support/catch.hpp"

#include <limits>
#include <string>

using namespace cleave;

namespace {

/// [0, 2]^3 of six squares.
Mesh cube() {
    Mesh m;
    for (unsigned i = 0; i < 8; ++i)
        m.points.push_back({2.0 * (i & 1U), 2.0 * ((i >> 1U) & 1U), 2.0 * ((i >> 2U) & 1U)});
    m.add_face({0, 2, 3, 1});
    m.add_face({4, 5, 7, 6});
    m.add_face({0, 1, 5, 4});
    m.add_face({2, 6, 7, 3});
    m.add_face({0, 4, 6, 2});
    m.add_face({1, 3, 7, 5});
    return m;
}

std::string message(const Mesh& mesh, const ToRegionOptions& options = {}) {
    try {
        (void)to_region(mesh, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("to_region: a cube of squares keeps its six faces and sources") {
    const Region<3> r = to_region(cube());
    CHECK(r.face_count() == 6);
    CHECK(*measure(r) == 8);
    for (std::uint32_t f = 0; f < 6; ++f) CHECK(r.boundary().faces.faces[f].source == Source{0, f});
}

TEST_CASE("to_region: no faces are the empty set") {
    CHECK(to_region(Mesh()).is_empty());
}

TEST_CASE("to_region: a polygon that is not convex keeps its shape") {
    // An L of six corners, one high: area 3.
    Mesh m;
    const double corners[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (const double z : {0.0, 1.0})
        for (const auto& c : corners) m.points.push_back({c[0], c[1], z});
    m.add_face({5, 4, 3, 2, 1, 0});
    m.add_face({6, 7, 8, 9, 10, 11});
    for (std::uint32_t i = 0; i < 6; ++i) m.add_face({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
    const Region<3> r = to_region(m);
    CHECK(r.face_count() == 8);
    CHECK(*measure(r) == 3);
}

TEST_CASE("to_region: rational coordinates are taken exactly") {
    RationalMesh m;
    for (const auto& p : cube().points)
        m.points.push_back({Rational(p[0]) / 6, Rational(p[1]) / 6, Rational(p[2]) / 6});
    m.corners = cube().corners;
    m.first = cube().first;
    CHECK(*measure(to_region(m)) == Rational(1) / 27);
}

TEST_CASE("to_region: an open mesh is refused with the edges") {
    Mesh m = cube();
    m.corners.resize(m.corners.size() - 4);
    m.first.pop_back();
    const std::string text = message(m);
    CHECK(has(text, "open edge"));
    CHECK_THROWS_AS(to_region(m), MeshError);
    try {
        (void)to_region(m);
    } catch (const MeshError& error) {
        CHECK(error.report().open_edges.size() == 4);
    }
}

TEST_CASE("to_region: a mesh turned inside out is refused, and told apart from a good one") {
    Mesh m = cube();
    for (std::size_t f = 0; f < 6; ++f)
        std::reverse(m.corners.begin() + std::ptrdiff_t(4 * f), m.corners.begin() + std::ptrdiff_t(4 * f + 4));
    CHECK(has(message(m), "inside out"));
    CHECK_THROWS_AS(to_region(m), ShapeError);
}

TEST_CASE("to_region: two sides of one triangle enclose nothing") {
    Mesh m;
    m.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    m.add_face({0, 1, 2});
    m.add_face({0, 2, 1});
    CHECK(has(message(m), "encloses no volume"));
}

TEST_CASE("to_region: bad corners and coordinates are refused") {
    Mesh m = cube();
    m.corners[3] = 8;
    CHECK(has(message(m), "refers to no point"));
    m = cube();
    m.points[5][1] = std::numeric_limits<double>::quiet_NaN();
    CHECK(has(message(m), "NaN"));
}

TEST_CASE("to_region: faces without area are left out, or refused when strict") {
    Mesh m = cube();
    m.points.push_back({1, 0, 0});  // the middle of the edge 0-1, with the triangle that closes it
    m.corners.clear();
    m.first = {0};
    m.add_face({0, 2, 3, 1});
    m.add_face({4, 5, 7, 6});
    m.add_face({0, 8, 1, 5, 4});
    m.add_face({2, 6, 7, 3});
    m.add_face({0, 4, 6, 2});
    m.add_face({1, 3, 7, 5});
    m.add_face({0, 1, 8});
    ToRegionOptions strict;
    strict.strictness = Strictness::strict;
    CHECK(*measure(to_region(m)) == 8);
    CHECK(to_region(m).face_count() == 6);
    CHECK(has(message(m, strict), "without area"));
    MeshReport report;
    ToRegionOptions options;
    options.report = &report;
    (void)to_region(m, options);
    CHECK(report.zero_area_faces == std::vector<std::uint32_t>{6});
}

TEST_CASE("to_region: a face that is not flat is split from its lowest corner, or refused when strict") {
    Mesh m = cube();
    m.points[7] = {2, 2, 3};  // the top bends, the walls stay flat
    ToRegionOptions strict;
    strict.strictness = Strictness::strict;
    CHECK(has(message(m, strict), "no common plane"));
    const Region<3> r = to_region(m);
    CHECK(r.face_count() == 7);
    Mesh turned = m;
    std::rotate(turned.corners.begin() + 4, turned.corners.begin() + 6, turned.corners.begin() + 8);
    CHECK(*measure(to_region(turned)) == *measure(r));
}

TEST_CASE("to_region: messages name the file") {
    Mesh m = cube();
    m.corners[3] = 8;
    MeshOrigin origin;
    origin.file = "part.off";
    ToRegionOptions options;
    options.origin = &origin;
    CHECK(has(message(m, options), "part.off"));
}
