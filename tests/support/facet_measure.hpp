// SPDX-License-Identifier: Apache-2.0
/// Exact sizes of facets and faces: the length or area of the projection along a coordinate axis that is not parallel
/// to the plane. Unlike true lengths these are rational; parts of one plane can be added up and compared.
#ifndef CLEAVE_TESTS_SUPPORT_FACET_MEASURE_HPP
#define CLEAVE_TESTS_SUPPORT_FACET_MEASURE_HPP

#include <cleave/clip/face.hpp>
#include <cleave/clip/facet.hpp>

#include <cstddef>
#include <utility>
#include <vector>

/// The first axis along which the plane can be projected.
template <int D, class N>
[[nodiscard]] std::size_t projection_axis(const cleave::Plane<D, N>& h) {
    std::size_t axis = 0;
    while (cleave::number_traits<N>::sign(h[axis]) == cleave::Sign::zero) ++axis;
    return axis;
}

/// 1 for a point, which has no size to project.
template <class N>
[[nodiscard]] typename cleave::number_traits<N>::field_type projected_measure(const cleave::Facet<1, N>&) {
    return typename cleave::number_traits<N>::field_type(1);
}

template <class N>
[[nodiscard]] typename cleave::number_traits<N>::field_type projected_segment(const cleave::Plane<2, N>& h,
                                                                              const cleave::Point<2, N>& begin,
                                                                              const cleave::Point<2, N>& end) {
    using Field = typename cleave::number_traits<N>::field_type;
    const std::size_t axis = projection_axis(h);
    const Field length = end.coordinate(1 - axis) - begin.coordinate(1 - axis);
    // Going with the outside on the right: up where the normal points right, left where it points up.
    const bool forward = (cleave::number_traits<N>::sign(h[axis]) == cleave::Sign::plus) == (axis == 0);
    return forward ? length : Field(-length);
}

/// Positive if the end points are in the order of the plane.
template <class N>
[[nodiscard]] typename cleave::number_traits<N>::field_type projected_measure(const cleave::Facet<2, N>& f) {
    return projected_segment(f.plane, f.begin, f.end);
}

/// Twice the projected area of a loop in the plane; positive if it runs counter-clockwise as seen from outside.
template <class N>
[[nodiscard]] typename cleave::number_traits<N>::field_type projected_loop(
    const cleave::Plane<3, N>& h, const std::vector<cleave::FacetCorner<N>>& corners) {
    using Field = typename cleave::number_traits<N>::field_type;
    const std::size_t axis = projection_axis(h);
    const std::size_t i = (axis + 1) % 3;
    const std::size_t j = (axis + 2) % 3;
    Field sum(0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const cleave::Point<3, N>& p = corners[k].point;
        const cleave::Point<3, N>& q = corners[(k + 1) % corners.size()].point;
        const Field left = p.coordinate(i) * q.coordinate(j);
        const Field right = p.coordinate(j) * q.coordinate(i);
        sum += left;
        sum -= right;
    }
    return cleave::number_traits<N>::sign(h[axis]) == cleave::Sign::plus ? sum : Field(-sum);
}

template <class N>
[[nodiscard]] typename cleave::number_traits<N>::field_type projected_measure(const cleave::Facet<3, N>& f) {
    return projected_loop(f.plane, f.corners);
}

template <class N>
[[nodiscard]] typename cleave::number_traits<N>::field_type projected_measure(const cleave::Face<2, N>& face) {
    typename cleave::number_traits<N>::field_type sum(0);
    for (const auto& segment : face.segments) sum += projected_segment(face.plane, segment.first, segment.second);
    return sum;
}

template <class N>
[[nodiscard]] typename cleave::number_traits<N>::field_type projected_measure(const cleave::Face<3, N>& face) {
    typename cleave::number_traits<N>::field_type sum(0);
    for (const auto& loop : face.loops) sum += projected_loop(face.plane, loop);
    return sum;
}

/// The sum over several facets of one plane.
template <int D, class N>
[[nodiscard]] typename cleave::number_traits<N>::field_type projected_measure(
    const std::vector<cleave::Facet<D, N>>& facets) {
    typename cleave::number_traits<N>::field_type sum(0);
    for (const auto& f : facets) sum += projected_measure(f);
    return sum;
}

#endif
