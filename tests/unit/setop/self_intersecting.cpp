// SPDX-License-Identifier: Apache-2.0
// Operands that intersect themselves bound no set. Whatever an operation makes of them, it ends: with a region or with
// an error, and with regions that stand being used again.
#include <cleave/geometry/double_predicates.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/setop/engines.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>

using namespace cleave;
using support::Dice;

namespace {

/// Tetrahedra thrown together in one mesh, each closed, here and there one inside out.
Mesh heap(Dice& dice) {
    Mesh mesh;
    for (int n = dice.between(1, 4); n > 0; --n) {
        const auto base = static_cast<std::uint32_t>(mesh.points.size());
        for (int p = 0; p < 4; ++p)
            mesh.points.push_back({double(dice.between(0, 4)), double(dice.between(0, 4)), double(dice.between(0, 4))});
        const bool turned = (plane_side(mesh.points[base], mesh.points[base + 1], mesh.points[base + 2],
                                        mesh.points[base + 3]) == Sign::minus) != (dice.below(8) == 0);
        constexpr std::array<std::array<std::uint32_t, 3>, 4> faces = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
        for (const auto& f : faces) mesh.add_face({base + f[0], base + f[turned ? 2 : 1], base + f[turned ? 1 : 2]});
    }
    return mesh;
}

}  // namespace

TEST_CASE("self-intersecting operands: every operation ends, in a region or an error") {
    Dice dice(7);
    std::size_t done = 0;
    std::size_t refused = 0;
    for (std::size_t n = 0; n < scaled(100); ++n) {
        Region<3> a;
        Region<3> b;
        try {
            a = to_region(heap(dice));
            b = to_region(heap(dice));
        } catch (const Error&) {
            continue;  // inside out, or flat
        }
        for (const Operation operation : all_operations) {
            try {
                const Region<3> r = apply(operation, a, b);
                (void)to_mesh(r);
                (void)apply(operation, r, a);
                ++done;
            } catch (const std::exception&) {  // with contracts checked, a broken assertion may be first to tell
                ++refused;
            }
        }
    }
    CHECK(done > refused);
}
