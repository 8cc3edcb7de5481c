// SPDX-License-Identifier: Apache-2.0
/// Winding numbers beside the facets of a closed surface that may run through itself: one exact ray each.
#ifndef CLEAVE_REGION_FACET_WINDING_HPP
#define CLEAVE_REGION_FACET_WINDING_HPP

#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/geometry/double_predicates.hpp>
#include <cleave/geometry/kernel_box.hpp>
#include <cleave/geometry/kernel_turn.hpp>
#include <cleave/region/convex_facets.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Tells how often the facets of a list run around the points just above and just below a piece of one of them. All
/// facets need planes.
///
/// A ray runs from a point inside the piece along the axis on which its normal is longest. Where it would pass through
/// an edge or a corner, the point counts as moved within the piece: by an infinitesimal along one of the other axes and
/// by its square along the other, the same for all facets, so that every facet decides alike
/// [Edelsbrunner-Muecke-1990].
class FacetWinding {
public:
    /// The winding numbers on the two sides of a piece.
    struct Sides {
        int minus = 0;
        int plus = 0;
        std::uint32_t first = no_id;  ///< the least facet that covers the piece
    };

    /// `at_infinity`: the winding number far away.
    FacetWinding(ConvexFacets& facets, int at_infinity) : facets_(&facets), at_infinity_(at_infinity) {
        std::vector<Box<3>> boxes(facets.size());
        for (std::uint32_t f = 0; f < boxes.size(); ++f) {
            const Bounds<3> bounds = facets.bounds(f);
            boxes[f] = Box<3>(bounds.lo, bounds.hi);
        }
        hierarchy_ = BoxHierarchy<3>(boxes);
    }

    /// The numbers beside a convex piece of facet f, which no other facet enters. `coplanar`: the other facets on f's
    /// plane that have inner points in common with f.
    Sides beside(std::uint32_t f, std::span<const Corner> piece, std::span<const std::uint32_t> coplanar) {
        const PlaneId plane = facets_->plane(f);
        axis_ = dominant_axis(kernel(), unoriented(plane));
        // Other facets touch the piece in finitely many points at most; no ray may start in one of them.
        for (unsigned attempt = 0;; ++attempt) {
            point_ = inner_point(plane, piece, attempt);
            const std::optional<int> above = above_point(plane);
            if (!above) continue;
            Sides out{0, 0, f};
            const bool upward = normal_sign(plane) == Sign::plus;
            int step = upward ? 1 : -1;
            for (const std::uint32_t g : coplanar) {
                if (!contains_point(g)) continue;
                step += normal_sign(facets_->plane(g)) == Sign::plus ? 1 : -1;
                out.first = std::min(out.first, g);
            }
            out.plus = upward ? *above : *above + step;
            out.minus = upward ? *above + step : *above;
            return out;
        }
    }

private:
    [[nodiscard]] Kernel<3>& kernel() const { return facets_->kernel(); }

    [[nodiscard]] Sign normal_sign(PlaneId h) const {
        const Sign s = kernel().planes.exact(unoriented(h))[std::size_t(axis_)].sign();
        return is_flipped(h) ? -s : s;
    }

    /// A point inside the piece: where its average corner, rounded, projects to, or else an exact average of three.
    PointId inner_point(PlaneId plane, std::span<const Corner> piece, unsigned attempt) {
        std::array<double, 3> sum{};
        double weights = 0;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            kernel().refine(piece[i].point);
            const double weight = 1 + double((i + 1) * attempt % 97);
            for (std::size_t x = 0; x < 3; ++x) sum[x] += weight * kernel().point(piece[i].point).approximation[x];
            weights += weight;
        }
        for (std::size_t x = 0; x < 3; ++x) position_[x] = sum[x] / weights;
        is_above_doubles_ = std::isfinite(position_[0]) && std::isfinite(position_[1]) && std::isfinite(position_[2]);
        if (is_above_doubles_) {
            const PointId p = kernel().add_point(lifted(plane));
            bool inside = true;
            for (const Corner& c : piece) inside = inside && kernel().side(c.edge, p) == Sign::minus;
            if (inside) return p;
        }
        is_above_doubles_ = false;
        return exact_average(piece, attempt);
    }

    /// The point of the plane above the rounded position.
    Homogeneous<3> lifted(PlaneId plane) {
        position_[std::size_t(axis_)] = 0;
        const Homogeneous<3> at = homogeneous_of<3>(position_);
        const auto& n = kernel().planes.exact(unoriented(plane));
        const auto a = std::size_t(axis_);
        Homogeneous<3> out;
        WideInteger height(n[3] * WideInteger(at[3]));
        for (std::size_t x = 0; x < 3; ++x) {
            if (x == a) continue;
            out[x] = Integer(at[x] * WideInteger(n[a]));
            add_product(height, n[x], at[x]);
        }
        out[a] = Integer(-height);
        out[3] = Integer(at[3] * WideInteger(n[a]));
        if (out[3].sign() == Sign::minus)
            for (Integer& x : out) x.negate();
        return out;
    }

    PointId exact_average(std::span<const Corner> piece, unsigned attempt) {
        std::size_t third = 2;  // not on the line of the first two
        while (kernel().side(piece[0].edge, piece[third].point) == Sign::zero) ++third;
        std::array<Homogeneous<3>, 3> h{kernel().coordinates(piece[0].point), kernel().coordinates(piece[1].point),
                                        kernel().coordinates(piece[third].point)};
        Homogeneous<3> out;
        for (std::size_t i = 0; i < 3; ++i) {
            WideInteger others(h[(i + 1) % 3][3] * WideInteger(h[(i + 2) % 3][3]));
            if (i == 1) others *= WideInteger(1 + int(attempt));
            if (i == 2) others *= WideInteger(1 + int(attempt) * int(attempt));
            for (std::size_t x = 0; x < 4; ++x) out[x] = Integer(WideInteger(out[x]) + h[i][x] * others);
        }
        return kernel().add_point(std::move(out));
    }

    /// The winding number just above the point along the axis, the facets on its own plane aside; nothing where the
    /// point lies on another facet.
    std::optional<int> above_point(PlaneId plane) {
        Box<3> ray = box_of(kernel(), point_);
        for (std::size_t x = 0; x < 3; ++x)
            if (is_above_doubles_ && x != std::size_t(axis_)) ray.lo[x] = ray.hi[x] = position_[x];
        ray.hi[std::size_t(axis_)] = std::numeric_limits<double>::infinity();
        int winding = at_infinity_;
        bool on_facet = false;
        hierarchy_.for_each_meeting(ray, [&](std::size_t i) {
            const auto g = static_cast<std::uint32_t>(i);
            const PlaneId h = facets_->plane(g);
            if (on_facet || unoriented(h) == unoriented(plane) || !is_crossed(g)) return;
            const Sign side = kernel().side(h, point_);
            const Sign up = normal_sign(h);
            on_facet = side == Sign::zero;
            if (side == -up) winding += up == Sign::plus ? 1 : -1;
        });
        if (on_facet) return std::nullopt;
        return winding;
    }

    /// Whether the line through the moved point along the axis crosses facet g.
    bool is_crossed(std::uint32_t g) {
        if (normal_sign(facets_->plane(g)) == Sign::zero) return false;
        bool crossed = false;
        for (std::size_t i = 0; i < facets_->corners(g).size(); ++i)
            if (passes(facets_->corner(g, i), facets_->corner(g, facets_->next(g, i)))) crossed = !crossed;
        return crossed;
    }

    /// Whether the edge from a to b, seen along the axis, crosses the ray from the moved point in direction u.
    bool passes(PointId a, PointId b) {
        const Projection view = Projection::along(unsigned(axis_));
        const bool a_below = compare(view.v, a) != Sign::plus;
        const bool b_below = compare(view.v, b) != Sign::plus;
        if (a_below == b_below) return false;
        Sign s = turn_to(a, b, view);
        if (s == Sign::zero) {
            s = kernel().compare(view.u, b, a);
            if (s == Sign::zero) s = -kernel().compare(view.v, b, a);
        }
        return s == (a_below ? Sign::plus : Sign::minus);
    }

    /// The order of a coordinate, other than the ray's, of a corner and the point.
    Sign compare(std::size_t axis, PointId a) {
        if (is_above_doubles_ && facets_->is_of_doubles(a)) {
            const double x = facets_->position(a)[axis];
            return sign_of_value(int(x > position_[axis]) - int(x < position_[axis]));
        }
        return kernel().compare(int(axis), a, point_);
    }

    /// The turn a, b, point.
    Sign turn_to(PointId a, PointId b, Projection view) {
        if (is_above_doubles_ && facets_->is_of_doubles(a) && facets_->is_of_doubles(b))
            return turn(facets_->position(a), facets_->position(b), position_, view);
        return turn(kernel(), a, b, point_, view);
    }

    /// Whether facet g, on the point's plane, contains the point, which is on none of its edges.
    bool contains_point(std::uint32_t g) {
        for (std::size_t i = 0; i < facets_->corners(g).size(); ++i)
            if (kernel().side(facets_->edge(g, i), point_) != Sign::minus) return false;
        return true;
    }

    ConvexFacets* facets_;
    int at_infinity_;
    BoxHierarchy<3> hierarchy_;
    int axis_ = 0;                      // of the ray
    PointId point_ = no_id;             // where it starts
    std::array<double, 3> position_{};  // ... of which these are the coordinates other than the ray's,
    bool is_above_doubles_ = false;     // if so
};

CLEAVE_END_NAMESPACE

#endif
