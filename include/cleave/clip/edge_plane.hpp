// SPDX-License-Identifier: Apache-2.0
/// The plane that goes with an edge of a polygon: its neighbour's, or an auxiliary one.
#ifndef CLEAVE_CLIP_EDGE_PLANE_HPP
#define CLEAVE_CLIP_EDGE_PLANE_HPP

#include <cleave/algebra/determinant.hpp>
#include <cleave/base/contract.hpp>
#include <cleave/geometry/cross_point.hpp>
#include <cleave/geometry/side.hpp>

#include <cstddef>
#include <optional>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// The coordinate direction that auxiliary planes of a face contain: the axis of the largest normal entry of the face,
/// the least axis on a tie. It is never parallel to the face, and one choice for all edges keeps them comparable.
template <ExactRing N>
[[nodiscard]] std::size_t auxiliary_axis(const Plane<3, N>& face) {
    using T = number_traits<N>;
    std::size_t best = 0;
    N largest(T::sign(face[0]) == Sign::minus ? N(-face[0]) : face[0]);
    for (std::size_t i = 1; i < 3; ++i) {
        N size(T::sign(face[i]) == Sign::minus ? N(-face[i]) : face[i]);
        if (largest < size) {
            best = i;
            largest = std::move(size);
        }
    }
    return best;
}

/// A plane through the edge from a to b other than the face's: the one that contains a coordinate direction. It has a
/// zero among its coefficients and entries no longer than a 2 x 2 minor of the points, the least that two points give.
/// Returns: the plane with the inner side of the edge (its left as seen from outside) on the minus side.
/// Requires: a and b are different points of the face's plane.
template <ExactRing N>
[[nodiscard]] Plane<3, N> auxiliary_plane(const Plane<3, N>& face, const Point<3, N>& a, const Point<3, N>& b) {
    const std::size_t axis = auxiliary_axis(face);
    Vector<4, N> direction{N(0), N(0), N(0), N(0)};
    direction[axis] = N(1);
    std::optional<Plane<3, N>> h = join_homogeneous<N>(a.homogeneous(), b.homogeneous(), direction);
    CLEAVE_REQUIRES(h.has_value());
    // With d = b - a and e the axis: (d x e).(n x d) = -(d.d)(n.e), so the left side is inside exactly if n.e > 0.
    return number_traits<N>::sign(face[axis]) == Sign::plus ? *h : flip(*h);
}

/// The plane of the edge from a to b of a face: the neighbour's plane, oriented so that the inner side of the edge is
/// on its minus side; an auxiliary plane where there is no neighbour or the neighbour is coplanar. A coplanar
/// neighbour's plane would meet every cut in the edge's line or nowhere, and new vertices would be lost.
/// Requires: a and b are different points of the face's plane, and the neighbour's plane, if any, contains both.
template <ExactRing N>
[[nodiscard]] Plane<3, N> edge_plane(const Plane<3, N>& face, const Point<3, N>& a, const Point<3, N>& b,
                                     const std::optional<Plane<3, N>>& neighbour) {
    if (!neighbour) return auxiliary_plane(face, a, b);
    CLEAVE_REQUIRES(side(*neighbour, a) == Sign::zero && side(*neighbour, b) == Sign::zero);
    Vector<3, N> along;
    for (std::size_t i = 0; i < 3; ++i) along[i] = determinant_of_two<N>(b[i], a[i], b.weight(), a.weight());
    const Vector<3, N> outward = face.normal();
    const Vector<3, N> other = neighbour->normal();
    // The left side of the edge is the direction n x d; m.(n x d) = det(m, n, d) says where m has it.
    const N turn(determinant(rows_of(other, outward, along)));
    switch (number_traits<N>::sign(turn)) {
        case Sign::minus:
            return *neighbour;
        case Sign::plus:
            return flip(*neighbour);
        case Sign::zero:
            break;
    }
    return auxiliary_plane(face, a, b);
}

CLEAVE_END_NAMESPACE

#endif
