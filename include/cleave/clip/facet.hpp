// SPDX-License-Identifier: Apache-2.0
/// Facets: convex pieces of oriented planes with their boundaries, as values, for D = 1, 2, 3.
///
/// | D | facet             | boundary                                 | order                                   |
/// |---|-------------------|------------------------------------------|-----------------------------------------|
/// | 1 | an oriented point | none                                     |                                         |
/// | 2 | a segment         | two cross points                         | `join(begin, end)` is the facet's plane |
/// | 3 | a convex polygon  | a loop of corners: point and edge plane  | counter-clockwise as seen from outside  |
///
/// The edge plane of a corner contains the edge from this corner to the next, is not the facet's own plane, and has the
/// facet on its minus side. With it a new vertex is the meet of three given planes, whatever was cut before, so that
/// numbers do not grow from cut to cut.
#ifndef CLEAVE_CLIP_FACET_HPP
#define CLEAVE_CLIP_FACET_HPP

#include <cleave/geometry/cross_point.hpp>
#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/point.hpp>
#include <cleave/geometry/relation.hpp>
#include <cleave/geometry/side.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A convex piece of an oriented plane; it faces the plane's plus side. See the table above. Made by `make_facet`
/// (clip/make_facet.hpp) or field by field; `is_valid` says whether the fields fit together.
template <int D, ExactRing N>
struct Facet;

/// An oriented point of the line.
template <ExactRing N>
struct Facet<1, N> {
    static constexpr int dimension = 1;
    Plane<1, N> plane;

    friend bool operator==(const Facet&, const Facet&) = default;
};

/// A segment with its outside on the right of begin -> end.
template <ExactRing N>
struct Facet<2, N> {
    static constexpr int dimension = 2;
    Plane<2, N> plane;
    CrossPoint<2, N> begin;
    CrossPoint<2, N> end;

    friend bool operator==(const Facet&, const Facet&) = default;
};

/// A vertex of a polygon together with the plane of the edge that starts there.
template <ExactRing N>
struct FacetCorner {
    CrossPoint<3, N> point;
    Plane<3, N> edge;

    friend bool operator==(const FacetCorner&, const FacetCorner&) = default;
};

/// A convex polygon. Vertices in the middle of a side are allowed.
template <ExactRing N>
struct Facet<3, N> {
    static constexpr int dimension = 3;
    Plane<3, N> plane;
    std::vector<FacetCorner<N>> corners;

    friend bool operator==(const Facet&, const Facet&) = default;
};

/// The vertices, in order.
template <ExactRing N>
[[nodiscard]] std::array<Point<1, N>, 1> vertices(const Facet<1, N>& f) {
    return {*meet(f.plane)};
}
template <ExactRing N>
[[nodiscard]] std::array<Point<2, N>, 2> vertices(const Facet<2, N>& f) {
    return {f.begin, f.end};
}
template <ExactRing N>
[[nodiscard]] std::vector<Point<3, N>> vertices(const Facet<3, N>& f) {
    std::vector<Point<3, N>> points;
    points.reserve(f.corners.size());
    for (const FacetCorner<N>& c : f.corners) points.push_back(c.point);
    return points;
}

/// The same set facing the other way.
template <ExactRing N>
[[nodiscard]] Facet<1, N> flip(const Facet<1, N>& f) {
    return {flip(f.plane)};
}
template <ExactRing N>
[[nodiscard]] Facet<2, N> flip(const Facet<2, N>& f) {
    return {flip(f.plane), f.end, f.begin};
}

/// The edge from p_{i-1} to p_i starts at p_i once the loop runs backwards, so besides reversing the loop every edge
/// plane moves to the next corner: (p_0, e_0), (p_1, e_1), ... becomes (p_0, e_{n-1}), (p_{n-1}, e_{n-2}), ... The
/// planes themselves stay: the facet is still on their minus side.
template <ExactRing N>
[[nodiscard]] Facet<3, N> flip(const Facet<3, N>& f) {
    const std::size_t n = f.corners.size();
    Facet<3, N> result{flip(f.plane), {}};
    result.corners.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        result.corners.push_back({f.corners[(n - i) % n].point, f.corners[n - 1 - i].edge});
    }
    return result;
}

/// One plane through each ridge, with the facet on its minus side. D = 1: there are no ridges.
template <ExactRing N>
[[nodiscard]] std::array<Plane<1, N>, 0> ridges(const Facet<1, N>&) {
    return {};
}

/// D = 2: the axis-parallel lines through begin and end, across the first axis along which they differ.
template <ExactRing N>
[[nodiscard]] std::array<Plane<2, N>, 2> ridges(const Facet<2, N>& f) {
    Sign ahead = compare_coordinate(f.begin, f.end, 0);
    const std::size_t axis = ahead == Sign::zero ? 1 : 0;
    if (axis == 1) ahead = compare_coordinate(f.begin, f.end, 1);
    const auto across = [axis](const Point<2, N>& p) {
        Vector<3, N> h{N(0), N(0), N(-p[axis])};
        h[axis] = p.weight();
        return Plane<2, N>(std::move(h));
    };
    // ahead == minus: the coordinate grows from begin to end.
    return ahead == Sign::minus ? std::array<Plane<2, N>, 2>{flip(across(f.begin)), across(f.end)}
                                : std::array<Plane<2, N>, 2>{across(f.begin), flip(across(f.end))};
}

template <ExactRing N>
[[nodiscard]] std::vector<Plane<3, N>> ridges(const Facet<3, N>& f) {
    std::vector<Plane<3, N>> planes;
    planes.reserve(f.corners.size());
    for (const FacetCorner<N>& c : f.corners) planes.push_back(c.edge);
    return planes;
}

/// Whether the fields form a facet as described above. Cost: n^2 side tests for a polygon of n corners.
template <ExactRing N>
[[nodiscard]] bool is_valid(const Facet<1, N>&) {
    return true;
}
template <ExactRing N>
[[nodiscard]] bool is_valid(const Facet<2, N>& f) {
    const std::optional<Plane<2, N>> h = join(f.begin, f.end);
    return h && *h == f.plane;
}
template <ExactRing N>
[[nodiscard]] bool is_valid(const Facet<3, N>& f) {
    const std::size_t n = f.corners.size();
    if (n < 3) return false;
    // A convex loop that runs round once goes up and down once in any order of the plane's points.
    std::size_t turns = 0;
    Sign last = compare(f.corners[n - 1].point, f.corners[0].point);
    bool oriented = false;
    for (std::size_t i = 0; i < n; ++i) {
        const FacetCorner<N>& c = f.corners[i];
        const FacetCorner<N>& next = f.corners[(i + 1) % n];
        const Sign way = compare(c.point, next.point);
        if (way == Sign::zero || side(f.plane, c.point) != Sign::zero) return false;
        if (way != last) ++turns;
        last = way;
        if (relation(f.plane, c.edge) != PlaneRelation::crossing) return false;
        if (side(c.edge, c.point) != Sign::zero || side(c.edge, next.point) != Sign::zero) return false;
        for (const FacetCorner<N>& other : f.corners) {
            const Sign s = side(c.edge, other.point);
            if (s == Sign::plus) return false;
            if (s == Sign::minus && !oriented) {
                oriented = true;
                const std::optional<Plane<3, N>> h = join(c.point, next.point, other.point);
                if (!h || relation(*h, f.plane) != PlaneRelation::same) return false;
            }
        }
    }
    return turns == 2 && oriented;
}

CLEAVE_END_NAMESPACE

#endif
