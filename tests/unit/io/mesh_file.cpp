// SPDX-License-Identifier: Apache-2.0
/// Mesh files by name; damaged files of every kind.
#include <cleave/io/mesh_file.hpp>

#include <cleave/mesh/validate.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

#include <random>
#include <string>
#include <string_view>

using namespace cleave;

namespace {

std::string message(const auto& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("mesh_file: the extension chooses the format") {
    REQUIRE(mesh_format("a.off") == MeshFormat::off);
    REQUIRE(mesh_format("dir.stl/a.OBJ") == MeshFormat::obj);
    REQUIRE(mesh_format("a.off.Stl") == MeshFormat::stl);
    REQUIRE(message([] { (void)mesh_format("a.ply"); }) ==
            "a.ply: has the unknown extension '.ply'; expected .off, .obj or .stl");
    REQUIRE(message([] { (void)mesh_format("dir.off/a"); }) ==
            "dir.off/a: has no extension; expected .off, .obj or .stl");
}

TEST_CASE("mesh_file: what is written reads back, in every format") {
    const TemporaryFolder folder;
    const Mesh mesh = meshes::triangle_cube();
    for (const char* name : {"a.off", "a.obj", "a.stl", "b.OFF", "b.Obj", "b.sTL"}) {
        REQUIRE(write_mesh(folder.file(name), mesh).is_exact());
        const Mesh read = read_mesh(folder.file(name));
        REQUIRE(read.face_count() == 12);
        REQUIRE(validate(read).is_valid(Strictness::strict));
        if (mesh_format(name) != MeshFormat::stl) REQUIRE(read == mesh);
    }
    REQUIRE(folder.count() == 6);
    const RationalMesh thirds = meshes::cube<Rational>(Rational(1) / 3, 1);
    for (const char* name : {"r.off", "r.obj"}) {
        REQUIRE(write_mesh(folder.file(name), thirds).is_exact());
        REQUIRE(read_mesh<Rational>(folder.file(name)) == thirds);
        REQUIRE(message([&] { (void)read_mesh(folder.file(name)); }).find("read this file as rationals") !=
                std::string::npos);
    }
    REQUIRE(write_mesh(folder.file("r.stl"), thirds).rounded_coordinates == 12);
}

TEST_CASE("mesh_file: errors name the file") {
    const TemporaryFolder folder;
    const auto why = [&](const std::filesystem::path& path) { return message([&] { (void)read_mesh(path); }); };
    REQUIRE(why(folder.write("empty.off", "")) == folder.file("empty.off").string() + ": is empty");
    REQUIRE(why(folder.file("missing.obj")).starts_with(folder.file("missing.obj").string() + ": cannot be opened: "));
    REQUIRE(why(folder.path()).find("has no extension") != std::string::npos);
    std::filesystem::create_directory(folder.file("dir.off"));
    REQUIRE(why(folder.file("dir.off")) ==
            folder.file("dir.off").string() + ": is a directory; name a mesh file in it");
    REQUIRE(why(folder.write("bad.off", "OFF\n1 0 0\n0 0 x\n"))
                .starts_with(folder.file("bad.off").string() + ":3: expected the z coordinate of vertex 0, found 'x'"));
}

TEST_CASE("mesh_file: nothing is left behind where writing fails") {
    const TemporaryFolder folder;
    REQUIRE(message([&] { write_mesh(folder.file("a.stl"), meshes::cube(0.0, 1e200)); }).find("too large for STL") !=
            std::string::npos);
    REQUIRE(message([&] { write_mesh(folder.file("a.xyz"), meshes::cube()); }).find("unknown extension") !=
            std::string::npos);
    REQUIRE(folder.count() == 0);
}

TEST_CASE("mesh_file: the origin carries the lines into the message about the mesh") {
    const TemporaryFolder folder;
    const auto path = folder.write("open.off", write_off(meshes::without_face(meshes::cube(), 2)));
    MeshOrigin origin;
    const Mesh mesh = read_mesh(path, &origin);
    const std::string why = message([&] { require_valid(mesh, Strictness::tolerant, &origin); });
    CAPTURE(why);
    REQUIRE(why.starts_with(path.string() + ": the mesh of 8 points and 5 faces is refused"));
    REQUIRE(why.find("first by face 0 (line 11)") != std::string::npos);
}

TEST_CASE("mesh_file: damaged files end in a mesh or in an error, never in anything else") {
    const std::string number_soup =
        "OFF\n4 4 6\n0 0 0 # origin\n1e0 0 0\n0 +.1e1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3 255 0 0\n";
    const std::string obj =
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nf 1 3 2\nf 1/1 2/2 \\\n4/4\nf 2//1 3//1 4//1\nf "
        "-2 -4 -1\n";
    const std::string rational = write_off(meshes::cube<Rational>(Rational(-1) / 3, Rational(22) / 7));
    const Mesh tetrahedron = meshes::tetrahedron();
    const std::string text_stl = write_stl(tetrahedron, StlKind::text), binary_stl = write_stl(tetrahedron);
    std::mt19937 random(20240607);
    std::size_t meshes_read = 0, errors = 0;
    const auto try_all = [&](const std::string& bytes) {
        const auto attempt = [&](const auto& read) {
            try {
                const auto mesh = read();
                ++meshes_read;
                const MeshReport report = validate(mesh);
                REQUIRE(report.complete);  // readers let no bad index and no infinity through
                (void)explain(report, mesh);
            } catch (const FileError&) {
                ++errors;
            }
        };
        attempt([&] { return read_off(bytes); });
        attempt([&] { return read_off<Rational>(bytes); });
        attempt([&] { return read_obj(bytes); });
        attempt([&] { return read_stl(bytes); });
    };
    using namespace std::string_view_literals;
    constexpr std::string_view favourites = " \n\r\t\\#/-+.eE019nv\xff\0"sv;
    for (const std::string& seed : {number_soup, obj, rational, text_stl, binary_stl}) {
        try_all(seed);
        for (std::size_t i = 0; i < scaled(2000); ++i) {
            std::string bytes = seed;
            for (std::size_t n = 1 + random() % 4; n > 0; --n) {
                const std::size_t at = random() % bytes.size();
                switch (random() % 5) {
                    case 0:
                        bytes[at] = static_cast<char>(random());
                        break;
                    case 1:
                        bytes[at] = favourites[random() % favourites.size()];
                        break;
                    case 2:
                        bytes.erase(at, 1 + random() % 8);
                        break;
                    case 3:
                        bytes.insert(at, 1, favourites[random() % favourites.size()]);
                        break;
                    default:
                        bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 20));
                        break;
                }
                if (bytes.empty()) bytes = " ";
            }
            if (random() % 8 == 0) bytes.resize(random() % bytes.size());
            try_all(bytes);
        }
    }
    REQUIRE(meshes_read > scaled(100));
    REQUIRE(errors > scaled(100));
}
