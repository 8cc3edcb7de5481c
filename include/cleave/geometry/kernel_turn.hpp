// SPDX-License-Identifier: Apache-2.0
/// Orientation of points of a kernel in a projection along an axis.
#ifndef CLEAVE_GEOMETRY_KERNEL_TURN_HPP
#define CLEAVE_GEOMETRY_KERNEL_TURN_HPP

#include <cleave/geometry/double_predicates.hpp>
#include <cleave/geometry/kernel_lines.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>

CLEAVE_BEGIN_NAMESPACE

/// The turn p, q, r in a projection: the sign of the determinant of homogeneous coordinates, whose weights are
/// positive.
[[nodiscard]] inline Sign exact_turn(const Homogeneous<3>& p, const Homogeneous<3>& q, const Homogeneous<3>& r,
                                     Projection projection) {
    const auto minor = [&](const Homogeneous<3>& a, const Homogeneous<3>& b) {
        WideInteger m(a[projection.u] * WideInteger(b[projection.v]));
        sub_product(m, a[projection.v], b[projection.u]);
        return m;
    };
    WideInteger det = minor(q, r) * WideInteger(p[3]);
    det -= minor(p, r) * WideInteger(q[3]);
    det += minor(p, q) * WideInteger(r[3]);
    return det.sign();
}

/// The turn p, q, r in a projection: plus where it is counter-clockwise. Requires: finite points. Cost: about 5 ns
/// where the filter decides; where it does not, points are computed exactly once, and tried again.
[[nodiscard]] inline Sign turn(Kernel<3>& kernel, PointId p, PointId q, PointId r, Projection projection) {
    if (p == q || q == r || p == r) return Sign::zero;
    for (int attempt = 0; attempt < 2; ++attempt) {
        if constexpr (filtering::always_fails) break;
        const PointRecord<3>& a = kernel.point(p);
        const PointRecord<3>& b = kernel.point(q);
        const PointRecord<3>& c = kernel.point(r);
        const std::optional<Sign> s = approximate_turn(a.approximation, b.approximation, c.approximation, projection,
                                                       std::max({a.error, b.error, c.error}));
        if (s) return *s;
        if (attempt == 0)
            for (const PointId x : {p, q, r}) kernel.refine(x);
    }
    return exact_turn(kernel.coordinates(p), kernel.coordinates(q), kernel.coordinates(r), projection);
}

/// The projection that sees a plane from outside, along the axis on which its normal is longest.
[[nodiscard]] inline Projection projection_of(const Kernel<3>& kernel, PlaneId f) {
    const int drop = dominant_axis(kernel, unoriented(f));
    const Sign up = kernel.planes.exact(unoriented(f))[std::size_t(drop)].sign();
    return Projection::along(static_cast<unsigned>(drop), (up == Sign::minus) != is_flipped(f));
}

CLEAVE_END_NAMESPACE

#endif
