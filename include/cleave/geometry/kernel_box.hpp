// SPDX-License-Identifier: Apache-2.0
/// Boxes of doubles around the points of a kernel.
#ifndef CLEAVE_GEOMETRY_KERNEL_BOX_HPP
#define CLEAVE_GEOMETRY_KERNEL_BOX_HPP

#include <cleave/geometry/box.hpp>
#include <cleave/geometry/kernel.hpp>

#include <cmath>
#include <cstddef>
#include <limits>

CLEAVE_BEGIN_NAMESPACE

/// A box that holds a point: its coordinates where they are doubles, all of space for one beyond their range.
/// Cost: none, unless nothing is known of a constructed point yet; then it is computed.
template <int D>
[[nodiscard]] Box<D> box_of(Kernel<D>& kernel, PointId p) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!(kernel.point(p).error < infinity)) kernel.refine(p);
    const PointRecord<D>& r = kernel.point(p);
    Box<D> box(r.approximation);
    if (r.error == 0) return box;
    const bool known = r.error < infinity;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        box.lo[i] = known ? std::nextafter(r.approximation[i] - r.error, -infinity) : -infinity;
        box.hi[i] = known ? std::nextafter(r.approximation[i] + r.error, infinity) : infinity;
    }
    return box;
}

CLEAVE_END_NAMESPACE

#endif
