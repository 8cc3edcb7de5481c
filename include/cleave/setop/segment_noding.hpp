// SPDX-License-Identifier: Apache-2.0
/// Common segments of two operands, cut where others end on them.
#ifndef CLEAVE_SETOP_SEGMENT_NODING_HPP
#define CLEAVE_SETOP_SEGMENT_NODING_HPP

#include <cleave/setop/face_contact.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A common segment of a face of operand 0 and one of operand 1; see `ContactSegment`. Index 0 or 1 is the operand.
struct CommonSegment {
    std::array<std::uint32_t, 2> face;
    std::array<std::uint32_t, 2> corner;  ///< of the face's edge that contains it, or `no_id`
    PointId from, to;
    std::array<std::uint8_t, 2> sides;
    std::uint32_t edge_of;  ///< coplanar faces: the operand along whose edge it runs; `no_id` for others
    bool opposite;          ///< coplanar: whether they face opposite ways
};

/// A common point as one of its faces sees it.
struct PointContact {
    std::uint32_t face;
    Feature of_face;
    Feature of_other;
    PointId point;
    std::uint32_t other;
};

/// Where an operand's boundary touches itself (a ridge lying on a face, say), common segments of different faces may
/// overlap without being equal, and points on an edge be unknown to a face that contains the edge. One pass cuts each
/// segment at the ends of those that it overlaps, and at the points on the edges along which it runs.
class SegmentNoding {
public:
    /// Requires: points ascend by face.
    SegmentNoding(SurfaceOperands& operands, std::vector<CommonSegment>& segments,
                  std::array<std::vector<PointContact>, 2>& points)
        : operands_(&operands), segments_(&segments), points_(&points) {}

    /// Returns: whether anything was cut.
    bool run() {
        find_points_on_edges();
        find_overlaps(0);
        find_overlaps(1);
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

    void find_points_on_edges() {
        for (std::size_t s = 0; s < segments_->size(); ++s)
            for (const std::uint32_t i : {0U, 1U}) {
                const CommonSegment& c = (*segments_)[s];
                if (c.corner[i] == no_id) continue;
                const std::vector<PointContact>& points = (*points_)[i];
                auto p = std::lower_bound(points.begin(), points.end(), c.face[i],
                                          [](const PointContact& x, std::uint32_t face) { return x.face < face; });
                for (; p != points.end() && p->face == c.face[i]; ++p)
                    if (p->of_face.kind == Feature::Kind::edge && p->of_face.corner == c.corner[i])
                        try_cut(s, p->point);
            }
    }

    /// Segments inside one face of operand i, of which at least one runs along an edge of the other operand.
    void find_overlaps(std::uint32_t i) {
        const std::uint32_t j = 1 - i;
        std::vector<std::pair<std::uint32_t, std::size_t>> inside;
        bool any = false;
        for (std::size_t s = 0; s < segments_->size(); ++s) {
            const CommonSegment& c = (*segments_)[s];
            if (c.corner[i] != no_id) continue;
            inside.push_back({c.face[i], s});
            any = any || c.corner[j] != no_id;
        }
        if (!any) return;
        std::sort(inside.begin(), inside.end());
        for (std::size_t n = 0; n < inside.size();) {
            std::size_t end = n;
            while (end < inside.size() && inside[end].first == inside[n].first) ++end;
            for (std::size_t e = n; e < end; ++e) {
                const std::size_t edge = inside[e].second;
                if ((*segments_)[edge].corner[j] == no_id) continue;
                for (std::size_t o = n; o < end; ++o)
                    if (o != e) overlap(j, edge, inside[o].second);
            }
            n = end;
        }
    }

    /// Cuts segments of one face, the first along an edge of operand j, at each other's ends if they are on one line.
    void overlap(std::uint32_t j, std::size_t a, std::size_t b) {
        const CommonSegment x = (*segments_)[a];
        const CommonSegment y = (*segments_)[b];
        if ((x.from == y.from && x.to == y.to) || (x.from == y.to && x.to == y.from)) return;
        Kernel<3>& kernel = operands_->kernel();
        const PlaneId line = y.edge_of == no_id ? operands_->plane(j, y.face[j]) : 2 * edge_plane(y);
        if (kernel.side(line, x.from) != Sign::zero || kernel.side(line, x.to) != Sign::zero) return;
        for (const PointId p : {x.from, x.to}) try_cut(b, p);
        for (const PointId p : {y.from, y.to}) try_cut(a, p);
    }

    std::uint32_t edge_plane(const CommonSegment& y) {
        const std::uint32_t i = y.edge_of;
        FaceOutline outline;
        outline.read(*operands_, i, y.face[i]);
        for (const FaceOutline::Entry& e : outline.entries)
            if (e.corner == y.corner[i])
                return operands_->edge_plane(i, y.face[i], e.corner, e.point, outline.entries[e.next].point);
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
        int axis = 0;
        while (kernel.compare(axis, whole.from, whole.to) == Sign::zero) ++axis;
        const Sign up = kernel.compare(axis, whole.to, whole.from);
        std::sort(points.begin(), points.end(),
                  [&](PointId p, PointId q) { return p != q && kernel.compare(axis, q, p) == up; });
        for (const std::uint32_t i : {0U, 1U}) {
            if (whole.corner[i] == no_id) continue;
            const std::uint32_t j = 1 - i;
            const Feature own{Feature::Kind::edge, whole.corner[i]};
            const Feature other = whole.corner[j] == no_id ? Feature{} : Feature{Feature::Kind::edge, whole.corner[j]};
            for (const PointId p : points) (*points_)[i].push_back({whole.face[i], own, other, p, whole.face[j]});
        }
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
    std::array<std::vector<PointContact>, 2>* points_;
    std::vector<Cut> cuts_;
};

CLEAVE_END_NAMESPACE

#endif
