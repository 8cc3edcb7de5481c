// SPDX-License-Identifier: Apache-2.0
/// The exact plane through three points of doubles, from differences.
#ifndef CLEAVE_GEOMETRY_DOUBLE_PLANE_HPP
#define CLEAVE_GEOMETRY_DOUBLE_PLANE_HPP

#include <cleave/geometry/double_predicates.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// Integer coefficients (n, c) of the plane n.x + c = 0 through p, q, r, up to a positive factor; the plus side is
/// where p, q, r are counter-clockwise. All zero where the points are on one line. Requires: finite coordinates. Cost:
/// nine products of differences and of what they give, shorter than minors of homogeneous coordinates.
[[nodiscard]] inline std::array<Integer, 4> plane_through(const std::array<double, 3>& p,
                                                          const std::array<double, 3>& q,
                                                          const std::array<double, 3>& r) {
    const IntegerVector a = integer_difference(q, p);
    const IntegerVector b = integer_difference(r, p);
    std::array<DoubleParts, 3> at;
    int least = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        at[i] = decompose(p[i]);
        if (at[i].mantissa != 0) least = std::min(least, at[i].exponent);
    }
    // p = P 2^least, so n 2^-least . x - n . P is zero at p.
    std::array<Integer, 4> plane;
    WideInteger offset;
    for (std::size_t i = 0; i < 3; ++i) {
        WideInteger n;
        add_product(n, a[(i + 1) % 3], b[(i + 2) % 3]);
        sub_product(n, a[(i + 2) % 3], b[(i + 1) % 3]);
        if (at[i].mantissa != 0)
            sub_product(offset, n,
                        WideInteger::scaled(at[i].mantissa, static_cast<std::size_t>(at[i].exponent - least)));
        plane[i] = Integer(n << static_cast<std::size_t>(-least));
    }
    plane[3] = Integer(offset);
    return plane;
}

CLEAVE_END_NAMESPACE

#endif
