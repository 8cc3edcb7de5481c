// SPDX-License-Identifier: Apache-2.0
/// Boxes of points and facets: of doubles rounded outward, and exact ones.
#ifndef CLEAVE_CLIP_FACET_BOX_HPP
#define CLEAVE_CLIP_FACET_BOX_HPP

#include <cleave/clip/facet.hpp>
#include <cleave/geometry/point_box.hpp>

CLEAVE_BEGIN_NAMESPACE

/// The least box of doubles around the facet: its vertices' boxes, rounded outward. Cost: D divisions a vertex.
template <int D, ExactRing N>
[[nodiscard]] Box<D> box_of(const Facet<D, N>& f) {
    Box<D> box;
    for (const Point<D, N>& p : vertices(f)) box.extend(box_of(p));
    return box;
}

/// The exact box of the facet.
template <int D, ExactRing N>
[[nodiscard]] Box<D, typename number_traits<N>::field_type> exact_box_of(const Facet<D, N>& f) {
    Box<D, typename number_traits<N>::field_type> box;
    for (const Point<D, N>& p : vertices(f)) box.extend(p.coordinates());
    return box;
}

CLEAVE_END_NAMESPACE

#endif
