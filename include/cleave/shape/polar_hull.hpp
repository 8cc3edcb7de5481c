// SPDX-License-Identifier: Apache-2.0
/// The convex hull in any dimension through its polar [Ziegler-1995, section 2.3].
#ifndef CLEAVE_SHAPE_POLAR_HULL_HPP
#define CLEAVE_SHAPE_POLAR_HULL_HPP

#include <cleave/algebra/echelon.hpp>
#include <cleave/clip/polytope.hpp>
#include <cleave/geometry/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/region/make.hpp>
#include <cleave/shape/rational_point.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// The indices of D + 1 points that span space; fewer where no points do.
template <int D>
[[nodiscard]] std::vector<std::size_t> spanning_points(std::span<const RationalPoint<D>> points) {
    if (points.empty()) return {};
    const Echelon<Rational> edges(D, int(points.size()) - 1, [&](int i, int j) {
        return Rational(points[std::size_t(j) + 1][std::size_t(i)] - points[0][std::size_t(i)]);
    });
    std::vector<std::size_t> chosen{0};
    for (int k = 0; k < edges.rank(); ++k) chosen.push_back(std::size_t(edges.pivot_column(k)) + 1);
    return chosen;
}

/// The hull of points p around an interior point c is { x : y . (x - c) <= 1 for all y in P }, where P, the *polar*, is
/// { y : (p - c) . y <= 1 for all p }: bounded, because the p are all around c. Facets of the hull are vertices of P
/// and the other way round, so cutting P out of space by one half-space for each point gives all incidences of the
/// hull, and no point is ever tested against a facet of the hull.
template <int D>
class PolarHull {
public:
    explicit PolarHull(std::span<const RationalPoint<D>> points) : points_(points) {}

    /// The hull's boundary; no faces where the points span no interior. Every extreme point keeps its coordinates.
    [[nodiscard]] Boundary<D> build() {
        const std::vector<std::size_t> first = spanning_points<D>(points_);
        if (first.size() <= std::size_t(D)) return Boundary<D>();
        for (Rational& c : centre_) c = 0;
        for (const std::size_t i : first)
            for (std::size_t axis = 0; axis < std::size_t(D); ++axis) centre_[axis] += points_[i][axis] / (D + 1);
        Polytope polar = universe(polar_kernel_);
        // The spanning points first: from then on the polar is bounded.
        for (const std::size_t i : first) cut(polar, i);
        for (std::size_t i = 0; i < points_.size(); ++i) cut(polar, i);

        Kernel<D> kernel;
        std::vector<PlaneId> facets;
        for (const PointId y : polar.points)
            facets.push_back(kernel.planes.intern(facet_plane(polar_kernel_.exact(y))));
        Polytope hull;
        std::vector<std::uint32_t> through;
        for (const PolytopeFace& dual : largest_faces(polar)) {
            through.clear();
            for (const std::uint32_t y : dual.vertices) through.push_back(unoriented(facets[y]));
            std::sort(through.begin(), through.end());
            const PointId p = cleave::add_point<Rational, std::size_t(D)>(kernel, points_[point_[dual.plane]]);
            for (const std::uint32_t k : through) kernel.note_incidence(p, k);
            hull.add_vertex(p, through);
        }
        return boundary_of_cell<D>(kernel, hull, facets);
    }

private:
    /// Reduces the polar by the half-space of point i.
    void cut(Polytope& polar, std::size_t i) {
        Vector<D + 1, Rational> c;
        bool is_centre = true;
        for (std::size_t axis = 0; axis < std::size_t(D); ++axis) {
            c[axis] = points_[i][axis] - centre_[axis];
            is_centre = is_centre && c[axis] == 0;
        }
        if (is_centre) return;
        c[std::size_t(D)] = -1;
        const PlaneId h = polar_kernel_.planes.intern(primitive_integers(c));
        if (unoriented(h) >= point_.size()) point_.resize(unoriented(h) + 1);
        point_[unoriented(h)] = i;  // equal planes come from equal points
        PolytopeSplit s = cutter_.split(h, polar);
        if (s.side == FacetSide::crossing) polar = std::move(s.minus);
    }

    /// Y . (x - c) <= W for the vertex Y / W of the polar.
    [[nodiscard]] Vector<D + 1, Integer> facet_plane(const Homogeneous<D>& y) const {
        Vector<D + 1, Rational> c;
        c[std::size_t(D)] = -number_traits<Rational>::from_integer(y[std::size_t(D)]);
        for (std::size_t axis = 0; axis < std::size_t(D); ++axis) {
            c[axis] = number_traits<Rational>::from_integer(y[axis]);
            c[std::size_t(D)] -= c[axis] * centre_[axis];
        }
        return primitive_integers(c);
    }

    std::span<const RationalPoint<D>> points_;
    RationalPoint<D> centre_;
    Kernel<D> polar_kernel_;
    PolytopeCutter<D> cutter_{polar_kernel_};
    std::vector<std::size_t> point_;  // whose half-space a plane of the polar's kernel bounds
};

}  // namespace detail

CLEAVE_END_NAMESPACE

#endif
