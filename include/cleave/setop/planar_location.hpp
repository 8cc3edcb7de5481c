// SPDX-License-Identifier: Apache-2.0
/// Whether an operand in the plane contains a point off its boundary: an exact ray.
#ifndef CLEAVE_SETOP_PLANAR_LOCATION_HPP
#define CLEAVE_SETOP_PLANAR_LOCATION_HPP

#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/geometry/kernel_box.hpp>
#include <cleave/setop/planar_contacts.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Locates points with respect to one operand. The ray runs along the second axis, upwards; the point counts as moved
/// by an infinitesimal along the first, so that the ray passes no vertex and along no segment, whatever the boundary
/// does there [Edelsbrunner-Muecke-1990].
class PlanarLocation {
public:
    PlanarLocation(PlanarContacts& contacts, std::uint32_t operand) : contacts_(&contacts), operand_(operand) {}

    /// Whether the operand contains p. Requires: p is not on its boundary.
    /// Cost: a few points are compared with all segments; where more are asked for, a hierarchy of boxes is made.
    bool contains(PointId p) {
        const Boundary<2>& b = contacts_->boundary(operand_);
        Box<2> ray = box_of(contacts_->kernel(), p);
        ray.hi[1] = std::numeric_limits<double>::infinity();
        bool inside = b.value_at_infinity;
        const std::uint32_t first = contacts_->first_segment(operand_);
        const auto count = static_cast<std::uint32_t>(b.faces.loop_first.size() - 1);
        const auto visit = [&](std::uint32_t segment) {
            if (is_hit(contacts_->segments()[segment], p)) inside = !inside;
        };
        if (asked_ < without_hierarchy || count < worth_a_hierarchy) {
            ++asked_;
            for (std::uint32_t s = first; s < first + count; ++s) {
                const Bounds<2>& box = contacts_->box(s);
                if (box.lo[0] <= ray.hi[0] && box.hi[0] >= ray.lo[0] && box.hi[1] >= ray.lo[1]) visit(s);
            }
            return inside;
        }
        if (!hierarchy_) make_hierarchy(first, count);
        hierarchy_->for_each_meeting(ray, [&](std::size_t s) { visit(first + static_cast<std::uint32_t>(s)); });
        return inside;
    }

private:
    /// So many rays through all segments cost less than the hierarchy.
    static constexpr std::size_t without_hierarchy = 8;
    static constexpr std::uint32_t worth_a_hierarchy = 64;

    void make_hierarchy(std::uint32_t first, std::uint32_t count) {
        std::vector<Box<2>> boxes(count);
        for (std::uint32_t s = 0; s < count; ++s) {
            boxes[s].lo = contacts_->box(first + s).lo;
            boxes[s].hi = contacts_->box(first + s).hi;
        }
        hierarchy_.emplace(boxes);
    }

    /// Whether the moved ray crosses the segment.
    bool is_hit(const PlanarSegment& s, PointId p) {
        Kernel<2>& kernel = contacts_->kernel();
        const bool from_left = kernel.compare(0, s.from, p) != Sign::plus;
        const bool to_left = kernel.compare(0, s.to, p) != Sign::plus;
        if (from_left == to_left) return false;
        // The operand is on the segment's left: above it where it runs to the right, and p must be below.
        return kernel.side(s.line, p) == (from_left ? Sign::plus : Sign::minus);
    }

    PlanarContacts* contacts_;
    std::uint32_t operand_;
    std::size_t asked_ = 0;
    std::optional<BoxHierarchy<2>> hierarchy_;
};

CLEAVE_END_NAMESPACE

#endif
