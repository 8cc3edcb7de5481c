// SPDX-License-Identifier: Apache-2.0
/// Facets from vertices: the factories that choose planes and edge planes.
#ifndef CLEAVE_CLIP_MAKE_FACET_HPP
#define CLEAVE_CLIP_MAKE_FACET_HPP

#include <cleave/base/contract.hpp>
#include <cleave/clip/edge_plane.hpp>
#include <cleave/clip/facet.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// D = 1: the point with its outside towards larger (plus) or smaller (minus) coordinates. Requires: not zero.
template <ExactRing N>
[[nodiscard]] Facet<1, N> make_facet(const Point<1, N>& point, Sign outside) {
    CLEAVE_REQUIRES(outside != Sign::zero);
    const Plane<1, N> h = *join(point);
    return {outside == Sign::plus ? h : flip(h)};
}

/// D = 2: the segment with its outside on the right of begin -> end (counter-clockwise around the inside).
/// Returns: nullopt where the points are equal.
template <ExactRing N>
[[nodiscard]] std::optional<Facet<2, N>> make_facet(const Point<2, N>& begin, const Point<2, N>& end) {
    const std::optional<Plane<2, N>> h = join(begin, end);
    if (!h) return std::nullopt;
    return Facet<2, N>{*h, begin, end};
}

/// D = 3: the convex polygon with the given plane and vertices in outward order (counter-clockwise as seen from
/// outside). `neighbours`, if not empty, has for each vertex the plane of the facet across the edge that starts there,
/// or nothing; a coplanar neighbour counts as nothing (see `edge_plane`). Edges of length zero are dropped with their
/// neighbours; vertices in the middle of a side stay.
/// Returns: nullopt where fewer than three vertices are left.
/// Requires: the vertices form a convex polygon of the plane (checked at the full contract level).
template <ExactRing N>
[[nodiscard]] std::optional<Facet<3, N>> make_facet(const Plane<3, N>& plane, std::span<const Point<3, N>> vertices,
                                                    std::span<const std::optional<Plane<3, N>>> neighbours = {}) {
    CLEAVE_REQUIRES(neighbours.empty() || neighbours.size() == vertices.size());
    Facet<3, N> f{plane, {}};
    const std::size_t n = vertices.size();
    f.corners.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Point<3, N>& a = vertices[i];
        const Point<3, N>& b = vertices[i + 1 == n ? 0 : i + 1];
        if (a == b) continue;
        f.corners.push_back({a, edge_plane(plane, a, b, neighbours.empty() ? std::nullopt : neighbours[i])});
    }
    if (f.corners.size() < 3) return std::nullopt;
    CLEAVE_ENSURES_EXPENSIVE(is_valid(f));
    return f;
}

/// The plane of a convex polygon, from the first three successive vertices that span one; equal neighbours count once.
/// Returns: nullopt where all vertices are on a line.
template <ExactRing N>
[[nodiscard]] std::optional<Plane<3, N>> plane_of_convex(std::span<const Point<3, N>> vertices) {
    std::vector<const Point<3, N>*> distinct;
    for (const Point<3, N>& p : vertices) {
        if (distinct.empty() || !(*distinct.back() == p)) distinct.push_back(&p);
    }
    const std::size_t n = distinct.size();
    for (std::size_t i = 0; n >= 3 && i < n; ++i) {
        const std::optional<Plane<3, N>> h = join(*distinct[i], *distinct[(i + 1) % n], *distinct[(i + 2) % n]);
        if (h) return h;
    }
    return std::nullopt;
}

/// The same with the plane through the vertices. Returns: nullopt where all vertices are on a line.
template <ExactRing N>
[[nodiscard]] std::optional<Facet<3, N>> make_facet(std::span<const Point<3, N>> vertices,
                                                    std::span<const std::optional<Plane<3, N>>> neighbours = {}) {
    const std::optional<Plane<3, N>> h = plane_of_convex(vertices);
    return h ? make_facet(*h, vertices, neighbours) : std::nullopt;
}

/// The same for a vector of vertices.
template <ExactRing N>
[[nodiscard]] std::optional<Facet<3, N>> make_facet(const std::vector<Point<3, N>>& vertices) {
    return make_facet(std::span<const Point<3, N>>(vertices));
}

CLEAVE_END_NAMESPACE

#endif
