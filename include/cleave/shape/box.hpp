// SPDX-License-Identifier: Apache-2.0
/// Axis-parallel boxes: intervals, rectangles, cuboids.
#ifndef CLEAVE_SHAPE_BOX_HPP
#define CLEAVE_SHAPE_BOX_HPP

#include <cleave/mesh/to_region.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/region/make.hpp>
#include <cleave/shape/rational_point.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The box between two opposite corners: `box<3>({0, 0, 0}, {2, 2, Rational(1, 3)})`. For each axis the two ends may
/// come in either order. A box without extent along some axis has no interior and is the empty set.
/// Faces: 2 D, in 3-D six rectangles in the order -x, +x, -y, +y, -z, +z.
/// Throws: NumberError for a coordinate that is infinite or NaN.
template <int D, class N = Rational>
[[nodiscard]] Region<D, N> box(const std::array<N, std::size_t(D)>& corner,
                               const std::array<N, std::size_t(D)>& opposite) {
    RationalPoint<D> lo = to_rational_point(corner);
    RationalPoint<D> hi = to_rational_point(opposite);
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        if (lo[i] == hi[i]) return Region<D, N>::empty();
        if (hi[i] < lo[i]) std::swap(lo[i], hi[i]);
    }
    if constexpr (D == 1) {
        return Region<1, N>(intervals<Rational>({{lo[0], hi[0]}}));
    } else if constexpr (D == 2) {
        return Region<2, N>(polygon<Rational>({{lo[0], lo[1]}, {hi[0], lo[1]}, {hi[0], hi[1]}, {lo[0], hi[1]}}));
    } else if constexpr (D >= 4) {
        std::vector<Plane<D, Rational>> planes;
        for (std::size_t i = 0; i < std::size_t(D); ++i) {
            typename Plane<D, Rational>::Coefficients low;
            for (Rational& x : low) x = 0;
            typename Plane<D, Rational>::Coefficients high = low;
            low[i] = -1;
            low[D] = lo[i];
            high[i] = 1;
            high[D] = -hi[i];
            planes.emplace_back(std::move(low));
            planes.emplace_back(std::move(high));
        }
        return Region<D, N>(half_spaces<D, Rational>(planes));
    } else {
        RationalMesh mesh;
        for (std::size_t corner_bits = 0; corner_bits < 8; ++corner_bits) {
            RationalPoint<3> p;
            for (std::size_t i = 0; i < 3; ++i) p[i] = ((corner_bits >> i) & 1U) != 0 ? hi[i] : lo[i];
            mesh.points.push_back(std::move(p));
        }
        // Bit i of a point's number says whether it is at the upper end of axis i.
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t u = 1U << ((axis + 1) % 3);
            const std::uint32_t v = 1U << ((axis + 2) % 3);
            const std::uint32_t top = 1U << axis;
            mesh.add_face({0, v, u + v, u});
            mesh.add_face({top, top + u, top + u + v, top + v});
        }
        return to_region<N>(mesh);
    }
}

CLEAVE_END_NAMESPACE

#endif
