// SPDX-License-Identifier: Apache-2.0
/// Boxes of doubles around exact points, rounded outward.
#ifndef CLEAVE_GEOMETRY_POINT_BOX_HPP
#define CLEAVE_GEOMETRY_POINT_BOX_HPP

#include <cleave/geometry/box.hpp>
#include <cleave/geometry/point.hpp>
#include <cleave/number/interval.hpp>
#include <cleave/number/traits.hpp>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// The least box of doubles that contains the point: flat where coordinates are doubles, a step wide where not, and
/// unbounded where a coordinate is beyond the largest double.
template <int D, ExactRing N>
[[nodiscard]] Box<D> box_of(const Point<D, N>& p) {
    Box<D> box;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        const Interval x = number_traits<typename number_traits<N>::field_type>::enclosure(p.coordinate(i));
        box.lo[i] = x.lower();
        box.hi[i] = x.upper();
    }
    return box;
}

CLEAVE_END_NAMESPACE

#endif
