// SPDX-License-Identifier: Apache-2.0
/// Simplices: segments, triangles, tetrahedra.
#ifndef CLEAVE_SHAPE_SIMPLEX_HPP
#define CLEAVE_SHAPE_SIMPLEX_HPP

#include <cleave/geometry/cross_point.hpp>
#include <cleave/geometry/side.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/region/make.hpp>
#include <cleave/shape/rational_point.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The convex hull of D + 1 points in any order. Points in one hyperplane span no interior and give the empty set.
/// Throws: NumberError for a coordinate that is infinite or NaN.
template <int D, class N = Rational>
[[nodiscard]] Region<D, N> simplex(const std::array<std::array<N, std::size_t(D)>, std::size_t(D) + 1>& vertices) {
    constexpr std::size_t last = std::size_t(D);
    std::array<RationalPoint<D>, last + 1> p;
    for (std::size_t i = 0; i <= last; ++i) p[i] = to_rational_point(vertices[i]);
    std::array<Point<D, Integer>, last> base;
    for (std::size_t i = 0; i < last; ++i) base[i] = make_point<Integer>(p[i]);
    const std::optional<Plane<D, Integer>> plane = join(base);
    const Sign at = plane ? side(*plane, make_point<Integer>(p[last])) : Sign::zero;
    if (at == Sign::zero) return Region<D, N>::empty();
    if constexpr (D == 1) {
        return Region<1, N>(intervals<Rational>({{p[0][0], p[1][0]}}));
    } else {
        // Now the first D vertices are in outward order: the last one is on their inside.
        if (at == Sign::plus) std::swap(p[0], p[1]);
        if constexpr (D == 2) {
            return Region<2, N>(polygon<Rational>({p[0], p[1], p[2]}));
        } else if constexpr (D >= 4) {
            // Each facet's plane through the other vertices, the vertex that is left out on its inside.
            std::vector<Plane<D, Integer>> planes;
            for (std::size_t out = 0; out <= last; ++out) {
                for (std::size_t i = 0, j = 0; i <= last; ++i)
                    if (i != out) base[j++] = make_point<Integer>(p[i]);
                const Plane<D, Integer> h = *join(base);
                planes.push_back(side(h, make_point<Integer>(p[out])) == Sign::minus ? h : flip(h));
            }
            return Region<D, N>(half_spaces<D, Integer>(planes));
        } else {
            RationalMesh mesh;
            mesh.points.assign(p.begin(), p.end());
            mesh.add_face({0, 1, 2});
            mesh.add_face({0, 3, 1});
            mesh.add_face({1, 3, 2});
            mesh.add_face({2, 3, 0});
            return to_region<N>(mesh);
        }
    }
}

/// The same for a braced list: `simplex<2>({{0, 0}, {1, 0}, {0, 1}})`.
template <int D, class N = Rational>
[[nodiscard]] Region<D, N> simplex(const std::array<N, std::size_t(D)> (&vertices)[std::size_t(D) + 1]) {
    std::array<std::array<N, std::size_t(D)>, std::size_t(D) + 1> copy;
    for (std::size_t i = 0; i <= std::size_t(D); ++i) copy[i] = vertices[i];
    return simplex<D, N>(copy);
}

CLEAVE_END_NAMESPACE

#endif
