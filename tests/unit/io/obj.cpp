// SPDX-License-Identifier: Apache-2.0
#include <cleave/io/obj.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"

#include <string>
#include <vector>

using namespace cleave;

namespace {

const Mesh triangle = meshes::mesh({{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}, {{0, 1, 2}});
const std::string points = "v 0 0 0\nv 1 0 0\nv 0 .5 0\n";

std::string refusal(std::string_view text) {
    try {
        (void)read_obj(text, "f.obj");
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("obj: vertices and faces, with every form of index") {
    REQUIRE(read_obj(points + "f 1 2 3\n") == triangle);
    REQUIRE(read_obj(points + "f 1/1 2/2 3/3") == triangle);
    REQUIRE(read_obj(points + "f 1//7 2//7 3//7\n") == triangle);
    REQUIRE(read_obj(points + "f 1/4/7 2/5/7 3/6/7\n") == triangle);
    REQUIRE(read_obj(points + "f -3 -2 -1\n") == triangle);
    REQUIRE(read_obj(points + "f -3/-1 -2//-1 3/2/1\n") == triangle);
    REQUIRE(read_obj(points + "fo 1 2 3\n") == triangle);
    // Backwards from where the face stands, not from the end of the file.
    REQUIRE(read_obj(points + "f -3 -2 -1\nv 9 9 9\n").face(0)[0] == 0);
    // Faces in front of the vertices.
    REQUIRE(read_obj("f 1 2 3\n" + points) == triangle);
}

TEST_CASE("obj: everything that is no polygon is passed over") {
    const std::string text = "# comment\nmtllib a b.mtl\no thing\ng a b\ns off\nusemtl x#y\nvt 0 0\nvn 0 0 1\nvp 1\n" +
                             points + "l 1 2\np 1\nusemap off\nlod 3\nf 1 2 3 # tail\ns 1\n";
    REQUIRE(read_obj(text) == triangle);
    REQUIRE(read_obj("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 .5 0\nf 1 2 3\n") == triangle);
}

TEST_CASE("obj: lines continued by a backslash") {
    REQUIRE(read_obj("v 0 0 \\\n0\nv 1 0 0\nv 0\\\n .5 0\nf 1 \\\n 2\\\r\n 3\n") == triangle);
    // Also in what is passed over, whose second half is no statement.
    REQUIRE(read_obj("g a \\\n b c\nvt 0 \\\n0\n" + points + "f 1 2 3\n") == triangle);
}

TEST_CASE("obj: polygons, an empty mesh, other line ends") {
    REQUIRE(read_obj(points + "v 0 0 1\nf 1 2 3 4\nf 2 1\n").face(0).size() == 4);
    REQUIRE(read_obj("# nothing\n") == Mesh{});
    REQUIRE(read_obj("v 0 0 0\r\nv 1 0 0\r\nv 0 .5 0\r\nf 1 2 3\r\n") == triangle);
    REQUIRE(read_obj("v 0 0 0\rv 1 0 0\rv 0 .5 0\rf 1 2 3") == triangle);
}

TEST_CASE("obj: coordinates as exact rationals") {
    REQUIRE(read_obj<Rational>("v 0.1 1/3 -2e-1\n").points[0] ==
            std::array<Rational, 3>{Rational(1) / 10, Rational(1) / 3, Rational(-1) / 5});
}

TEST_CASE("obj: lines of points and faces are remembered on request") {
    MeshOrigin origin;
    (void)read_obj("# a\nv 0 0 0\n\nv 1 0 \\\n0\nv 0 1 0\nf 1 2 3\nf 1 3 \\\n2\n", "x.obj", &origin);
    REQUIRE(origin.file == "x.obj");
    REQUIRE(origin.point_lines == std::vector<std::uint32_t>{2, 4, 6});
    REQUIRE(origin.face_lines == std::vector<std::uint32_t>{7, 8});
}

TEST_CASE("obj: what is written reads back") {
    for (const Mesh& mesh : {meshes::cube(0.1, 1e-300), meshes::pentomino(), Mesh{}, triangle}) {
        REQUIRE(read_obj(write_obj(mesh)) == mesh);
    }
    const RationalMesh thirds = meshes::cube<Rational>(Rational(1) / 3, Rational(22) / 7);
    REQUIRE(read_obj<Rational>(write_obj(thirds)) == thirds);
    REQUIRE(write_obj(triangle) == "v 0 0 0\nv 1 0 0\nv 0 0.5 0\nf 1 2 3\n");
}

TEST_CASE("obj: errors name the line, what was expected and what was found") {
    REQUIRE(refusal("v 1 2\n") == "f.obj:1: expected the z coordinate of vertex 0, found the end of the line");
    REQUIRE(refusal("v 1 b 3\n").starts_with("f.obj:1: expected the y coordinate of vertex 0, found 'b'"));
    REQUIRE(refusal(points + "f 1 2 4\n") == "f.obj:4: face 0 has vertex index 4, but the file has 3 vertices");
    REQUIRE(refusal(points + "f 1 2 3\nf 1 2 9\nf 1 2 4\n") ==
            "f.obj:5: face 1 has vertex index 9, but the file has 3 vertices");
    REQUIRE(refusal(points + "f 0 1 2\n") == "f.obj:4: face 0 has vertex index 0; OBJ counts from 1");
    REQUIRE(refusal(points + "f -4 1 2\n") == "f.obj:4: face 0 has vertex index -4, but 3 vertices come before it");
    REQUIRE(refusal(points + "f a b c\n") == "f.obj:4: expected a vertex index of face 0, found 'a'");
    REQUIRE(refusal(points + "f 1.5 2 3\n") == "f.obj:4: expected a vertex index of face 0, found '1.5'");
    REQUIRE(refusal(points + "f /1 2 3\n") == "f.obj:4: expected a vertex index of face 0, found '/1'");
    REQUIRE(refusal(points + "f 99999999999999999999 2 3\n") ==
            "f.obj:4: expected a vertex index of face 0, found '99999999999999999999'");
    REQUIRE(refusal(points + "f 5000000000 2 3\n").find("vertex index 5000000000") != std::string::npos);
    REQUIRE(refusal(points + "f\n") == "f.obj:4: face 0 has no corners");
    REQUIRE(refusal("OFF\n3 1 0\n") == "f.obj:1: expected a statement of the OBJ format, such as v or f, found 'OFF'");
    REQUIRE(refusal(points + "cstype bezier\n") ==
            "f.obj:4: free-form geometry ('cstype') is not supported; convert it to polygons");
    REQUIRE(refusal("f 1 2 3\n") == "f.obj:1: face 0 has vertex index 3, but the file has 0 vertices");
}
