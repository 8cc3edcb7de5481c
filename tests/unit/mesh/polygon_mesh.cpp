// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/polygon_mesh.hpp>

#include "support/catch.hpp"

#include <utility>
#include <vector>

using namespace cleave;

TEST_CASE("polygon_mesh: faces come back as they were added") {
    Mesh mesh;
    REQUIRE(mesh.face_count() == 0);
    REQUIRE(mesh.point_count() == 0);
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.add_face({0, 1, 2});
    mesh.add_face({});
    mesh.add_face(std::vector<std::uint32_t>{0, 1, 2, 3});
    REQUIRE(mesh.face_count() == 3);
    REQUIRE(std::vector<std::uint32_t>(mesh.face(0).begin(), mesh.face(0).end()) ==
            std::vector<std::uint32_t>{0, 1, 2});
    REQUIRE(mesh.face(1).empty());
    REQUIRE(mesh.face(2).size() == 4);
    REQUIRE(mesh.face(2)[3] == 3);
}

TEST_CASE("polygon_mesh: a moved-from mesh has no faces and takes new ones") {
    Mesh mesh;
    mesh.add_face({0, 1, 2});
    const Mesh other = std::move(mesh);
    REQUIRE(other.face_count() == 1);
    mesh.first.clear();  // what a move may leave, made certain
    mesh.corners.clear();
    REQUIRE(mesh.face_count() == 0);
    mesh.add_face({3, 4, 5});
    REQUIRE(mesh.face_count() == 1);
    REQUIRE(mesh.face(0)[0] == 3);
}

TEST_CASE("polygon_mesh: equality is of values") {
    RationalMesh a, b;
    a.points = {{Rational(1) / 3, 0, 0}};
    b.points = {{Rational(2) / 6, 0, 0}};
    REQUIRE(a == b);
    b.add_face({0});
    REQUIRE_FALSE(a == b);
}
