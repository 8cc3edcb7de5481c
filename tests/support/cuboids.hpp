// SPDX-License-Identifier: Apache-2.0
/// Boxes with their faces cut up in different ways, as meshes and as regions: equal sets with different boundaries.
#ifndef CLEAVE_TESTS_SUPPORT_CUBOIDS_HPP
#define CLEAVE_TESTS_SUPPORT_CUBOIDS_HPP

#include "support/exact_region.hpp"

#include <cleave/mesh/to_region.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace support {

/// How each of the six faces of a cuboid is given: `pieces` x `pieces` rectangles, or twice as many triangles.
struct Surface {
    int pieces = 1;
    bool triangles = false;
};

/// One quad a face, two triangles a face, and finer divisions that do not refine each other.
inline const std::vector<Surface> all_surfaces = {{1, false}, {1, true}, {2, false}, {3, true}};

[[nodiscard]] inline cleave::RationalMesh cuboid_mesh(const Coordinates<3>& lo, const Coordinates<3>& hi,
                                                      const Surface& surface) {
    cleave::RationalMesh mesh;
    const int n = surface.pieces;
    std::map<std::array<int, 3>, std::uint32_t> vertices;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [found, is_new] = vertices.try_emplace(at, std::uint32_t(mesh.points.size()));
        if (is_new) {
            Coordinates<3> p;
            for (std::size_t i = 0; i < 3; ++i) p[i] = lo[i] + (hi[i] - lo[i]) * at[i] / n;
            mesh.points.push_back(p);
        }
        return found->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool top : {false, true}) {
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    std::array<std::uint32_t, 4> face{};
                    for (std::size_t c = 0; c < 4; ++c) {
                        std::array<int, 3> at{};
                        at[axis] = top ? n : 0;
                        // Counter-clockwise as seen against the axis: 00, 10, 11, 01.
                        at[(axis + 1) % 3] = i + (c == 1 || c == 2 ? 1 : 0);
                        at[(axis + 2) % 3] = j + (c >= 2 ? 1 : 0);
                        face[top ? c : 3 - c] = vertex(at);
                    }
                    if (!surface.triangles) {
                        mesh.add_face(face);
                        continue;
                    }
                    const auto turn = std::size_t((i + j) % 2);
                    for (const std::size_t k : {turn, turn + 2})
                        mesh.add_face({face[k % 4], face[(k + 1) % 4], face[(k + 2) % 4]});
                }
            }
        }
    }
    return mesh;
}

[[nodiscard]] inline cleave::Region<3> cuboid(const Coordinates<3>& lo, const Coordinates<3>& hi,
                                              const Surface& surface = {}) {
    return cleave::to_region(cuboid_mesh(lo, hi, surface));
}

}  // namespace support

#endif
