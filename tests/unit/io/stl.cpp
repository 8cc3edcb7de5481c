// SPDX-License-Identifier: Apache-2.0
#include <cleave/io/stl.hpp>

#include <cleave/mesh/validate.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"

#include <bit>
#include <limits>
#include <string>
#include <vector>

using namespace cleave;

namespace {

std::string refusal(std::string_view bytes) {
    try {
        (void)read_stl(bytes, "f.stl");
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

const std::string facet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 .5 0\n endloop\nendfacet\n";

/// The corners' coordinates, face by face: what a mesh says, whatever its numbering.
template <class T>
std::vector<std::array<T, 3>> corners(const PolygonMesh<T>& mesh) {
    std::vector<std::array<T, 3>> result;
    for (const std::uint32_t c : mesh.corners) result.push_back(mesh.points[c]);
    return result;
}

std::string with_header(std::string bytes, const std::string& header) {
    return bytes.replace(0, header.size(), header);
}

}  // namespace

TEST_CASE("stl: text with one triangle, however it is spaced and spelt") {
    const Mesh expected = meshes::mesh({{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}, {{0, 1, 2}});
    REQUIRE(read_stl("solid a b c\n" + facet + "endsolid a b c\n") == expected);
    REQUIRE(read_stl("solid\n" + facet + "endsolid") == expected);
    REQUIRE(read_stl("SOLID X\nFacet Normal nan nan nan\nOUTER LOOP\nvertex 0 0 0\nVERTEX 1 0 0\nvertex 0 5e-1 0\n"
                     "ENDLOOP\nENDFACET\nENDSOLID\n") == expected);
    REQUIRE(read_stl("solid\r\nfacet normal 0 0 0\r\nouter\r\nloop\r\nvertex 0 0 0\r\nvertex 1 0 0\r\nvertex 0 .5 0\r\n"
                     "endloop endfacet endsolid x\r\n") == expected);
    REQUIRE(read_stl("solid empty\nendsolid empty\n") == Mesh{});
    // Two solids in one file are one mesh.
    REQUIRE(read_stl("solid a\n" + facet + "endsolid a\nsolid b\n" + facet + "endsolid b\n").face_count() == 2);
}

TEST_CASE("stl: equal corners become one point") {
    const Mesh cube = meshes::triangle_cube();
    for (const StlKind kind : {StlKind::text, StlKind::binary}) {
        const Mesh mesh = read_stl(write_stl(cube, kind));
        REQUIRE(mesh.point_count() == 8);
        REQUIRE(mesh.face_count() == 12);
        REQUIRE(corners(mesh) == corners(cube));
        REQUIRE(validate(mesh).is_valid(Strictness::strict));
    }
}

TEST_CASE("stl: binary files are told by their size, whatever they start with") {
    const std::string bytes = write_stl(meshes::triangle_cube());
    REQUIRE(bytes.size() == 84 + 12 * 50);
    const Mesh expected = read_stl(bytes);
    REQUIRE(read_stl(with_header(bytes, "solid binary")) == expected);
    REQUIRE(read_stl(with_header(bytes, "solid a\nfacet normal 0 0 1\nouter loop\n")) == expected);
    REQUIRE(read_stl(with_header(bytes, std::string(80, '\0'))) == expected);
    REQUIRE(read_stl(write_stl(Mesh{})) == Mesh{});
}

TEST_CASE("stl: binary files of the wrong size are reported with both sizes") {
    const std::string bytes = write_stl(meshes::triangle_cube());
    const std::string why =
        "f.stl: is not a complete binary STL file: its count of 12 triangles takes 684 bytes, but it has ";
    REQUIRE(refusal(bytes.substr(0, bytes.size() - 1)) == why + "683");
    REQUIRE(refusal(bytes + '\0') == why + "685");
    REQUIRE(refusal(with_header(bytes.substr(0, 300), "solid")) == why + "300");
    // A count that would need 200 GB.
    std::string huge = bytes;
    for (std::size_t i = 80; i < 84; ++i) huge[i] = '\xff';
    REQUIRE(refusal(huge).find("4294967295 triangles takes 214748364834 bytes, but it has 684") != std::string::npos);
}

TEST_CASE("stl: binary coordinates that are not finite are refused") {
    std::string bytes = write_stl(meshes::triangle_cube());
    const auto nan = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < 4; ++i) bytes[84 + 50 + 12 + 4 + i] = static_cast<char>(nan >> (8 * i));
    REQUIRE(refusal(bytes) == "f.stl: triangle 1 has an infinite or NaN coordinate (byte 150)");
    // A normal need not be a number: it is not read.
    bytes = write_stl(meshes::triangle_cube());
    for (std::size_t i = 0; i < 4; ++i) bytes[84 + i] = static_cast<char>(nan >> (8 * i));
    REQUIRE(read_stl(bytes).face_count() == 12);
}

TEST_CASE("stl: errors in text name the line, what was expected and what was found") {
    REQUIRE(refusal("hello\n") == "f.stl:1: expected 'solid', found 'hello'");
    REQUIRE(refusal("solid\nfacet normal 0 0 0\nouter hoop\n") == "f.stl:3: expected 'loop', found 'hoop'");
    REQUIRE(refusal("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0\n") ==
            "f.stl:4: expected the z coordinate of vertex 0, found the end of the line");
    REQUIRE(refusal("solid\n" + facet) == "f.stl:9: expected 'facet' or 'endsolid', found the end of the file");
    REQUIRE(refusal("solid\n" + facet + "vertex 1 2 3\n") == "f.stl:9: expected 'facet' or 'endsolid', found 'vertex'");
    REQUIRE(refusal("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n") ==
            "f.stl:6: expected 'vertex', found 'endloop'");
    REQUIRE(refusal("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 2 0 0\nvertex 3 0 0\n") ==
            "f.stl:7: expected 'endloop', found 'vertex'");
    REQUIRE(refusal("solid\nfacet\nouter loop\nvertex 0 0 0\n") ==
            "f.stl:5: expected 'vertex', found the end of the file");
    REQUIRE(refusal("solid x\nfacet normal 0 0 0\nouter loop\nvertex 0 inf 0\n")
                .starts_with("f.stl:4: expected the y coordinate of vertex 0, found 'inf'"));
}

TEST_CASE("stl: lines of points and faces are remembered for text") {
    MeshOrigin origin;
    const Mesh mesh = read_stl("solid\n" + facet +
                                   "facet normal 0 0 0\nouter loop\nvertex 9 9 9\nvertex 1 0 0\nvertex 8 8 8\n"
                                   "endloop\nendfacet\nendsolid\n",
                               "x.stl", &origin);
    REQUIRE(mesh.point_count() == 5);
    REQUIRE(origin.face_lines == std::vector<std::uint32_t>{2, 9});
    REQUIRE(origin.point_lines == std::vector<std::uint32_t>{4, 5, 6, 11, 13});
    (void)read_stl(write_stl(mesh), "y.stl", &origin);
    REQUIRE(origin.file == "y.stl");
    REQUIRE(origin.face_lines.empty());
    REQUIRE(origin.point_lines.empty());
}

TEST_CASE("stl: coordinates as exact rationals") {
    const std::string text =
        "solid\nfacet normal 0 0 0\nouter loop\nvertex 0.1 1/3 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid\n";
    REQUIRE(read_stl<Rational>(text).points[0] == std::array<Rational, 3>{Rational(1) / 10, Rational(1) / 3, 0});
    const Mesh cube = read_stl(write_stl(meshes::cube(0.0, 0.1)));
    const RationalMesh exact = read_stl<Rational>(write_stl(meshes::cube(0.0, 0.1)));
    REQUIRE(exact.points.size() == cube.points.size());
    for (std::size_t i = 0; i < cube.points.size(); ++i) {
        for (std::size_t x = 0; x < 3; ++x) REQUIRE(exact.points[i][x] == Rational(cube.points[i][x]));
    }
}

TEST_CASE("stl: writing says what it rounded") {
    StlRounding rounding;
    (void)write_stl(meshes::cube(0.0, 0.5), StlKind::binary, &rounding);
    REQUIRE(rounding.is_exact());
    (void)write_stl(meshes::cube(0.0, 0.1), StlKind::binary, &rounding);
    REQUIRE(rounding.rounded_coordinates == 12);
    REQUIRE(rounding.lost_triangles == 0);
    (void)write_stl(meshes::cube(0.0, 0.1), StlKind::text, &rounding);
    REQUIRE(rounding.is_exact());
    (void)write_stl(meshes::cube<Rational>(Rational(1) / 3, 1), StlKind::text, &rounding);
    REQUIRE(rounding.rounded_coordinates == 12);

    // Points that round alike take triangles with them, and what is left is closed.
    Mesh thin = meshes::triangle_cube();
    for (const std::size_t top : {4U, 5U}) thin.points[top] = thin.points[top - 4];
    thin.points[4][2] += 1e-12;
    const Mesh read = read_stl(write_stl(thin, StlKind::binary, &rounding));
    REQUIRE(rounding.lost_triangles == 4);
    REQUIRE(read.face_count() == 8);
    REQUIRE(validate(read).is_closed());
}

TEST_CASE("stl: rounding to float happens once") {
    // 1 + 2^-24 + 2^-60: a tie for a float once the last bit is lost to a double, above the tie before that.
    const Rational half_way = Rational(1) + Rational(0x1p-24) + Rational(0x1p-60);
    RationalMesh mesh = meshes::tetrahedron<Rational>();
    mesh.points[1][0] = half_way;
    const Mesh read = read_stl(write_stl(mesh));
    bool found = false;
    for (const auto& p : read.points) found = found || p[0] == 1 + 0x1p-23;
    REQUIRE(found);
}

TEST_CASE("stl: coordinates beyond the range of floats are refused") {
    REQUIRE_THROWS_AS(write_stl(meshes::cube(0.0, 1e39)), Error);
    REQUIRE(read_stl(write_stl(meshes::cube(0.0, 1e39), StlKind::text)).point_count() == 8);
    const Rational big = Rational(1e300) * Rational(1e300);
    REQUIRE_THROWS_AS(write_stl(meshes::cube<Rational>(0, big), StlKind::text), Error);
}

TEST_CASE("stl: polygons are written as triangles") {
    const Mesh read = read_stl(write_stl(meshes::pentomino(), StlKind::text));
    REQUIRE(read.face_count() == 28);
    REQUIRE(read.point_count() == 16);
    REQUIRE(validate(read).is_valid(Strictness::strict));
}
