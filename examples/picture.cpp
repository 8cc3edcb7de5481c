// SPDX-License-Identifier: Apache-2.0
/// Draws meshes side by side into a PNG file:
///
///     picture                           a cube, a sphere and a frame, made here, into picture.png
///     picture OUT.png MESH [MESH...]    meshes from files (OFF, OBJ, STL)
#include <cleave/io/mesh_file.hpp>
#include <cleave/mesh/validate.hpp>

#include "support/render.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using cleave::Mesh;

/// A cube whose faces are polygons; the renderer splits them.
Mesh cube() {
    Mesh mesh;
    for (unsigned i = 0; i < 8; ++i) {
        mesh.points.push_back({(i & 1) != 0 ? 0.7 : -0.7, (i & 2) != 0 ? 0.7 : -0.7, (i & 4) != 0 ? 0.7 : -0.7});
    }
    for (const auto& face : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                             {4, 5, 7, 6},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 4, 6, 2},
                             {1, 3, 7, 5}}) {
        mesh.add_face(face);
    }
    return mesh;
}

/// A sphere: the octahedron, each triangle cut into four again and again, its points moved out to distance 1.
Mesh sphere(int levels) {
    Mesh mesh;
    mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<std::uint32_t, 3>> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), std::uint32_t(mesh.points.size()));
            if (is_new) {
                std::array<double, 3> p{};
                for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.points[a][i] + mesh.points[b][i];
                const double length = std::hypot(p[0], p[1], p[2]);
                mesh.points.push_back({p[0] / length, p[1] / length, p[2] / length});
            }
            return at->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        faces = std::move(finer);
    }
    for (const auto& face : faces) mesh.add_face(face);
    return mesh;
}

/// A square frame: its top and bottom are polygons with a hole, tied to the outer loop by a bridge.
Mesh frame() {
    Mesh mesh;
    for (const double z : {-0.25, 0.25}) {
        for (const double r : {1.0, 0.55}) {
            mesh.points.insert(mesh.points.end(), {{-r, -r, z}, {r, -r, z}, {r, r, z}, {-r, r, z}});
        }
    }
    mesh.add_face({8, 9, 10, 11, 8, 12, 15, 14, 13, 12});  // top: outer loop, bridge, hole, and the bridge back
    mesh.add_face({0, 4, 5, 6, 7, 4, 0, 3, 2, 1});
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        mesh.add_face({i, j, 8 + j, 8 + i});
        mesh.add_face({4 + j, 4 + i, 12 + i, 12 + j});
    }
    return mesh;
}

int draw(const std::string& file, const std::vector<Mesh>& meshes) {
    picture::View view;
    view.panel_width = view.panel_height = 400;
    std::vector<picture::Scene> scenes;
    for (const Mesh& mesh : meshes) {
        cleave::require_valid(mesh);
        scenes.push_back({{mesh, {picture::operand_colours[scenes.size() % picture::operand_colours.size()]}}});
    }
    const picture::Image image = picture::render(scenes, view);
    picture::write_png(file, image);
    std::printf("%s: %zu meshes, %zu x %zu pixels\n", file.c_str(), meshes.size(), image.width, image.height);
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    try {
        if (count == 1) return draw("picture.png", {cube(), sphere(5), frame()});
        if (count == 2) {
            std::fprintf(stderr, "usage: picture OUT.png MESH [MESH...]\n");
            return 2;
        }
        std::vector<Mesh> meshes;
        for (int i = 2; i < count; ++i) meshes.push_back(cleave::read_mesh(arguments[i]));
        return draw(arguments[1], meshes);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
