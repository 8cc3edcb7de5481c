// SPDX-License-Identifier: Apache-2.0
/// Cutting segments by oriented lines: nine pairs of signs.
///
/// | begin | end | result                                                          |
/// |-------|-----|-----------------------------------------------------------------|
/// | -     | -   | minus part                                                      |
/// | -     | 0   | minus part                                                      |
/// | -     | +   | crossing: (begin, x) is the minus part, (x, end) the plus part  |
/// | 0     | -   | minus part                                                      |
/// | 0     | 0   | on: two different points of h, so the lines coincide            |
/// | 0     | +   | plus part                                                       |
/// | +     | -   | crossing: (x, end) is the minus part, (begin, x) the plus part  |
/// | +     | 0   | plus part                                                       |
/// | +     | +   | plus part                                                       |
///
/// x is the meet of h and the facet's own line, never a combination of the end points: so a vertex of a result is
/// always the meet of two given lines, and its numbers are no longer after the hundredth cut than after the first.
#ifndef CLEAVE_CLIP_CLIP_2D_HPP
#define CLEAVE_CLIP_CLIP_2D_HPP

#include <cleave/clip/coincident.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/clip/facet.hpp>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

template <ExactRing N>
[[nodiscard]] FacetSide side_by_ends(const Plane<2, N>& h, const Facet<2, N>& f, Sign begin, Sign end) {
    VertexSigns signs;
    signs.add(begin);
    signs.add(end);
    return signs.all_zero() ? coincident_side(relation(h, f.plane)) : signs.side();
}

}  // namespace detail

/// Where the facet lies. Cost: two side tests.
template <ExactRing N>
[[nodiscard]] FacetSide side(const Plane<2, N>& h, const Facet<2, N>& f) {
    return detail::side_by_ends(h, f, side(h, f.begin), side(h, f.end));
}

/// The parts of the facet. Cost: two side tests, and one meet where it is crossed.
template <ExactRing N>
[[nodiscard]] Split<Facet<2, N>> split(const Plane<2, N>& h, const Facet<2, N>& f) {
    const Sign begin = side(h, f.begin);
    const FacetSide where = detail::side_by_ends(h, f, begin, side(h, f.end));
    if (where != FacetSide::crossing) return unsplit(where, f);
    const CrossPoint<2, N> x = *meet(f.plane, h);
    Split<Facet<2, N>> result;
    (begin == Sign::minus ? result.minus : result.plus) = Facet<2, N>{f.plane, f.begin, x};
    (begin == Sign::minus ? result.plus : result.minus) = Facet<2, N>{f.plane, x, f.end};
    return result;
}

CLEAVE_END_NAMESPACE

#endif
