// SPDX-License-Identifier: Apache-2.0
/// Whether an operand contains a point off its boundary: an exact ray, past all faces where few points are asked for,
/// through a hierarchy of them where many are.
#ifndef CLEAVE_SETOP_POINT_LOCATION_HPP
#define CLEAVE_SETOP_POINT_LOCATION_HPP

#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/geometry/kernel_turn.hpp>
#include <cleave/region/surface_operands.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Locates points with respect to one operand. The ray runs along the last axis; where it would pass through an edge or
/// a vertex, the point counts as moved by an infinitesimal along the second axis and by its square along the first, the
/// same for all faces, so that every face decides alike [Edelsbrunner-Muecke-1990].
class PointLocation {
public:
    PointLocation(SurfaceOperands& operands, std::uint32_t operand) : operands_(&operands), operand_(operand) {}

    /// Whether the operand contains point p of operand i. Requires: p is not on its boundary.
    bool contains(std::uint32_t i, PointId p) {
        if (operands_->is_of_doubles(i, p)) {
            doubles_ = operands_->position(i, p);
            return cast(no_id, doubles_, 0);
        }
        return contains(operands_->point(i, p));
    }

    /// The same for a point of the kernel.
    bool contains(PointId p) {
        Kernel<3>& kernel = operands_->kernel();
        kernel.refine(p);
        const PointRecord<3>& r = kernel.point(p);
        doubles_ = r.approximation;
        return cast(r.is_of_doubles() ? no_id : p, r.approximation, r.error);
    }

private:
    bool cast(PointId p, const std::array<double, 3>& x, double error) {
        point_ = p;
        Bounds<3> bounds;
        bounds.include(x, error);
        bounds.hi[2] = std::numeric_limits<double>::infinity();
        bool inside = operands_->boundary(operand_).value_at_infinity;
        const auto visit = [&](std::size_t f) {
            if (is_hit(static_cast<std::uint32_t>(f))) inside = !inside;
        };
        if (queries_ < worth_a_hierarchy) {
            ++queries_;
            const std::size_t faces = operands_->boundary(operand_).faces.faces.size();
            for (std::size_t f = 0; f < faces; ++f)
                if (!box_of(f).disjoint(bounds)) visit(f);
            return inside;
        }
        if (!has_hierarchy_) build();
        Box<3> ray;
        ray.lo = bounds.lo;
        ray.hi = bounds.hi;
        hierarchy_.for_each_meeting(ray, visit);
        return inside;
    }

    [[nodiscard]] Bounds<3> box_of(std::size_t f) const {
        const Boundary<3>& b = operands_->boundary(operand_);
        Bounds<3> bounds;
        for (const Corner& c : b.faces.corners_of(f))
            bounds.include(b.points[c.point].approximation, b.points[c.point].error);
        return bounds;
    }

    void build() {
        std::vector<Box<3>> boxes(operands_->boundary(operand_).faces.faces.size());
        for (std::size_t f = 0; f < boxes.size(); ++f) {
            const Bounds<3> bounds = box_of(f);
            boxes[f].lo = bounds.lo;
            boxes[f].hi = bounds.hi;
        }
        hierarchy_ = BoxHierarchy<3>(boxes);
        has_hierarchy_ = true;
    }

    /// Whether the moved ray crosses face f.
    bool is_hit(std::uint32_t f) {
        const Boundary<3>& b = operands_->boundary(operand_);
        const FaceList::Face& face = b.faces.faces[f];
        bool covered = false;
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            const std::span<const Corner> loop = b.faces.loop(l);
            for (std::size_t n = 0; n < loop.size(); ++n)
                if (passes(loop[n].point, loop[n + 1 == loop.size() ? 0 : n + 1].point)) covered = !covered;
        }
        if (!covered) return false;
        const Sign up = upward(f);
        return up != Sign::zero && side(f) == -up;
    }

    /// Whether the edge crosses the line through the point along the first axis, beyond the point.
    bool passes(PointId a, PointId b) {
        const bool a_below = compare(1, a) != Sign::plus;
        const bool b_below = compare(1, b) != Sign::plus;
        if (a_below == b_below) return false;
        Sign s = turn_to(a, b);
        if (s == Sign::zero) {
            s = between(0, a, b);
            if (s == Sign::zero) s = -between(1, a, b);
        }
        return s == (a_below ? Sign::plus : Sign::minus);
    }

    /// The order of coordinate `axis` of corner a and the point.
    Sign compare(int axis, PointId a) {
        if (point_ == no_id && operands_->is_of_doubles(operand_, a)) {
            const double x = operands_->position(operand_, a)[std::size_t(axis)];
            const double y = doubles_[std::size_t(axis)];
            return sign_of_value(int(x > y) - int(x < y));
        }
        return operands_->kernel().compare(axis, operands_->point(operand_, a), kernel_point());
    }

    /// The sign of b - a on an axis.
    Sign between(int axis, PointId a, PointId b) {
        if (operands_->is_of_doubles(operand_, a) && operands_->is_of_doubles(operand_, b)) {
            const double x = operands_->position(operand_, a)[std::size_t(axis)];
            const double y = operands_->position(operand_, b)[std::size_t(axis)];
            return sign_of_value(int(y > x) - int(y < x));
        }
        return operands_->kernel().compare(axis, operands_->point(operand_, b), operands_->point(operand_, a));
    }

    /// The turn a, b, point seen from the end of the last axis.
    Sign turn_to(PointId a, PointId b) {
        if (point_ == no_id && operands_->is_of_doubles(operand_, a) && operands_->is_of_doubles(operand_, b))
            return turn(operands_->position(operand_, a), operands_->position(operand_, b), doubles_,
                        Projection::along(2));
        return turn(operands_->kernel(), operands_->point(operand_, a), operands_->point(operand_, b), kernel_point(),
                    Projection::along(2));
    }

    /// The sign of the last coordinate of face f's normal.
    Sign upward(std::uint32_t f) {
        const Boundary<3>& b = operands_->boundary(operand_);
        const FaceList::Face& face = b.faces.faces[f];
        if (face.plane == no_id) {
            const std::span<const Corner> c = b.faces.loop(face.first_loop);
            return turn(b.points[c[0].point].approximation, b.points[c[1].point].approximation,
                        b.points[c[2].point].approximation, Projection::along(2));
        }
        const Sign s = b.planes.exact(unoriented(face.plane))[2].sign();
        return is_flipped(face.plane) ? -s : s;
    }

    Sign side(std::uint32_t f) {
        const Boundary<3>& b = operands_->boundary(operand_);
        const FaceList::Face& face = b.faces.faces[f];
        if (point_ == no_id && face.plane == no_id) {
            const std::span<const Corner> c = b.faces.loop(face.first_loop);
            return plane_side(b.points[c[0].point].approximation, b.points[c[1].point].approximation,
                              b.points[c[2].point].approximation, doubles_);
        }
        return operands_->kernel().side(operands_->plane(operand_, f), kernel_point());
    }

    PointId kernel_point() {
        if (point_ == no_id) point_ = operands_->kernel().add_point(doubles_);
        return point_;
    }

    SurfaceOperands* operands_;
    std::uint32_t operand_;
    /// To build a hierarchy costs about as much as to look at every face so many times.
    static constexpr std::size_t worth_a_hierarchy = 12;
    std::size_t queries_ = 0;  // without it
    BoxHierarchy<3> hierarchy_;
    bool has_hierarchy_ = false;
    PointId point_ = no_id;  // of the kernel; `no_id` while the point is known as doubles alone
    std::array<double, 3> doubles_{};
};

CLEAVE_END_NAMESPACE

#endif
