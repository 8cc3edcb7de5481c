// SPDX-License-Identifier: Apache-2.0
/// Convex hulls of a few points, exactly.
#ifndef CLEAVE_SHAPE_HULL_HPP
#define CLEAVE_SHAPE_HULL_HPP

#include <cleave/geometry/canonical.hpp>
#include <cleave/geometry/cross_point.hpp>
#include <cleave/geometry/side.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/region/make.hpp>
#include <cleave/shape/polar_hull.hpp>
#include <cleave/shape/rational_point.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The extreme points of points in the plane, counter-clockwise from the lexicographically least, none in the middle of
/// a side: two monotone chains over the sorted points. Fewer than three where all points are on a line.
/// Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979. Cost: O(n log n).
[[nodiscard]] inline std::vector<RationalPoint<2>> convex_polygon(std::vector<RationalPoint<2>> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    const auto turns_left = [](const RationalPoint<2>& a, const RationalPoint<2>& b, const RationalPoint<2>& c) {
        return Rational((b[0] - a[0]) * (c[1] - a[1])) > Rational((b[1] - a[1]) * (c[0] - a[0]));
    };
    std::vector<RationalPoint<2>> hull;
    const auto add = [&](const RationalPoint<2>& p, std::size_t floor) {
        while (hull.size() >= floor && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
        hull.push_back(p);
    };
    for (const RationalPoint<2>& p : points) add(p, 2);
    const std::size_t upper = hull.size() + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], upper);
    hull.pop_back();
    return hull;
}

namespace detail {

/// The triangles of the hull of points in space, added one by one: a point removes the triangles that it sees strictly
/// from outside, and is joined to the edges around the hole. A triangle in whose plane the point lies stays, so no
/// triangle is ever degenerate; what is coplanar is put together at the end.
class IncrementalHull {
public:
    struct Triangle {
        std::array<std::uint32_t, 3> corners;
        Plane<3, Integer> plane;
    };

    explicit IncrementalHull(std::span<const RationalPoint<3>> points) {
        for (const RationalPoint<3>& p : points) points_.push_back(make_point<Integer>(p));
        if (!start()) return;
        for (std::uint32_t i = 0; i < points_.size(); ++i) add(i);
    }

    /// Empty where the points lie in one plane.
    [[nodiscard]] const std::vector<Triangle>& triangles() const noexcept { return triangles_; }
    [[nodiscard]] const Point<3, Integer>& point(std::uint32_t i) const { return points_[i]; }

private:
    /// A tetrahedron of the first point, the first different one, the first not on their line, the first not in their
    /// plane. Returns: whether there is one.
    bool start() {
        const auto n = static_cast<std::uint32_t>(points_.size());
        for (std::uint32_t b = 1; b < n; ++b) {
            if (points_[b] == points_[0]) continue;
            for (std::uint32_t c = b + 1; c < n; ++c) {
                const std::optional<Plane<3, Integer>> h = join(points_[0], points_[b], points_[c]);
                if (!h) continue;
                for (std::uint32_t d = c + 1; d < n; ++d) {
                    const Sign s = side(*h, points_[d]);
                    if (s == Sign::zero) continue;
                    const std::uint32_t e = s == Sign::minus ? b : c;  // 0, e, f: outward
                    const std::uint32_t f = s == Sign::minus ? c : b;
                    push({0, e, f});
                    push({0, d, e});
                    push({e, d, f});
                    push({f, d, 0});
                    return true;
                }
                return false;
            }
            return false;
        }
        return false;
    }

    void push(const std::array<std::uint32_t, 3>& corners) {
        std::optional<Plane<3, Integer>> h = join(points_[corners[0]], points_[corners[1]], points_[corners[2]]);
        CLEAVE_ASSERT(h.has_value());
        triangles_.push_back({corners, *std::move(h)});
    }

    void add(std::uint32_t p) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> hole;
        std::vector<Triangle> kept;
        for (Triangle& t : triangles_) {
            if (side(t.plane, points_[p]) != Sign::plus) {
                kept.push_back(std::move(t));
                continue;
            }
            for (std::size_t i = 0; i < 3; ++i) ++hole[{t.corners[i], t.corners[(i + 1) % 3]}];
        }
        triangles_ = std::move(kept);
        for (const auto& [edge, count] : hole) {
            (void)count;
            if (hole.count({edge.second, edge.first}) == 0) push({edge.first, edge.second, p});
        }
    }

    std::vector<Point<3, Integer>> points_;
    std::vector<Triangle> triangles_;
};

/// The extreme points of coplanar points, counter-clockwise as seen from the plus side of their plane.
[[nodiscard]] inline std::vector<RationalPoint<3>> convex_face(const Vector<4, Integer>& plane,
                                                               const std::vector<RationalPoint<3>>& points) {
    std::size_t axis = 0;
    while (plane[axis].is_zero()) ++axis;
    std::size_t u = (axis + 1) % 3;
    std::size_t v = (axis + 2) % 3;
    if (plane[axis].sign() == Sign::minus) std::swap(u, v);
    std::map<RationalPoint<2>, const RationalPoint<3>*> lifted;
    std::vector<RationalPoint<2>> shadows;
    for (const RationalPoint<3>& p : points) {
        shadows.push_back({p[u], p[v]});
        lifted[shadows.back()] = &p;
    }
    std::vector<RationalPoint<3>> face;
    for (const RationalPoint<2>& p : convex_polygon(std::move(shadows))) face.push_back(*lifted.at(p));
    return face;
}

/// The hull as a mesh with one convex polygon for each of its planes; no faces where the points lie in one plane.
[[nodiscard]] inline RationalMesh hull_mesh(std::span<const RationalPoint<3>> points) {
    const IncrementalHull hull(points);
    std::map<Vector<4, Integer>, std::vector<RationalPoint<3>>> faces;
    for (const IncrementalHull::Triangle& t : hull.triangles())
        for (const std::uint32_t corner : t.corners)
            faces[primitive_integers(t.plane.coefficients())].push_back(points[corner]);
    RationalMesh mesh;
    std::map<RationalPoint<3>, std::uint32_t> index;
    for (const auto& [plane, corners] : faces) {
        std::vector<std::uint32_t> polygon;
        for (RationalPoint<3>& p : convex_face(plane, corners)) {
            const auto [at, is_new] = index.try_emplace(p, static_cast<std::uint32_t>(mesh.points.size()));
            if (is_new) mesh.points.push_back(std::move(p));
            polygon.push_back(at->second);
        }
        mesh.add_face(polygon);
    }
    return mesh;
}

}  // namespace detail

/// The convex hull of points in any order and number, duplicates allowed. Points that span no interior (too few, or all
/// in one hyperplane) give the empty set. Each plane of the hull carries one face, whatever number of points lie on it,
/// and only extreme points become vertices.
/// Throws: NumberError for a coordinate that is infinite or NaN.
/// Cost: O(n log n) for D <= 2; for D = 3 n times the number of triangles, so meant for hundreds of points; for D >= 4
/// a cut of the polar (see `shape/polar_hull.hpp`) for each point.
template <int D, class N = Rational>
[[nodiscard]] Region<D, N> convex_hull(std::span<const std::array<N, std::size_t(D)>> points) {
    std::vector<RationalPoint<D>> p;
    p.reserve(points.size());
    for (const auto& x : points) p.push_back(to_rational_point(x));
    if constexpr (D == 1) {
        if (p.empty()) return Region<1, N>::empty();
        const auto [least, largest] = std::minmax_element(p.begin(), p.end());
        return Region<1, N>(intervals<Rational>({{(*least)[0], (*largest)[0]}}));
    } else if constexpr (D == 2) {
        const std::vector<RationalPoint<2>> hull = convex_polygon(std::move(p));
        return hull.size() < 3 ? Region<2, N>::empty() : Region<2, N>(polygon<Rational>(hull));
    } else if constexpr (D == 3) {
        return to_region<N>(detail::hull_mesh(p));
    } else {
        return Region<D, N>(detail::PolarHull<D>(p).build());
    }
}

/// The same for a list: `convex_hull<2>({{0, 0}, {4, 0}, {2, 1}, {0, 3}})`.
template <int D, class N = Rational>
[[nodiscard]] Region<D, N> convex_hull(const std::vector<std::array<N, std::size_t(D)>>& points) {
    return convex_hull<D, N>(std::span<const std::array<N, std::size_t(D)>>(points));
}

CLEAVE_END_NAMESPACE

#endif
