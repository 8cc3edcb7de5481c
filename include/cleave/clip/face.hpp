// SPDX-License-Identifier: Apache-2.0
/// Faces: sets of polygons with holes on one oriented plane, and their facets.
#ifndef CLEAVE_CLIP_FACE_HPP
#define CLEAVE_CLIP_FACE_HPP

#include <cleave/clip/clip_model.hpp>
#include <cleave/clip/cut_face.hpp>
#include <cleave/clip/edge_plane.hpp>
#include <cleave/clip/facet.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The part of one oriented plane that belongs to a boundary.
///
/// | D | face                                                                                                |
/// |---|-----------------------------------------------------------------------------------------------------|
/// | 1 | the oriented point itself                                                                           |
/// | 2 | any number of segments of the line, each in the direction of `join`                                 |
/// | 3 | loops of corners with the face on their left as seen from outside: outer loops counter-clockwise,   |
/// |   | holes clockwise; loops may touch themselves and each other, and may run along a line twice          |
template <int D, ExactRing N>
struct Face;

template <ExactRing N>
struct Face<1, N> {
    Plane<1, N> plane;
};

template <ExactRing N>
struct Face<2, N> {
    Plane<2, N> plane;
    std::vector<std::pair<CrossPoint<2, N>, CrossPoint<2, N>>> segments;
};

template <ExactRing N>
struct Face<3, N> {
    Plane<3, N> plane;
    std::vector<std::vector<FacetCorner<N>>> loops;
};

/// D = 3: the face with the given plane and loops of vertices, without knowledge of neighbours: every edge gets an
/// auxiliary plane. Edges of length zero are dropped.
template <ExactRing N>
[[nodiscard]] Face<3, N> make_face(const Plane<3, N>& plane, std::span<const std::vector<Point<3, N>>> loops) {
    Face<3, N> face{plane, {}};
    for (const std::vector<Point<3, N>>& loop : loops) {
        std::vector<FacetCorner<N>>& corners = face.loops.emplace_back();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point<3, N>& next = loop[i + 1 == loop.size() ? 0 : i + 1];
            if (!(loop[i] == next)) corners.push_back({loop[i], auxiliary_plane(plane, loop[i], next)});
        }
    }
    return face;
}

namespace detail {

/// The first vertex not on the line of the first two different ones, if any, gives a plane of the loop.
template <ExactRing N>
[[nodiscard]] std::optional<Plane<3, N>> any_plane(std::span<const Point<3, N>> loop) {
    std::size_t second = 1;
    while (second < loop.size() && loop[second] == loop[0]) ++second;
    for (std::size_t i = second + 1; i < loop.size(); ++i) {
        const std::optional<Plane<3, N>> h = join(loop[0], loop[second], loop[i]);
        if (h) return h;
    }
    return std::nullopt;
}

/// Twice the area of the loop's projection along an axis, positive if it runs counter-clockwise around it.
template <ExactRing N>
[[nodiscard]] typename number_traits<N>::field_type projected_area(std::span<const Point<3, N>> loop,
                                                                   std::size_t axis) {
    using Field = typename number_traits<N>::field_type;
    const std::size_t i = (axis + 1) % 3;
    const std::size_t j = (axis + 2) % 3;
    Field sum(0);
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Point<3, N>& p = loop[k];
        const Point<3, N>& q = loop[k + 1 == loop.size() ? 0 : k + 1];
        sum += determinant_of_two<Field, Field>(p.coordinate(i), p.coordinate(j), q.coordinate(i), q.coordinate(j));
    }
    return sum;
}

}  // namespace detail

/// D = 3: the same with the plane of the vertices, oriented so that the loops have a positive area altogether. Unlike
/// the plane of three successive vertices this works for polygons of any shape.
/// Returns: nullopt where all vertices of the first loop are on a line, or the area is zero.
template <ExactRing N>
[[nodiscard]] std::optional<Face<3, N>> make_face(std::span<const std::vector<Point<3, N>>> loops) {
    if (loops.empty()) return std::nullopt;
    const std::optional<Plane<3, N>> h = detail::any_plane<N>(loops.front());
    if (!h) return std::nullopt;
    const std::size_t axis = auxiliary_axis(*h);
    typename number_traits<N>::field_type area(0);
    for (const std::vector<Point<3, N>>& loop : loops) area += detail::projected_area<N>(loop, axis);
    const Sign turn = number_traits<typename number_traits<N>::field_type>::sign(area);
    if (turn == Sign::zero) return std::nullopt;
    return make_face(turn == number_traits<N>::sign((*h)[axis]) ? *h : flip(*h), loops);
}

/// The same set facing the other way.
template <ExactRing N>
[[nodiscard]] Face<1, N> flip(const Face<1, N>& face) {
    return {flip(face.plane)};
}
template <ExactRing N>
[[nodiscard]] Face<2, N> flip(const Face<2, N>& face) {
    Face<2, N> result{flip(face.plane), face.segments};
    for (auto& segment : result.segments) std::swap(segment.first, segment.second);
    return result;
}
template <ExactRing N>
[[nodiscard]] Face<3, N> flip(const Face<3, N>& face) {
    Face<3, N> result{flip(face.plane), {}};
    for (const std::vector<FacetCorner<N>>& loop : face.loops) {
        result.loops.push_back(flip(Facet<3, N>{face.plane, loop}).corners);
    }
    return result;
}

/// The face as convex facets with disjoint interiors, cut along lines of its own edges only (see clip/cut_face.hpp).
/// A convex polygon comes back as it is. Facets carry the face's plane and edge planes; inner edges carry planes of
/// outer ones.
template <ExactRing N>
[[nodiscard]] std::vector<Facet<1, N>> to_facets(const Face<1, N>& face) {
    return {Facet<1, N>{face.plane}};
}
template <ExactRing N>
[[nodiscard]] std::vector<Facet<2, N>> to_facets(const Face<2, N>& face) {
    std::vector<Facet<2, N>> facets;
    for (const auto& [begin, end] : face.segments) {
        if (!(begin == end)) facets.push_back({face.plane, begin, end});
    }
    return facets;
}
template <ExactRing N>
[[nodiscard]] std::vector<Facet<3, N>> to_facets(const Face<3, N>& face) {
    ClipModel<3, N> model;
    FaceCutter<ClipModel<3, N>> cutter(model, face.plane);
    for (const std::vector<FacetCorner<N>>& loop : face.loops) cutter.add_loop(loop);
    std::vector<Facet<3, N>> facets;
    cutter.cut([&](std::span<const std::pair<Point<3, N>, Plane<3, N>>> corners) {
        Facet<3, N>& f = facets.emplace_back(Facet<3, N>{face.plane, {}});
        f.corners.reserve(corners.size());
        for (const auto& [point, edge] : corners) f.corners.push_back({point, edge});
    });
    return facets;
}

CLEAVE_END_NAMESPACE

#endif
