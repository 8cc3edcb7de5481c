// SPDX-License-Identifier: Apache-2.0
/// The side test: on which side of an oriented plane a point lies. Every other predicate is made of it.
#ifndef CLEAVE_GEOMETRY_SIDE_HPP
#define CLEAVE_GEOMETRY_SIDE_HPP

#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point.hpp>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// The sign of h(p): of n.X + c W, since the weight is positive. Computed in R (by default N).
/// Returns: minus inside, zero on the plane, plus outside.
/// Cost: D + 1 products. If h has p bits and the point q, the sum has at most p + q + log2(D + 1) + 1.
template <class R = void, int D, ExactRing N>
[[nodiscard]] Sign side(const Plane<D, N>& h, const Point<D, N>& p) {
    using Wide = SumType<R, N>;
    const Wide value(dot<R>(h.coefficients(), p.homogeneous()));
    return number_traits<Wide>::sign(value);
}

/// The side towards which a direction leads away from the plane: the sign of n.v; zero where v is parallel to h.
template <class R = void, int D, ExactRing N>
[[nodiscard]] Sign side(const Plane<D, N>& h, const Vector<D, N>& direction) {
    using Wide = SumType<R, N>;
    const Wide value(dot<R>(h.normal(), direction));
    return number_traits<Wide>::sign(value);
}

/// The value h(p) = n.x + c. Its sign is `side`; its size depends on the scale of h.
template <int D, ExactRing N>
[[nodiscard]] typename number_traits<N>::field_type evaluate(const Plane<D, N>& h, const Point<D, N>& p) {
    const N value(dot(h.coefficients(), p.homogeneous()));
    return ratio(value, p.weight());
}

CLEAVE_END_NAMESPACE

#endif
