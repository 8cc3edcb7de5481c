// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/face_shape.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"

#include <map>
#include <set>

using namespace cleave;

namespace {

/// Directed edges, opposite ones cancelled.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> boundary(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
            if (a < b) ++uses[{a, b}];
            if (b < a) --uses[{b, a}];
        }
    }
    std::erase_if(uses, [](const auto& entry) { return entry.second == 0; });
    return uses;
}

FaceShape shape(const std::vector<std::array<double, 3>>& points) {
    std::vector<std::uint32_t> face(points.size());
    for (std::size_t i = 0; i < face.size(); ++i) face[i] = static_cast<std::uint32_t>(i);
    std::vector<IndexTriangle> triangles;
    const FaceShape result = FaceShapes<double>(points).shape(face, &triangles);
    REQUIRE(triangles.empty() == (result != FaceShape::flat));
    return result;
}

}  // namespace

TEST_CASE("face_shape: triangles") {
    REQUIRE(shape({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == FaceShape::flat);
    REQUIRE(shape({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}) == FaceShape::zero_area);
    REQUIRE(shape({{0, 0, 0}, {1, 1, 1}, {0, 0, 0}}) == FaceShape::too_few_corners);
    REQUIRE(shape({{0, 0, -0.0}, {1, 1, 1}, {0, 0, 0.0}}) == FaceShape::too_few_corners);
}

TEST_CASE("face_shape: fewer corners than three") {
    REQUIRE(shape({}) == FaceShape::too_few_corners);
    REQUIRE(shape({{1, 2, 3}}) == FaceShape::too_few_corners);
    REQUIRE(shape({{1, 2, 3}, {4, 5, 6}}) == FaceShape::too_few_corners);
    REQUIRE(shape({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}) == FaceShape::too_few_corners);
    REQUIRE(shape({{1, 2, 3}, {4, 5, 6}, {1, 2, 3}, {4, 5, 6}}) == FaceShape::too_few_corners);
}

TEST_CASE("face_shape: polygons without area") {
    REQUIRE(shape({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}}) == FaceShape::zero_area);
    // There and back along two edges: not on one line, and still nothing inside.
    REQUIRE(shape({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}}) == FaceShape::zero_area);
}

TEST_CASE("face_shape: planarity is exact") {
    const double up = std::nextafter(0.3, 1.0);
    REQUIRE(shape({{0, 0, 0.3}, {1, 0, 0.3}, {1, 1, 0.3}, {0, 1, 0.3}}) == FaceShape::flat);
    REQUIRE(shape({{0, 0, 0.3}, {1, 0, 0.3}, {1, 1, up}, {0, 1, 0.3}}) == FaceShape::not_planar);
    // A slanted plane z = x + y holds integer points exactly.
    REQUIRE(shape({{0, 0, 0}, {3, 0, 3}, {3, 5, 8}, {0, 5, 5}}) == FaceShape::flat);
    REQUIRE(shape({{0, 0, 0}, {3, 0, 3}, {3, 5, std::nextafter(8.0, 9.0)}, {0, 5, 5}}) == FaceShape::not_planar);
    // The fourth corner is off the plane of the first three, wherever the loop starts.
    REQUIRE(shape({{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 1}}) == FaceShape::not_planar);
}

TEST_CASE("face_shape: rational corners") {
    const Rational third = Rational(1) / 3;
    std::vector<std::array<Rational, 3>> points{{0, 0, 0}, {1, 0, third}, {1, 1, 2 * third}, {0, 1, third}};
    const std::vector<std::uint32_t> face{0, 1, 2, 3};
    REQUIRE(FaceShapes<Rational>(points).shape(face) == FaceShape::flat);
    points[2][2] += Rational(1) / Rational(1e60);
    REQUIRE(FaceShapes<Rational>(points).shape(face) == FaceShape::not_planar);
}

TEST_CASE("face_shape: outlines") {
    // Non-convex, either way round, in every coordinate plane and in a slanted one.
    const std::vector<std::array<double, 2>> dart{{0, 0}, {4, -1}, {1, 0}, {4, 1}};
    const std::vector<std::array<double, 2>> bow_tie{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    const std::vector<std::array<double, 2>> lopsided_bow_tie{{0, 0}, {3, 3}, {3, 0}, {0, 2}};
    for (std::size_t plane = 0; plane < 4; ++plane) {
        const auto lift = [&](const std::vector<std::array<double, 2>>& loop, bool reversed) {
            std::vector<std::array<double, 3>> points;
            for (const auto& [x, y] : loop) {
                if (plane == 0) points.push_back({7, x, y});
                if (plane == 1) points.push_back({y, 7, x});
                if (plane == 2) points.push_back({x, y, 7});
                if (plane == 3) points.push_back({x, y, x - y});
            }
            if (reversed) std::reverse(points.begin(), points.end());
            return points;
        };
        for (const bool reversed : {false, true}) {
            REQUIRE(shape(lift(dart, reversed)) == FaceShape::flat);
            REQUIRE(shape(lift(bow_tie, reversed)) == FaceShape::crossing);
            REQUIRE(shape(lift(lopsided_bow_tie, reversed)) == FaceShape::crossing);
        }
    }
    // A hole tied to its outer loop by a bridge.
    REQUIRE(shape({{0, 0, 1},
                   {9, 0, 1},
                   {9, 9, 1},
                   {0, 9, 1},
                   {0, 0, 1},
                   {3, 3, 1},
                   {3, 6, 1},
                   {6, 6, 1},
                   {6, 3, 1},
                   {3, 3, 1}}) == FaceShape::flat);
    // Round a square twice.
    REQUIRE(shape({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) ==
            FaceShape::crossing);
}

TEST_CASE("face_shape: repeated corners") {
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, -0.0}};
    const FaceShapes<double> shapes(points);
    REQUIRE_FALSE(shapes.repeats_a_corner(std::vector<std::uint32_t>{0, 1, 2}));
    REQUIRE(shapes.repeats_a_corner(std::vector<std::uint32_t>{0, 1, 2, 2}));
    REQUIRE(shapes.repeats_a_corner(std::vector<std::uint32_t>{0, 1, 2, 3}));
    REQUIRE(shapes.repeats_a_corner(std::vector<std::uint32_t>{0, 1, 2, 0}));
    REQUIRE_FALSE(shapes.repeats_a_corner(std::vector<std::uint32_t>{0}));
    REQUIRE_FALSE(shapes.repeats_a_corner(std::vector<std::uint32_t>{}));
}

TEST_CASE("face_shape: a fan starts at the least index, whatever corner the face starts with") {
    std::vector<IndexTriangle> triangles;
    fan(std::vector<std::uint32_t>{7, 5, 9, 3, 8}, triangles);
    REQUIRE(triangles == std::vector<IndexTriangle>{{3, 8, 7}, {3, 7, 5}, {3, 5, 9}});
    triangles.clear();
    fan(std::vector<std::uint32_t>{9, 3, 8, 7, 5}, triangles);
    REQUIRE(triangles == std::vector<IndexTriangle>{{3, 8, 7}, {3, 7, 5}, {3, 5, 9}});
    triangles.clear();
    fan(std::vector<std::uint32_t>{1, 2}, triangles);
    REQUIRE(triangles.empty());
}

TEST_CASE("face_shape: a mesh in triangles keeps its edges balanced and its corners used") {
    Mesh warped = meshes::cube();
    warped.points[7] = {2, 2, 1.5};
    for (const Mesh& mesh : {meshes::cube(), meshes::pentomino(), meshes::triangle_cube(), warped}) {
        const SplitMesh<double> split = triangulate_faces(mesh);
        REQUIRE(split.source.size() == split.mesh.face_count());
        REQUIRE(split.mesh.points == mesh.points);
        REQUIRE(boundary(split.mesh).empty());
        std::map<std::uint32_t, std::set<std::uint32_t>> corners_of_source;
        for (std::size_t t = 0; t < split.mesh.face_count(); ++t) {
            REQUIRE(split.mesh.face(t).size() == 3);
            corners_of_source[split.source[t]].insert(split.mesh.face(t).begin(), split.mesh.face(t).end());
        }
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
            const std::set<std::uint32_t> expected(mesh.face(f).begin(), mesh.face(f).end());
            REQUIRE(corners_of_source[f] == expected);
        }
    }
    REQUIRE(triangulate_faces(meshes::pentomino()).mesh.face_count() == 4 * 3 + 8 * 2);
}

TEST_CASE("face_shape: flat faces are kept, others split, and what has no area is left out") {
    Mesh mesh = meshes::cube();
    mesh.points[7] = {2, 2, 1.5};  // three faces are no longer planar
    mesh.points.push_back({0.5, 0, 0});
    mesh.add_face({0, 1, 8});  // no area
    mesh.add_face({3, 3});     // not even a line
    const SplitMesh<double> split = flat_faces(mesh);
    FaceShapes<double> shapes(split.mesh.points);
    std::map<std::uint32_t, std::size_t> pieces;
    for (std::uint32_t f = 0; f < split.mesh.face_count(); ++f) {
        REQUIRE(shapes.shape(split.mesh.face(f)) == FaceShape::flat);
        ++pieces[split.source[f]];
    }
    REQUIRE(pieces == std::map<std::uint32_t, std::size_t>{{0, 1}, {1, 2}, {2, 1}, {3, 2}, {4, 1}, {5, 2}});
}
