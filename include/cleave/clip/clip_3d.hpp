// SPDX-License-Identifier: Apache-2.0
/// Cutting convex polygons by planes: signs of the vertices, then one walk round the loop.
///
/// | signs of the vertices  | result                                          |
/// |------------------------|-------------------------------------------------|
/// | all 0                  | on: three of them are not on one line           |
/// | - and 0 only           | minus part, untouched                           |
/// | 0 and + only           | plus part, untouched                            |
/// | - and + occur          | crossing: the walk of clip/loop.hpp, five cases |
///
/// A new vertex x is the meet of the facet's plane, the edge's plane and h. It exists because the edge plane is never
/// coplanar with the facet, and because the ends of the edge are on different sides of h.
#ifndef CLEAVE_CLIP_CLIP_3D_HPP
#define CLEAVE_CLIP_CLIP_3D_HPP

#include <cleave/clip/coincident.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/clip/facet.hpp>
#include <cleave/clip/loop.hpp>

#include <cstddef>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// The side of a facet; leaves the signs of its vertices in `signs`.
template <ExactRing N>
[[nodiscard]] FacetSide side_by_vertices(const Plane<3, N>& h, const Facet<3, N>& f, std::vector<Sign>& signs) {
    VertexSigns all;
    signs.clear();
    for (const FacetCorner<N>& c : f.corners) {
        signs.push_back(side(h, c.point));
        all.add(signs.back());
    }
    return all.all_zero() ? coincident_side(relation(h, f.plane)) : all.side();
}

}  // namespace detail

/// Where the facet lies. Cost: one side test a vertex.
template <ExactRing N>
[[nodiscard]] FacetSide side(const Plane<3, N>& h, const Facet<3, N>& f) {
    std::vector<Sign> signs;
    return detail::side_by_vertices(h, f, signs);
}

/// The parts of the facet. Cost: one side test a vertex, and two meets where it is crossed in two edges.
template <ExactRing N>
[[nodiscard]] Split<Facet<3, N>> split(const Plane<3, N>& h, const Facet<3, N>& f) {
    std::vector<Sign> signs;
    const FacetSide where = detail::side_by_vertices(h, f, signs);
    if (where != FacetSide::crossing) return unsplit(where, f);
    Split<Facet<3, N>> result;
    result.minus = Facet<3, N>{f.plane, {}};
    result.plus = Facet<3, N>{f.plane, {}};
    const std::span<const FacetCorner<N>> loop(f.corners);
    split_loop(
        loop, std::span<const Sign>(signs), h, flip(h),
        [&](std::size_t i, std::size_t) { return *meet(f.plane, loop[i].edge, h); },
        [&](const FacetCorner<N>& c) { result.minus->corners.push_back(c); },
        [&](const FacetCorner<N>& c) { result.plus->corners.push_back(c); });
    return result;
}

CLEAVE_END_NAMESPACE

#endif
