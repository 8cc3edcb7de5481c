// SPDX-License-Identifier: Apache-2.0
/// Regions from half-spaces, in any dimension, bounded or not.
#ifndef CLEAVE_REGION_CONVEX_HPP
#define CLEAVE_REGION_CONVEX_HPP

#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/number/rational.hpp>
#include <cleave/region/far_point.hpp>
#include <cleave/region/polytope_faces.hpp>
#include <cleave/region/region.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The boundary of a convex cell, one face for each of its facets that is not at infinity, in the order of `cuts`.
/// `cuts` are the planes that made it, the cell on their minus sides; face i of the list has source (0, index of cut).
template <int D>
[[nodiscard]] Boundary<D> boundary_of_cell(Kernel<D>& kernel, const Polytope& cell, std::span<const PlaneId> cuts) {
    const std::vector<PolytopeFace> facets = largest_faces(cell);
    PolytopeCutter<D> cutter(kernel);
    PointInterner<D> points(kernel);
    FaceList list;
    std::vector<Corner> loop;
    bool far = true;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        far = far && side_of_far_point(kernel.planes, cuts[i]) == Sign::minus;
        if (std::find(cuts.begin(), cuts.begin() + std::ptrdiff_t(i), cuts[i]) != cuts.begin() + std::ptrdiff_t(i))
            continue;
        for (const PolytopeFace& facet : facets) {
            if (facet.plane != unoriented(cuts[i])) continue;
            Polytope body = subpolytope(cell, facet.vertices);
            cutter.find_edges(body);
            loop.clear();
            append_loop(kernel, cuts[i], body, loop);
            list.begin_face(cuts[i], {0, static_cast<std::uint32_t>(i)});
            list.add_loop(loop);
        }
    }
    return freeze(kernel, list, far, points);
}

/// The intersection of half-spaces: all points on the minus sides of the planes. Bounded or not; empty where the
/// half-spaces are inconsistent or leave no interior, full where there are none. Sources count planes.
/// Cost: one cut of the polytope so far for each plane.
template <int D, ExactRing N>
[[nodiscard]] Region<D> half_spaces(std::span<const Plane<D, N>> planes) {
    Kernel<D> kernel;
    PolytopeCutter<D> cutter(kernel);
    Polytope cell = universe(kernel);
    std::vector<PlaneId> cuts;
    for (const Plane<D, N>& plane : planes) {
        const Plane<D, Integer> exact = make_plane<Integer>(plane.coefficients());
        const PlaneId h = kernel.planes.intern(exact.coefficients());
        cuts.push_back(h);
        PolytopeSplit s = cutter.split(h, cell);
        if (s.side == FacetSide::plus) return Region<D>::empty();
        if (s.side == FacetSide::crossing) cell = std::move(s.minus);
    }
    if (cuts.empty()) return Region<D>::full();
    return Region<D>(boundary_of_cell<D>(kernel, cell, cuts));
}

/// One half-space: the points on the minus side of the plane.
template <int D, ExactRing N>
[[nodiscard]] Region<D> half_space(const Plane<D, N>& plane) {
    return half_spaces<D, N>(std::span<const Plane<D, N>>(&plane, 1));
}

CLEAVE_END_NAMESPACE

#endif
