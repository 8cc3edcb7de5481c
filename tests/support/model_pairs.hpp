// SPDX-License-Identifier: Apache-2.0
/// Real meshes in pairs: which ones, and where the second is put.
#ifndef CLEAVE_TESTS_SUPPORT_MODEL_PAIRS_HPP
#define CLEAVE_TESTS_SUPPORT_MODEL_PAIRS_HPP

#include <cleave/io/mesh_file.hpp>
#include <cleave/mesh/polygon_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace support {

struct Model {
    std::string name;
    cleave::Mesh mesh;
};

/// All models with at most `faces` faces, smallest first.
[[nodiscard]] inline std::vector<Model> models_up_to(const std::filesystem::path& folder, std::size_t faces) {
    std::vector<Model> models;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".off" || entry.file_size() > 400 * faces + 4000) continue;
        cleave::Mesh mesh = cleave::read_mesh(entry.path());
        if (mesh.face_count() <= faces) models.push_back({entry.path().stem().string(), std::move(mesh)});
    }
    std::sort(models.begin(), models.end(), [](const Model& a, const Model& b) {
        return std::pair(a.mesh.face_count(), a.name) < std::pair(b.mesh.face_count(), b.name);
    });
    return models;
}

/// The least and the greatest coordinates.
using Extent = std::array<std::array<double, 3>, 2>;

[[nodiscard]] inline Extent extent(const cleave::Mesh& mesh) {
    Extent e{mesh.points[0], mesh.points[0]};
    for (const auto& p : mesh.points)
        for (std::size_t i = 0; i < 3; ++i) {
            e[0][i] = std::min(e[0][i], p[i]);
            e[1][i] = std::max(e[1][i], p[i]);
        }
    return e;
}

/// B scaled to A's box and shifted by (1/3, 1/5, 1/7) of it, so that both boundaries contribute.
[[nodiscard]] inline cleave::Mesh placed(const cleave::Mesh& a, cleave::Mesh b) {
    const Extent to = extent(a);
    const Extent from = extent(b);
    const std::array<double, 3> shift{1.0 / 3, 1.0 / 5, 1.0 / 7};
    for (auto& p : b.points)
        for (std::size_t i = 0; i < 3; ++i) {
            const double size = to[1][i] - to[0][i];
            p[i] = to[0][i] + ((p[i] - from[0][i]) / (from[1][i] - from[0][i]) + shift[i]) * size;
        }
    return b;
}

/// Whether CLEAVE_ALL_PAIRS asks for every pair, and not for each model with the next two in size only.
[[nodiscard]] inline bool all_pairs() {
    return std::getenv("CLEAVE_ALL_PAIRS") != nullptr;
}

/// Calls f with the pairs, of models in the order of their sizes.
template <class F>
void for_each_pair(const std::vector<Model>& models, F&& f) {
    for (std::size_t i = 0; i < models.size(); ++i)
        for (std::size_t j = i + 1; j < models.size() && (all_pairs() || j <= i + 2); ++j) f(models[i], models[j]);
}

}  // namespace support

#endif
