// SPDX-License-Identifier: Apache-2.0
/// Common segments of operands, cut where others cross them or end on them.
#ifndef CLEAVE_SETOP_SEGMENT_NODING_HPP
#define CLEAVE_SETOP_SEGMENT_NODING_HPP

#include <cleave/geometry/box_pairs.hpp>
#include <cleave/setop/contact_records.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Segments that a face has in common with two other operands may cross: three operands meet there. Where one operand's
/// boundary touches itself (a ridge lying on a face, say), segments may overlap without being equal, and points on an
/// edge be unknown to a face that contains the edge. One pass cuts each segment at such points.
class SegmentNoding {
public:
    /// Requires: each operand's points ascend by face.
    SegmentNoding(SurfaceOperands& operands, std::vector<CommonSegment>& segments,
                  std::vector<std::vector<PointContact>>& points)
        : operands_(&operands), segments_(&segments), points_(&points) {}

    /// Returns: whether anything was cut.
    bool run() {
        find_points_on_edges();
        find_crossings();
        if (cuts_.empty()) return false;
        std::sort(cuts_.begin(), cuts_.end());
        cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
        for (std::size_t n = 0; n < cuts_.size();) {
            std::size_t end = n;
            while (end < cuts_.size() && cuts_[end].first == cuts_[n].first) ++end;
            cut(cuts_[n].first, {cuts_.data() + n, end - n});
            n = end;
        }
        return true;
    }

private:
    using Cut = std::pair<std::size_t, PointId>;

    /// A segment inside a face: of its two faces, the one with this index.
    struct Inside {
        std::uint32_t operand;
        std::uint32_t face;
        std::size_t segment;
        std::size_t slot;

        friend bool operator<(const Inside& a, const Inside& b) {
            if (a.operand != b.operand) return a.operand < b.operand;
            return std::pair(a.face, a.segment) < std::pair(b.face, b.segment);
        }
    };

    void find_points_on_edges() {
        for (std::size_t s = 0; s < segments_->size(); ++s)
            for (const std::size_t slot : {std::size_t(0), std::size_t(1)}) {
                const CommonSegment& c = (*segments_)[s];
                if (c.corner[slot] == no_id) continue;
                const std::vector<PointContact>& points = (*points_)[c.operand[slot]];
                auto p = std::lower_bound(points.begin(), points.end(), c.face[slot],
                                          [](const PointContact& x, std::uint32_t face) { return x.face < face; });
                for (; p != points.end() && p->face == c.face[slot]; ++p)
                    if (p->of_face.kind == Feature::Kind::edge && p->of_face.corner == c.corner[slot])
                        try_cut(s, p->point);
            }
    }

    /// Two segments inside one face can have more in common than an end if they are of different operands, or if one of
    /// them runs along an edge of its operand.
    static bool can_meet(const CommonSegment& a, std::size_t a_slot, const CommonSegment& b, std::size_t b_slot) {
        return a.operand[1 - a_slot] != b.operand[1 - b_slot] || a.corner[1 - a_slot] != no_id ||
               b.corner[1 - b_slot] != no_id;
    }

    void find_crossings() {
        inside_.clear();
        const bool any =
            operands_->count() > 2 || std::any_of(segments_->begin(), segments_->end(), [](const CommonSegment& c) {
                return (c.corner[0] == no_id) != (c.corner[1] == no_id);
            });
        if (!any) return;
        for (std::size_t s = 0; s < segments_->size(); ++s) {
            const CommonSegment& c = (*segments_)[s];
            for (const std::size_t slot : {std::size_t(0), std::size_t(1)})
                if (c.corner[slot] == no_id) inside_.push_back({c.operand[slot], c.face[slot], s, slot});
        }
        std::sort(inside_.begin(), inside_.end());
        for (std::size_t n = 0; n < inside_.size();) {
            std::size_t end = n;
            bool worth = false;
            for (; end < inside_.size() && inside_[end].operand == inside_[n].operand &&
                   inside_[end].face == inside_[n].face;
                 ++end)
                worth = worth || can_meet((*segments_)[inside_[n].segment], inside_[n].slot,
                                          (*segments_)[inside_[end].segment], inside_[end].slot);
            if (worth) node({inside_.data() + n, end - n});
            n = end;
        }
    }

    /// All segments inside one face.
    void node(std::span<const Inside> group) {
        constexpr std::size_t few = 12;
        const auto visit = [&](std::uint32_t a, std::uint32_t b) {
            if (a < b) meet(group[a], group[b]);
        };
        if (group.size() <= few) {
            for (std::uint32_t a = 0; a < group.size(); ++a)
                for (std::uint32_t b = a + 1; b < group.size(); ++b) visit(a, b);
            return;
        }
        std::array<std::vector<NamedBox<3>>, 2> boxes;
        for (std::uint32_t n = 0; n < group.size(); ++n) {
            const CommonSegment& c = (*segments_)[group[n].segment];
            NamedBox<3> box;
            box.name = n;
            for (const PointId p : {c.from, c.to}) {
                const PointRecord<3>& r = operands_->kernel().point(p);
                box.box.include(r.approximation, r.error);
            }
            boxes[0].push_back(box);
        }
        boxes[1] = boxes[0];
        for_each_meeting_pair<3>(boxes[0], boxes[1], visit);
    }

    /// Cuts two segments of one face at each other.
    void meet(const Inside& x, const Inside& y) {
        const CommonSegment a = (*segments_)[x.segment];
        const CommonSegment b = (*segments_)[y.segment];
        if (!can_meet(a, x.slot, b, y.slot)) return;
        if ((a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from)) return;
        Kernel<3>& kernel = operands_->kernel();
        const PlaneId across_b = plane_across(b, y.slot);
        const Sign a_from = kernel.side(across_b, a.from);
        const Sign a_to = kernel.side(across_b, a.to);
        if (a_from == a_to && a_from != Sign::zero) return;
        if (a_from == a_to) {
            for (const PointId p : {a.from, a.to}) try_cut(y.segment, p);
            for (const PointId p : {b.from, b.to}) try_cut(x.segment, p);
            return;
        }
        const PlaneId across_a = plane_across(a, x.slot);
        const Sign b_from = kernel.side(across_a, b.from);
        const Sign b_to = kernel.side(across_a, b.to);
        if (b_from == b_to) return;
        // The lines cross in one point; it is inside a segment whose ends are on both sides of the other's line.
        const bool in_a = a_from * a_to == Sign::minus;
        const bool in_b = b_from * b_to == Sign::minus;
        if (!in_a) {
            if (in_b) cuts_.push_back({y.segment, a_from == Sign::zero ? a.from : a.to});
            return;
        }
        if (!in_b) {
            cuts_.push_back({x.segment, b_from == Sign::zero ? b.from : b.to});
            return;
        }
        const PlaneId face = operands_->plane(x.operand, x.face);
        const PointId p =
            operands_->interner()(kernel.cross(across_b, a.from, a.to, {unoriented(face), unoriented(across_a)}));
        cuts_.push_back({x.segment, p});
        cuts_.push_back({y.segment, p});
    }

    /// A plane that meets the segment's face `slot` in the segment's line.
    PlaneId plane_across(const CommonSegment& c, std::size_t slot) {
        if (c.edge_of == no_id) return operands_->plane(c.operand[1 - slot], c.face[1 - slot]);
        const std::uint32_t i = c.operand[c.edge_of];
        const std::uint32_t face = c.face[c.edge_of];
        FaceOutline outline;
        outline.read(*operands_, i, face);
        for (const FaceOutline::Entry& e : outline.entries)
            if (e.corner == c.corner[c.edge_of])
                return 2 * operands_->edge_plane(i, face, e.corner, e.point, outline.entries[e.next].point);
        CLEAVE_ASSERT(false);  // a segment along an edge names it
        return no_id;
    }

    void try_cut(std::size_t s, PointId p) {
        const CommonSegment& c = (*segments_)[s];
        if (p == c.from || p == c.to) return;
        Kernel<3>& kernel = operands_->kernel();
        for (int axis = 0; axis < 3; ++axis) {
            const Sign a = kernel.compare(axis, c.from, p);
            const Sign b = kernel.compare(axis, p, c.to);
            if (a != b) return;  // on the line, it is between the ends on every axis or on none
        }
        cuts_.push_back({s, p});
    }

    /// Replaces segment s by its parts.
    void cut(std::size_t s, std::span<const Cut> at) {
        Kernel<3>& kernel = operands_->kernel();
        const CommonSegment whole = (*segments_)[s];
        std::vector<PointId> points;
        for (const Cut& c : at) points.push_back(c.second);
        if (points.size() > 1) {
            const AxisDirection d = direction_between(kernel, whole.from, whole.to);
            std::sort(points.begin(), points.end(),
                      [&](PointId p, PointId q) { return p != q && kernel.compare(d.axis, q, p) == d.sign; });
        }
        for (const std::size_t slot : {std::size_t(0), std::size_t(1)})
            for (const PointId p : points)
                (*points_)[whole.operand[slot]].push_back({whole.face[slot], whole.feature(slot),
                                                           whole.feature(1 - slot), p, whole.operand[1 - slot],
                                                           whole.face[1 - slot]});
        points.push_back(whole.to);
        (*segments_)[s].to = points[0];
        for (std::size_t n = 1; n < points.size(); ++n) {
            CommonSegment part = whole;
            part.from = points[n - 1];
            part.to = points[n];
            segments_->push_back(part);
        }
    }

    SurfaceOperands* operands_;
    std::vector<CommonSegment>* segments_;
    std::vector<std::vector<PointContact>>* points_;
    std::vector<Inside> inside_;
    std::vector<Cut> cuts_;
};

CLEAVE_END_NAMESPACE

#endif
