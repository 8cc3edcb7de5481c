// SPDX-License-Identifier: Apache-2.0
/// Cutting facets of the line: a comparison.
///
/// | h at the point | result                                              |
/// |----------------|-----------------------------------------------------|
/// | -              | minus part                                          |
/// | 0              | on: the planes are one point, co- or anti-oriented  |
/// | +              | plus part                                           |
#ifndef CLEAVE_CLIP_CLIP_1D_HPP
#define CLEAVE_CLIP_CLIP_1D_HPP

#include <cleave/clip/coincident.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/clip/facet.hpp>

CLEAVE_BEGIN_NAMESPACE

/// Where the facet lies. Never `crossing`: a point has no inside. Cost: one side test.
template <ExactRing N>
[[nodiscard]] FacetSide side(const Plane<1, N>& h, const Facet<1, N>& f) {
    const Sign s = side(h, *meet(f.plane));
    if (s == Sign::zero) return coincident_side(relation(h, f.plane));
    return s == Sign::minus ? FacetSide::minus : FacetSide::plus;
}

/// The parts of the facet: all of it is one of them.
template <ExactRing N>
[[nodiscard]] Split<Facet<1, N>> split(const Plane<1, N>& h, const Facet<1, N>& f) {
    return unsplit(side(h, f), f);
}

CLEAVE_END_NAMESPACE

#endif
