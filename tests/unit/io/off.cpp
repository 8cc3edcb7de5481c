// SPDX-License-Identifier: Apache-2.0
#include <cleave/io/off.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"

#include <string>
#include <vector>

using namespace cleave;

namespace {

const Mesh triangle = meshes::mesh({{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}, {{0, 1, 2}});

std::string refusal(std::string_view text) {
    std::string with_doubles = "accepted", with_rationals = "accepted";
    try {
        (void)read_off(text, "f.off");
    } catch (const FileError& error) {
        with_doubles = error.what();
    }
    try {
        (void)read_off<Rational>(text, "f.off");
    } catch (const FileError& error) {
        with_rationals = error.what();
    }
    REQUIRE(with_doubles == with_rationals);
    return with_doubles;
}

}  // namespace

TEST_CASE("off: the plain form") {
    REQUIRE(read_off("OFF\n3 1 3\n0 0 0\n1 0 0\n0 .5 0\n3 0 1 2\n") == triangle);
    REQUIRE(read_off("OFF 3 1 3\n0 0 0\n1 0 0\n0 5e-1 0\n3 0 1 2") == triangle);
    REQUIRE(read_off("OFF\n3 1\n0 0 0\n1 0 0\n0 .5 0\n3 0 1 2") == triangle);
    REQUIRE(read_off("OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 .5 0\r\n3 0 1 2\r\n") == triangle);
    REQUIRE(read_off("\xef\xbb\xbfOFF\n3 1 0\n0 0 0\n1 0 0\n0 .5 0\n3 0 1 2\n") == triangle);
}

TEST_CASE("off: comments and empty lines are anywhere") {
    REQUIRE(read_off("# a\n\nOFF # b\n# c\n3 1 0 # d\n\n0 0 0 # e\n1 0 0\n#f\n0 .5 0\n\n3 0 1 2#g\n# h\n\n") ==
            triangle);
}

TEST_CASE("off: colours, normals and texture coordinates are passed over") {
    REQUIRE(read_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 .5 0\n3 0 1 2 255 0 0\n") == triangle);
    REQUIRE(read_off("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 255 255 255\n0 .5 0\n3 0 1 2 0.5 0.5 0.5 1\n") == triangle);
    REQUIRE(read_off("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 .5 0 0 0 1\n3 0 1 2\n") == triangle);
    REQUIRE(read_off("STCNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1\n0 .5 0 0 0 1\n3 0 1 2\n") == triangle);
}

TEST_CASE("off: polygons of any size, degenerate ones included, and no faces at all") {
    const Mesh mesh = read_off("OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n5 0 1 2 3 4\n2 0 1\n1 4\n0\n");
    REQUIRE(mesh.face_count() == 4);
    REQUIRE(mesh.face(0).size() == 5);
    REQUIRE(mesh.face(3).empty());
    REQUIRE(read_off("OFF\n0 0 0\n") == Mesh{});
    REQUIRE(read_off("OFF 0 0") == Mesh{});
}

TEST_CASE("off: coordinates as exact rationals") {
    const RationalMesh mesh = read_off<Rational>("OFF\n1 0 0\n0.1 1/3 -2e-1\n");
    REQUIRE(mesh.points[0] == std::array<Rational, 3>{Rational(1) / 10, Rational(1) / 3, Rational(-1) / 5});
}

TEST_CASE("off: lines of points and faces are remembered on request") {
    MeshOrigin origin;
    (void)read_off("# a\nOFF\n3 2 0\n0 0 0\n\n1 0 0\n0 1 0\n3 0 1 2\n# b\n3 0 2 1\n", "x.off", &origin);
    REQUIRE(origin.file == "x.off");
    REQUIRE(origin.point_lines == std::vector<std::uint32_t>{4, 6, 7});
    REQUIRE(origin.face_lines == std::vector<std::uint32_t>{8, 10});
}

TEST_CASE("off: what is written reads back") {
    for (const Mesh& mesh : {meshes::cube(0.1, 1e-300), meshes::pentomino(), Mesh{}, triangle}) {
        REQUIRE(read_off(write_off(mesh)) == mesh);
    }
    RationalMesh thirds = meshes::cube<Rational>(Rational(1) / 3, Rational(22) / 7);
    REQUIRE(read_off<Rational>(write_off(thirds)) == thirds);
    REQUIRE(write_off(triangle) == "OFF\n3 1 0\n0 0 0\n1 0 0\n0 0.5 0\n3 0 1 2\n");
}

TEST_CASE("off: errors name the line, what was expected and what was found") {
    REQUIRE(refusal("ply\nformat ascii") == "f.off:1: expected the header OFF, found 'ply'");
    REQUIRE(refusal("") == "f.off:1: expected the header OFF, found the end of the line");
    REQUIRE(refusal("8 12 0\n") == "f.off:1: expected the header OFF, found '8'");
    REQUIRE(refusal("XOFF\n") == "f.off:1: expected the header OFF, found 'XOFF'");
    REQUIRE(refusal("4OFF\n").find("not three-dimensional") != std::string::npos);
    REQUIRE(refusal("nOFF\n3\n").find("not three-dimensional") != std::string::npos);
    REQUIRE(refusal("OFF BINARY\n").find("binary OFF is not supported") != std::string::npos);
    REQUIRE(refusal("OFF\n") == "f.off:2: expected the counts of vertices, faces and edges, found the end of the file");
    REQUIRE(refusal("OFF\n8\n") == "f.off:2: expected the number of faces, found the end of the line");
    REQUIRE(refusal("OFF\n-8 1 0\n") == "f.off:2: expected the number of vertices, found '-8'");
    REQUIRE(refusal("OFF\n0 0 0 0\n") == "f.off:2: expected the end of the counts line, found '0'");
    REQUIRE(refusal("OFF\n2 0 0\n0 0 0\n1 2\n") ==
            "f.off:4: expected the z coordinate of vertex 1, found the end of the line");
    REQUIRE(refusal("OFF\n2 0 0\n0 0 0\n1 two 3\n")
                .starts_with("f.off:4: expected the y coordinate of vertex 1, found 'two'"));
    REQUIRE(
        refusal("OFF\n1 0 0\n0 nan 0\n").starts_with("f.off:3: expected the y coordinate of vertex 0, found 'nan'"));
    REQUIRE(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n") == "f.off:5: expected vertex 2 of 3, found the end of the file");
    REQUIRE(refusal("OFF\n1 0 0\n0 0 0 1\n")
                .starts_with("f.off:3: expected the end of the line after the three coordinates of vertex 0"));
    REQUIRE(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n") ==
            "f.off:6: face 0 has vertex index 3, but the 3 vertices are numbered from 0");
    REQUIRE(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n") ==
            "f.off:6: expected a vertex index of face 0, found '-1'");
    REQUIRE(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n") ==
            "f.off:6: expected a vertex index of face 0, found the end of the line");
    REQUIRE(refusal("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") ==
            "f.off:7: expected face 1 of 2, found the end of the file");
    REQUIRE(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n") ==
            "f.off:7: expected the end of the file after 1 faces, found '3'");
}

TEST_CASE("off: counts that the file cannot hold cost no memory") {
    REQUIRE(refusal("OFF\n1000000000000 1 0\n0 0 0\n") ==
            "f.off:2: the number of vertices is 1000000000000, more than a mesh can hold");
    REQUIRE(refusal("OFF\n4000000000 1 0\n0 0 0\n") ==
            "f.off:4: expected vertex 1 of 4000000000, found the end of the file");
    REQUIRE(refusal("OFF\n1 4000000000 0\n0 0 0\n") ==
            "f.off:4: expected face 0 of 4000000000, found the end of the file");
    REQUIRE(refusal("OFF\n99999999999999999999999 1 0\n0 0 0\n") ==
            "f.off:2: expected the number of vertices, found '99999999999999999999999'");
    REQUIRE(refusal("OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n") ==
            "f.off:4: expected a vertex index of face 0, found the end of the line");
    REQUIRE(refusal("OFF\n1 1 0\n0 0 0\n5000000000 0 0 0\n") ==
            "f.off:4: face 0 has 5000000000 corners, too many for a mesh");
}
