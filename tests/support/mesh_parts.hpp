// SPDX-License-Identifier: Apache-2.0
/// Meshes put together from parts that cross each other, and the sets that winding rules make of them, found out from
/// the parts one by one.
#ifndef CLEAVE_TESTS_SUPPORT_MESH_PARTS_HPP
#define CLEAVE_TESTS_SUPPORT_MESH_PARTS_HPP

#include "support/dice.hpp"
#include "support/exact_region.hpp"

#include <cleave/extern.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace support {

/// One mesh after another, as one mesh.
template <class T>
[[nodiscard]] cleave::PolygonMesh<T> together(cleave::PolygonMesh<T> a, const cleave::PolygonMesh<T>& b) {
    const auto shift = static_cast<std::uint32_t>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (std::size_t f = 0; f < b.face_count(); ++f) {
        std::vector<std::uint32_t> corners(b.face(f).begin(), b.face(f).end());
        for (std::uint32_t& c : corners) c += shift;
        a.add_face(corners);
    }
    return a;
}

/// The mesh with all faces turned over.
template <class T>
[[nodiscard]] cleave::PolygonMesh<T> inside_out(cleave::PolygonMesh<T> a) {
    for (std::size_t f = 0; f < a.face_count(); ++f)
        std::reverse(a.corners.begin() + a.first[f], a.corners.begin() + a.first[f + 1]);
    return a;
}

/// A box of six quadrilaterals.
template <class T = double>
[[nodiscard]] cleave::PolygonMesh<T> block(const std::array<int, 3>& lo, const std::array<int, 3>& hi) {
    cleave::PolygonMesh<T> m;
    for (unsigned i = 0; i < 8; ++i) {
        const auto at = [&](unsigned axis) { return T(((i >> axis) & 1U) != 0 ? hi[axis] : lo[axis]); };
        m.points.push_back({at(0), at(1), at(2)});
    }
    for (const std::array<std::uint32_t, 4>& f : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                                                  {4, 5, 7, 6},
                                                  {0, 1, 5, 4},
                                                  {2, 6, 7, 3},
                                                  {0, 4, 6, 2},
                                                  {1, 3, 7, 5}})
        m.add_face(f);
    return m;
}

/// A mesh of solids that may cross, some of them inside out.
template <class T>
struct MeshParts {
    std::vector<cleave::PolygonMesh<T>> solids;  ///< each facing outward
    std::vector<int> signs;                      ///< of what is added to the mesh: 1 as it is, -1 inside out

    void add(cleave::PolygonMesh<T> solid, int sign) {
        solids.push_back(std::move(solid));
        signs.push_back(sign);
    }

    [[nodiscard]] cleave::PolygonMesh<T> mesh() const {
        cleave::PolygonMesh<T> all;
        for (std::size_t i = 0; i < solids.size(); ++i)
            all = together(std::move(all), signs[i] > 0 ? solids[i] : inside_out(solids[i]));
        return all;
    }

    /// What a rule makes of the mesh, as the value of a Boolean function of the solids.
    [[nodiscard]] cleave::Region<3> expected(cleave::WindingRule rule) const {
        const auto n = static_cast<unsigned>(solids.size());
        cleave::BooleanFunction function = cleave::BooleanFunction::constant(false, n);
        for (unsigned subset = 0; subset < (1U << n); ++subset) {
            int winding = 0;
            cleave::BooleanFunction term = cleave::BooleanFunction::constant(true, n);
            for (unsigned i = 0; i < n; ++i) {
                const bool inside = ((subset >> i) & 1U) != 0;
                winding += inside ? signs[i] : 0;
                const cleave::BooleanFunction operand = cleave::BooleanFunction::operand(i, n);
                term = inside ? term & operand : term & ~operand;
            }
            if (cleave::is_inside(rule, winding)) function = function | term;
        }
        std::vector<cleave::Region<3>> regions;
        for (const auto& solid : solids) regions.push_back(cleave::to_region(solid));
        return cleave::evaluate(function, std::span<const cleave::Region<3>>(regions));
    }
};

/// A tetrahedron with corners drawn from the integers 0 ... range, facing outward.
template <class T = double>
[[nodiscard]] cleave::PolygonMesh<T> draw_tetrahedron(Dice& dice, int range) {
    for (;;) {
        std::array<std::array<int, 3>, 4> p{};
        for (auto& q : p)
            for (int& x : q) x = dice.below(range + 1);
        std::array<std::array<int, 3>, 3> d{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t x = 0; x < 3; ++x) d[i][x] = p[i + 1][x] - p[0][x];
        const int det = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                        d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                        d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
        if (det == 0) continue;
        if (det < 0) std::swap(p[0], p[1]);
        cleave::PolygonMesh<T> m;
        for (const auto& q : p) m.points.push_back({T(q[0]), T(q[1]), T(q[2])});
        for (const std::array<std::uint32_t, 3>& f :
             {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
            m.add_face(f);
        return m;
    }
}

/// A box with corners drawn from the integers 0 ... range.
template <class T = double>
[[nodiscard]] cleave::PolygonMesh<T> draw_block(Dice& dice, int range) {
    std::array<int, 3> lo{}, hi{};
    for (std::size_t i = 0; i < 3; ++i) {
        lo[i] = dice.below(range);
        hi[i] = dice.between(lo[i] + 1, range);
    }
    return block<T>(lo, hi);
}

/// Up to `most` boxes and tetrahedra on small integers, each facing either way, now and then one of them twice.
template <class T = double>
[[nodiscard]] MeshParts<T> draw_parts(Dice& dice, int most, int range) {
    MeshParts<T> parts;
    for (int n = dice.between(1, most); n > 0; --n) {
        const int sign = dice.below(3) == 0 ? -1 : 1;
        if (!parts.solids.empty() && dice.below(6) == 0)
            parts.add(parts.solids[std::size_t(dice.below(int(parts.solids.size())))], sign);
        else if (dice.below(2) == 0)
            parts.add(draw_block<T>(dice, range), sign);
        else
            parts.add(draw_tetrahedron<T>(dice, range), sign);
    }
    return parts;
}

}  // namespace support

#endif
