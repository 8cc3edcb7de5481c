// SPDX-License-Identifier: Apache-2.0
/// Convex facets over the points of a kernel, with tests that need no planes where doubles will do.
#ifndef CLEAVE_REGION_CONVEX_FACETS_HPP
#define CLEAVE_REGION_CONVEX_FACETS_HPP

#include <cleave/geometry/bounds.hpp>
#include <cleave/geometry/double_predicates.hpp>
#include <cleave/geometry/kernel.hpp>
#include <cleave/region/build.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A list of convex facets in 3-D, each a part of some face. Points are equal exactly if their ids are. A triangle of
/// points of doubles may come without planes: tests then go by its corners, and planes are made when asked for.
class ConvexFacets {
public:
    struct Facet {
        std::uint32_t face = 0;
        std::uint32_t first = 0;  ///< of its corners
        std::uint32_t size = 0;
        PlaneId plane = no_id;  ///< `no_id` until asked for
        bool is_plain = false;  ///< a triangle of doubles
    };

    explicit ConvexFacets(Kernel<3>& kernel) : kernel_(&kernel) {}

    [[nodiscard]] Kernel<3>& kernel() const noexcept { return *kernel_; }
    [[nodiscard]] std::size_t size() const noexcept { return facets_.size(); }
    [[nodiscard]] const Facet& operator[](std::uint32_t f) const { return facets_[f]; }
    [[nodiscard]] std::span<const Corner> corners(std::uint32_t f) const {
        return {corners_.data() + facets_[f].first, facets_[f].size};
    }
    [[nodiscard]] PointId corner(std::uint32_t f, std::size_t i) const { return corners_[facets_[f].first + i].point; }
    /// Whether the edge from corner i is no edge of the face: the face goes on beyond it.
    [[nodiscard]] bool is_inner(std::uint32_t f, std::size_t i) const { return inner_[facets_[f].first + i]; }
    /// The corner after corner i.
    [[nodiscard]] std::size_t next(std::uint32_t f, std::size_t i) const {
        return i + 1 == facets_[f].size ? 0 : i + 1;
    }

    void reserve(std::size_t facets, std::size_t corners) {
        facets_.reserve(facets);
        projections_.reserve(facets);
        corners_.reserve(corners);
        inner_.reserve(corners);
    }

    /// Adds a facet. Requires: the loop is convex, in outward order, and its points are representatives; without planes
    /// it is a triangle.
    void add(std::uint32_t face, PlaneId plane, std::span<const Corner> loop, std::span<const bool> inner = {}) {
        Facet f{face, static_cast<std::uint32_t>(corners_.size()), static_cast<std::uint32_t>(loop.size()), plane,
                loop.size() == 3};
        for (std::size_t i = 0; i < loop.size(); ++i) {
            corners_.push_back(loop[i]);
            inner_.push_back(!inner.empty() && inner[i]);
            f.is_plain = f.is_plain && kernel_->point(loop[i].point).is_of_doubles();
        }
        CLEAVE_REQUIRES(plane != no_id || loop.size() == 3);
        facets_.push_back(f);
        projections_.push_back({0, 0});
    }

    /// The oriented plane of facet f.
    [[nodiscard]] PlaneId plane(std::uint32_t f) {
        PlaneId& plane = facets_[f].plane;
        if (plane == no_id) {
            plane = kernel_->join(std::array<PointId, 3>{corner(f, 0), corner(f, 1), corner(f, 2)}).value();
            for (const Corner& c : corners(f)) kernel_->note_incidence(c.point, unoriented(plane));
        }
        return plane;
    }

    /// Whether the planes of two facets are known, and the same.
    [[nodiscard]] bool are_known_coplanar(std::uint32_t f, std::uint32_t g) const {
        return facets_[f].plane != no_id && unoriented(facets_[f].plane) == unoriented(facets_[g].plane);
    }

    /// A plane through the edge from corner i, the facet on its minus side.
    [[nodiscard]] PlaneId edge(std::uint32_t f, std::size_t i) {
        const PlaneId own = plane(f);
        PlaneId& edge = corners_[facets_[f].first + i].edge;
        if (edge == no_id) edge = plane_across(*kernel_, own, corner(f, i), corner(f, next(f, i)));
        return edge;
    }

    /// The box of facet f.
    [[nodiscard]] Bounds<3> bounds(std::uint32_t f) {
        Bounds<3> box;
        for (const Corner& c : corners(f)) {
            if (!(kernel_->point(c.point).error < std::numeric_limits<double>::infinity())) kernel_->refine(c.point);
            box.include(kernel_->point(c.point).approximation, kernel_->point(c.point).error);
        }
        return box;
    }

    /// Whether a point is known by its doubles.
    [[nodiscard]] bool is_of_doubles(PointId p) const { return kernel_->point(p).is_of_doubles(); }
    [[nodiscard]] const std::array<double, 3>& position(PointId p) const { return kernel_->point(p).approximation; }

    /// The side of facet f's plane on which p lies.
    [[nodiscard]] Sign side(std::uint32_t f, PointId p) {
        if (facets_[f].plane == no_id && facets_[f].is_plain && is_of_doubles(p))
            return plane_side(position(corner(f, 0)), position(corner(f, 1)), position(corner(f, 2)), position(p));
        return kernel_->side(plane(f), p);
    }

    /// The side of the edge from corner i on which p lies within the facet's plane: minus is the facet's.
    /// Requires: p is in the plane.
    [[nodiscard]] Sign edge_side(std::uint32_t f, std::size_t i, PointId p) {
        if (corner(f, i) == p || corner(f, next(f, i)) == p) return Sign::zero;
        if (facets_[f].is_plain && is_of_doubles(p))
            return -turn(position(corner(f, i)), position(corner(f, next(f, i))), position(p), projection(f));
        return kernel_->side(edge(f, i), p);
    }

private:
    /// One in which a plain facet is counter-clockwise.
    [[nodiscard]] Projection projection(std::uint32_t f) {
        Projection& known = projections_[f];
        if (known.u != known.v) return known;
        const auto &p = position(corner(f, 0)), &q = position(corner(f, 1)), &r = position(corner(f, 2));
        const auto take = [&](unsigned axis, Sign s) { known = Projection::along(axis, s == Sign::minus); };
        // Rounding nearly always finds an axis; exact tests of the axes in the plane would cost the most.
        for (unsigned axis = 0; axis < 3 && known.u == known.v && !filtering::always_fails; ++axis)
            if (const auto s = approximate_turn(p, q, r, Projection::along(axis))) take(axis, *s);
        for (unsigned axis = 0; axis < 3 && known.u == known.v; ++axis)
            if (const Sign s = turn(p, q, r, Projection::along(axis)); s != Sign::zero) take(axis, s);
        CLEAVE_ASSERT(known.u != known.v);  // a facet has an area
        return known;
    }

    Kernel<3>* kernel_;
    std::vector<Facet> facets_;
    std::vector<Corner> corners_;
    std::vector<bool> inner_;              // per corner
    std::vector<Projection> projections_;  // per facet; onto one axis where not found yet
};

CLEAVE_END_NAMESPACE

#endif
