// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/mesh_error.hpp>

#include <cleave/mesh/validate.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"

#include <limits>
#include <string>

using namespace cleave;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string refusal(const Mesh& mesh, Strictness strictness = Strictness::tolerant,
                    const MeshOrigin* origin = nullptr) {
    try {
        require_valid(mesh, strictness, origin);
    } catch (const MeshError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("mesh_error: a message says what, where, and what to do") {
    const std::string open = refusal(meshes::without_face(meshes::cube(), 0));
    CAPTURE(open);
    REQUIRE(contains(open, "the mesh of 8 points and 5 faces is refused"));
    REQUIRE(contains(open, "4 open edges"));
    REQUIRE(contains(open, "from point 2 at (0, 1, 0) to point 0 at (0, 0, 0), used 1 time this way and 0 the other"));
    REQUIRE(contains(open, "first by face 3"));
    REQUIRE(contains(open, "and 1 more"));
    REQUIRE(contains(open, "add the missing face"));
    const std::string turned = refusal(meshes::with_reversed_face(meshes::cube(), 0));
    REQUIRE(contains(turned, "4 edges whose two faces run the same way"));
    REQUIRE(contains(turned, "reverse one of the faces"));
}

TEST_CASE("mesh_error: file and lines are named where they are known") {
    const Mesh mesh = meshes::without_face(meshes::cube(), 0);
    MeshOrigin origin;
    origin.file = "part.off";
    for (std::uint32_t i = 0; i < 8; ++i) origin.point_lines.push_back(3 + i);
    for (std::uint32_t i = 0; i < 5; ++i) origin.face_lines.push_back(11 + i);
    const std::string message = refusal(mesh, Strictness::tolerant, &origin);
    CAPTURE(message);
    REQUIRE(message.starts_with("part.off: "));
    REQUIRE(contains(message, "from point 2 (line 5) at (0, 1, 0) to point 0 (line 3)"));
    REQUIRE(contains(message, "first by face 3 (line 14)"));
}

TEST_CASE("mesh_error: only what the mode refuses is in the message") {
    Mesh mesh = meshes::cube();
    mesh.points[7] = {2, 2, 1.5};
    mesh.points.push_back({9, 9, 9});
    mesh.add_face({0, 0, 1});
    REQUIRE(refusal(mesh) == "accepted");
    const std::string strict = refusal(mesh, Strictness::strict);
    CAPTURE(strict);
    REQUIRE(contains(strict, "3 faces whose corners lie on no common plane"));
    REQUIRE(contains(strict, "face 1 with points 4 at (0, 0, 1), 5 at (1, 0, 1), 7 at (2, 2, 1.5), 6 at (0, 1, 1)"));
    REQUIRE(contains(strict, "1 face with fewer than three distinct corners"));
    REQUIRE_FALSE(contains(strict, "no face uses"));
    // `explain` tells everything.
    const std::string all = explain(validate(mesh), mesh);
    REQUIRE(contains(all, "1 point that no face uses:\n    point 8 at (9, 9, 9)"));
    REQUIRE(explain(validate(meshes::cube()), meshes::cube()).empty());
}

TEST_CASE("mesh_error: every kind has words, and bad indices do not break the message") {
    for (const MeshDefect kind : all_mesh_defects) {
        const auto words = cleave::detail::words_for(kind);
        REQUIRE(std::string(words.one) != words.many);
        REQUIRE_FALSE(std::string(words.advice).empty());
    }
    Mesh mesh = meshes::cube();
    mesh.corners[6] = 77;
    REQUIRE(contains(refusal(mesh), "corner 2 of face 1 is point 77 of 8"));
    mesh = meshes::cube();
    mesh.points[3][1] = std::numeric_limits<double>::quiet_NaN();
    REQUIRE(contains(refusal(mesh), "1 point with an infinite or NaN coordinate:\n    point 3 at (1, nan, 0)"));
    mesh = meshes::cube();
    mesh.points[3][1] = 0.5;
    mesh.points.push_back({0.5, 0, 0});
    Mesh split = meshes::without_face(mesh, 2);
    split.add_face({0, 8, 1, 5, 4});
    split.add_face({4, 5, 6, 7, 0, 1, 2, 3, 4, 0});
    const MeshReport report = validate(split);
    const std::string text = explain(report, split);
    CAPTURE(text);
    REQUIRE(contains(text, "T-junction") == false);
    REQUIRE(contains(text, "face 6 with points 4, 5, 6, 7, 0, 1, ... (10 corners)"));
}

TEST_CASE("mesh_error: rational coordinates are exact where short, rounded where long") {
    RationalMesh mesh = meshes::without_face(meshes::tetrahedron<Rational>(), 0);
    mesh.points[0][0] = Rational(1) / 3;
    mesh.points[1][0] = Rational(1) + Rational(1) / Rational(1e60);
    const std::string text = explain(validate(mesh), mesh);
    CAPTURE(text);
    REQUIRE(contains(text, "(1/3, 0, 0)"));
    REQUIRE(contains(text, "(about 1, 0, 0)"));
}

TEST_CASE("mesh_error: copies share the report") {
    const MeshReport report = validate(meshes::without_face(meshes::cube(), 0));
    const MeshError error("message", report);
    const MeshError copy = error;  // what throwing does
    REQUIRE(&copy.report() == &error.report());
    REQUIRE(copy.report().open_edges == report.open_edges);
    const Error& base = copy;
    REQUIRE(std::string(base.what()) == "message");
}
