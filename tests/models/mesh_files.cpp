// SPDX-License-Identifier: Apache-2.0
/// Real models: all read, in doubles and in rationals, and all are closed, oriented and without defects.
#include <cleave/io/mesh_file.hpp>
#include <cleave/mesh/validate.hpp>

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <map>
#include <string>
#include <utility>

using namespace cleave;

TEST_CASE("models: every OFF file in the folder is a closed oriented mesh of flat faces") {
    if (!models_dir()) CLEAVE_SKIP("CLEAVE_MODELS_DIR is not set");
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*models_dir())) {
        if (entry.path().extension() != ".off") continue;
        CAPTURE(entry.path().string());
        const Mesh mesh = read_mesh(entry.path());
        REQUIRE(validate(mesh).is_valid(Strictness::strict));
        // Through text and back nothing changes, and decimals read exactly give the same surface.
        REQUIRE(read_off(write_off(mesh)) == mesh);
        if (mesh.face_count() < 20000) {
            const RationalMesh exact = read_mesh<Rational>(entry.path());
            REQUIRE(exact.corners == mesh.corners);
            REQUIRE(validate(exact).is_valid(Strictness::strict));
            REQUIRE(to_double(exact.points[0][0]) == mesh.points[0][0]);
        }
        ++count;
    }
    REQUIRE(count > 0);
}

TEST_CASE("models: known numbers of vertices and faces") {
    if (!models_dir()) CLEAVE_SKIP("CLEAVE_MODELS_DIR is not set");
    const std::map<std::string, std::pair<std::size_t, std::size_t>> known{{"cube_12.off", {8, 12}},
                                                                           {"letter_p_52.off", {26, 52}},
                                                                           {"joint_446.off", {221, 446}},
                                                                           {"helmet_1k.off", {496, 1000}},
                                                                           {"spot_6k.off", {2930, 5856}},
                                                                           {"knot2_12k.off", {5760, 11520}},
                                                                           {"cheese_18k.off", {8629, 17786}},
                                                                           {"rocker_arm_20k.off", {10044, 20088}},
                                                                           {"thingi_73416_77k.off", {38396, 76840}},
                                                                           {"armadillo_100k.off", {49999, 99994}}};
    std::size_t found = 0;
    for (const auto& [name, counts] : known) {
        if (!std::filesystem::exists(*models_dir() / name)) continue;
        const Mesh mesh = read_mesh(*models_dir() / name);
        CAPTURE(name);
        REQUIRE(mesh.point_count() == counts.first);
        REQUIRE(mesh.face_count() == counts.second);
        ++found;
    }
    if (found == 0) CLEAVE_SKIP("none of the known models is in CLEAVE_MODELS_DIR");
}

TEST_CASE("models: a model without one of its faces is refused, and the message says where") {
    CLEAVE_MODEL_OR_SKIP(path, "spot_6k.off");
    Mesh mesh = read_mesh(path);
    const std::vector<std::uint32_t> last(mesh.face(5855).begin(), mesh.face(5855).end());
    mesh.corners.resize(mesh.corners.size() - 3);
    mesh.first.pop_back();
    const MeshReport report = validate(mesh);
    REQUIRE(report.open_edges.size() == 3);
    for (const EdgeDefect& edge : report.open_edges) {
        REQUIRE(std::count(last.begin(), last.end(), edge.from) == 1);
        REQUIRE(std::count(last.begin(), last.end(), edge.to) == 1);
    }
    REQUIRE_THROWS_AS(require_valid(mesh), MeshError);
}

TEST_CASE("models: a model survives binary STL up to rounding") {
    CLEAVE_MODEL_OR_SKIP(path, "spot_6k.off");
    const Mesh mesh = read_mesh(path);
    const TemporaryFolder folder;
    const StlRounding rounding = write_mesh(folder.file("spot.stl"), mesh);
    REQUIRE(rounding.rounded_coordinates > 0);
    REQUIRE(rounding.lost_triangles == 0);
    const Mesh read = read_mesh(folder.file("spot.stl"));
    REQUIRE(read.point_count() == mesh.point_count());
    REQUIRE(read.face_count() == mesh.face_count());
    REQUIRE(validate(read).is_closed());
}
