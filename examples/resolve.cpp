// SPDX-License-Identifier: Apache-2.0
// A mesh whose faces cross each other: found, and resolved by each winding rule.
#include <cleave.hpp>

#include <array>
#include <cstdint>
#include <iostream>
#include <vector>
using namespace cleave;

namespace {

/// Adds the faces of a solid to a mesh.
void add(Mesh& mesh, const Region<3>& solid) {
    const Mesh part = to_mesh(solid);
    const auto shift = static_cast<std::uint32_t>(mesh.point_count());
    mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
    for (std::size_t f = 0; f < part.face_count(); ++f) {
        std::vector<std::uint32_t> corners(part.face(f).begin(), part.face(f).end());
        for (std::uint32_t& c : corners) c += shift;
        mesh.add_face(corners);
    }
}

}  // namespace

int main() {
    // [resolve]
    Mesh mesh;
    add(mesh, box<3>({0, 0, 0}, {2, 2, 2}));
    add(mesh, box<3>({1, 1, 1}, {3, 3, 3}));
    try {
        ToRegionOptions options;
        options.check_self_intersections = true;
        const Region<3> solid = to_region(mesh, options);
    } catch (const SelfIntersectionError& error) {
        std::cout << error.contacts().size() << " pairs of faces cross\n";
    }
    for (const WindingRule rule : all_winding_rules)
        std::cout << to_text(rule) << ": volume " << *measure(resolve(mesh, rule)) << '\n';
    // [/resolve]
    using Loop = std::vector<std::array<Rational, 2>>;
    const Loop star{{0, 5}, {-3, -4}, {5, 0}, {-5, 0}, {3, -4}};
    const Region<2> all = resolve<Rational>(star, WindingRule::non_zero);
    const Region<2> tips = resolve<Rational>(star, WindingRule::even_odd);
    std::cout << "a star of area " << *measure(all) << ", its tips " << *measure(tips) << '\n';
    return equal(all, tips) ? 1 : 0;
}
