// SPDX-License-Identifier: Apache-2.0
/// `join`, the plane through D points, and `meet`, the point on D planes: one function of linear algebra, two names.
///
/// Points (X, W) and planes (n, c) are vectors of D + 1 numbers, and a point is on a plane exactly if their scalar
/// product is zero. Hence both the plane through D points and the point on D planes are the vector orthogonal to D
/// given ones: the D + 1 maximal minors of the D x (D + 1) matrix of rows, with alternating signs (algebra/minors).
/// What is left to this header is the sign.
///
/// *Orientation of a join.* Let m be the alternating minors of points p_1, ..., p_D and n the normal entries of m. Then
///
///     n.v = (-1)^(D+1) det(v, p_2 - p_1, ..., p_D - p_1)        (positive weights factored out)
///
/// so that (-1)^(D+1) m has the outward normal if the points are in *outward order*: normal first, then the edge
/// vectors, is a positive basis. For D = 3 that is counter-clockwise as seen from outside, for D = 2 counter-clockwise
/// around the inside, for D = 1 there is one order only and the plane faces +x; the caller flips it for a lower end.
///
///     D = 2    inside              D = 3, seen from outside         p3
///            p1 ----> p2                                          /    \      counter-clockwise
///              outside                                          p1 ---> p2
#ifndef CLEAVE_GEOMETRY_CROSS_POINT_HPP
#define CLEAVE_GEOMETRY_CROSS_POINT_HPP

#include <cleave/algebra/minors.hpp>
#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// A point that is the meet of D planes, or an input point. It does not remember its planes: five planes through a
/// point have ten triples of them, so identity is the place, never the name.
template <int D, ExactRing N>
using CrossPoint = Point<D, N>;

/// The plane through points given by homogeneous vectors, some of which may have weight zero: (v, 0) is the direction
/// v, "the point at infinity" of all lines along it. Oriented as `join`.
/// Returns: nullopt where the vectors are dependent, or where all of them have weight zero.
template <ExactRing N, class... Rest>
requires(std::same_as<Rest, Vector<static_cast<int>(sizeof...(Rest)) + 2, N>>&&...)
    [[nodiscard]] auto join_homogeneous(const Vector<static_cast<int>(sizeof...(Rest)) + 2, N>& first,
                                        const Rest&... rest)
        -> std::optional<Plane<static_cast<int>(sizeof...(Rest)) + 1, N>> {
    constexpr int D = static_cast<int>(sizeof...(Rest)) + 1;
    Vector<D + 1, N> h = minors(rows_of(first, rest...));
    if (first_nonzero(h) >= std::size_t(D)) return std::nullopt;
    if constexpr (D % 2 == 0) negate_in_place(h);
    return Plane<D, N>(std::move(h));
}

/// The plane through D points, with the inside on its minus side if the points are in outward order (see above).
/// Returns: nullopt where the points do not span a plane.
/// Cost: 6, 24, 70 products for D = 2, 3, 4. Bits: D times those of the points, and log2(D!).
template <int D, ExactRing N>
[[nodiscard]] std::optional<Plane<D, N>> join(const std::array<Point<D, N>, std::size_t(D)>& points) {
    return [&points]<std::size_t... I>(std::index_sequence<I...>) {
        return join_homogeneous<N>(points[I].homogeneous()...);
    }
    (std::make_index_sequence<std::size_t(D)>());
}

/// The same for D separate points.
template <int D, ExactRing N, std::same_as<Point<D, N>>... Rest>
requires(sizeof...(Rest) + 1 == D)
    [[nodiscard]] std::optional<Plane<D, N>> join(const Point<D, N>& first, const Rest&... rest) {
    return join_homogeneous<N>(first.homogeneous(), rest.homogeneous()...);
}

namespace detail {

template <int D, ExactRing N>
[[nodiscard]] std::optional<Point<D, N>> point_of_minors(Vector<D + 1, N> v) {
    if (number_traits<N>::sign(v[D]) == Sign::zero) return std::nullopt;
    return Point<D, N>(std::move(v));  // which makes the weight positive
}

}  // namespace detail

/// The point on D planes, whatever their orientation.
/// Returns: nullopt where they have no common point or more than one.
/// Cost: as `join`. If the planes have p bits, the result has D p + log2(D!).
template <int D, ExactRing N>
[[nodiscard]] std::optional<Point<D, N>> meet(const std::array<Plane<D, N>, std::size_t(D)>& planes) {
    return [&planes]<std::size_t... I>(std::index_sequence<I...>) {
        return detail::point_of_minors<D, N>(minors(rows_of(planes[I].coefficients()...)));
    }
    (std::make_index_sequence<std::size_t(D)>());
}

/// The same for D separate planes.
template <int D, ExactRing N, std::same_as<Plane<D, N>>... Rest>
requires(sizeof...(Rest) + 1 == D)
    [[nodiscard]] std::optional<Point<D, N>> meet(const Plane<D, N>& first, const Rest&... rest) {
    return detail::point_of_minors<D, N>(minors(rows_of(first.coefficients(), rest.coefficients()...)));
}

CLEAVE_END_NAMESPACE

#endif
