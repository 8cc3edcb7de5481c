// SPDX-License-Identifier: Apache-2.0
/// Operands for the benchmarks of set operations: made by code, and real meshes where CLEAVE_MODELS_DIR names a folder.
#ifndef CLEAVE_BENCHMARKS_SOLIDS_HPP
#define CLEAVE_BENCHMARKS_SOLIDS_HPP

#include <cleave/io/mesh_file.hpp>
#include <cleave/mesh/polygon_mesh.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace solids {

using cleave::Mesh;

/// A cube of 12 triangles.
inline Mesh cube(double x, double y, double z, double size) {
    Mesh mesh;
    for (unsigned i = 0; i < 8; ++i)
        mesh.points.push_back({x + size * (i & 1U), y + size * ((i >> 1U) & 1U), z + size * ((i >> 2U) & 1U)});
    const std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& s : sides) {
        mesh.add_face({s[0], s[1], s[2]});
        mesh.add_face({s[0], s[2], s[3]});
    }
    return mesh;
}

/// A sphere of 4 rings (rings - 1) triangles, corners rounded to doubles.
inline Mesh sphere(unsigned rings, double x) {
    Mesh mesh;
    const unsigned slices = 2 * rings;
    const double pi = 3.14159265358979323846;
    mesh.points.push_back({x, 0, 1});
    for (unsigned r = 1; r < rings; ++r)
        for (unsigned s = 0; s < slices; ++s) {
            const double theta = pi * r / rings;
            const double phi = 2 * pi * s / slices;
            mesh.points.push_back(
                {x + std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
        }
    mesh.points.push_back({x, 0, -1});
    const auto at = [&](unsigned r, unsigned s) { return 1 + (r - 1) * slices + s % slices; };
    const auto last = static_cast<std::uint32_t>(mesh.points.size() - 1);
    for (unsigned s = 0; s < slices; ++s) {
        mesh.add_face({0, at(1, s), at(1, s + 1)});
        for (unsigned r = 1; r + 1 < rings; ++r) {
            mesh.add_face({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            mesh.add_face({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
        mesh.add_face({at(rings - 1, s + 1), at(rings - 1, s), last});
    }
    return mesh;
}

/// The mesh turned about its mean corner by the rotation whose cosine is 3/5, around the x axis; corners are rounded.
inline Mesh rotated(Mesh mesh) {
    std::array<double, 3> centre{0, 0, 0};
    for (const auto& p : mesh.points)
        for (std::size_t i = 0; i < 3; ++i) centre[i] += p[i] / static_cast<double>(mesh.points.size());
    for (auto& p : mesh.points) {
        const double y = p[1] - centre[1];
        const double z = p[2] - centre[2];
        p[1] = 0.6 * y - 0.8 * z + centre[1];
        p[2] = 0.8 * y + 0.6 * z + centre[2];
    }
    return mesh;
}

/// A real mesh, or nullopt where there is none on this machine.
inline std::optional<Mesh> model(const std::string& name) {
    const char* folder = std::getenv("CLEAVE_MODELS_DIR");
    if (folder == nullptr) return std::nullopt;
    const std::filesystem::path path = std::filesystem::path(folder) / (name + ".off");
    if (!std::filesystem::exists(path)) return std::nullopt;
    return cleave::read_mesh(path);
}

}  // namespace solids

#endif
