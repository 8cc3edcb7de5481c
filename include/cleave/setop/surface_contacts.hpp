// SPDX-License-Identifier: Apache-2.0
/// All contacts of two operands' faces, listed by face.
#ifndef CLEAVE_SETOP_SURFACE_CONTACTS_HPP
#define CLEAVE_SETOP_SURFACE_CONTACTS_HPP

#include <cleave/execution/progress.hpp>
#include <cleave/geometry/box_pairs.hpp>
#include <cleave/setop/segment_noding.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A common segment as one of its faces sees it. Where the other face is coplanar, `up_down` is 0, else `left_right`
/// is. Directed so that a face that is not coplanar has its minus side on the left.
struct SegmentRecord {
    std::uint32_t face;
    std::uint32_t corner;  ///< of the face's edge that contains it, or `no_id`
    PointId from, to;
    std::uint32_t other;      ///< the other operand's face
    std::uint8_t up_down;     ///< 1: the other face is beneath, 2: above
    std::uint8_t left_right;  ///< coplanar; 1: the other face is on the left, 2: on the right
    bool opposite;            ///< coplanar: whether it faces the other way
};

/// Finds where two operands meet. Requires: operands of `SurfaceOperands`, two of them.
class SurfaceContacts {
public:
    /// Tells `progress` of twice `share` units of work.
    SurfaceContacts(SurfaceOperands& operands, ProgressReporter* progress, std::size_t share)
        : operands_(&operands), progress_(progress), contact_(operands) {
        find_near(0);
        find_near(1);
        find_pairs();
        for (const std::uint32_t i : {0U, 1U}) {
            std::vector<std::uint32_t> faces;
            faces.reserve(pairs_.size());
            for (const auto& pair : pairs_) faces.push_back(pair[i]);
            std::sort(faces.begin(), faces.end());
            faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
            operands.connect(i, faces);
        }
        // Finding pairs was a share of the work, what they have in common is another.
        std::size_t told = 0;
        advance(share);
        for (std::size_t n = 0; n < pairs_.size(); ++n) {
            meet(pairs_[n][0], pairs_[n][1]);
            const std::size_t reached = share * (n + 1) / pairs_.size();
            advance(reached - told);
            told = reached;
        }
        advance(share - told);
        for (const std::uint32_t i : {0U, 1U}) sort_by_face(i, points_[i]);
        while (SegmentNoding(operands, common_, points_).run())
            for (const std::uint32_t i : {0U, 1U}) sort_by_face(i, points_[i]);
        list_segments();
    }

    /// Faces of operand i whose boxes meet the other operand's box, ascending.
    [[nodiscard]] std::span<const std::uint32_t> near(std::uint32_t i) const { return near_[i]; }
    /// Records ascend by face.
    [[nodiscard]] std::span<const SegmentRecord> segments(std::uint32_t i) const { return segments_[i]; }
    [[nodiscard]] std::span<const PointContact> points(std::uint32_t i) const { return points_[i]; }
    [[nodiscard]] std::size_t pair_count() const noexcept { return pair_count_; }

private:
    /// A stable sort by face: by counting where there are many records, by comparing where there are few.
    template <class Record>
    void sort_by_face(std::uint32_t i, std::vector<Record>& records) {
        const std::size_t faces = operands_->boundary(i).faces.faces.size();
        if (records.size() < faces / 8) {
            std::stable_sort(records.begin(), records.end(),
                             [](const Record& a, const Record& b) { return a.face < b.face; });
            return;
        }
        std::vector<std::uint32_t> next(faces + 1, 0);
        for (const Record& r : records) ++next[r.face + 1];
        for (std::size_t f = 0; f < faces; ++f) next[f + 1] += next[f];
        std::vector<Record> sorted(records.size());
        for (const Record& r : records) sorted[next[r.face]++] = r;
        records.swap(sorted);
    }

    void advance(std::size_t units) {
        if (progress_ != nullptr && units != 0) progress_->advance(units);
    }

    void find_near(std::uint32_t i) {
        const Boundary<3>& b = operands_->boundary(i);
        const Bounds<3>& other = operands_->boundary(1 - i).bounds;
        for (std::uint32_t f = 0; f < b.faces.faces.size(); ++f) {
            const FaceList::Face& face = b.faces.faces[f];
            Bounds<3> box;
            const std::uint32_t last = b.faces.loop_first[face.first_loop + face.loop_count];
            for (std::uint32_t c = b.faces.loop_first[face.first_loop]; c < last; ++c) {
                const PointRecord<3>& r = b.points[b.faces.corners[c].point];
                if (r.error == 0) {
                    for (std::size_t x = 0; x < 3; ++x) {
                        box.lo[x] = std::min(box.lo[x], r.approximation[x]);
                        box.hi[x] = std::max(box.hi[x], r.approximation[x]);
                    }
                } else {
                    box.include(r.approximation, r.error);
                }
            }
            if (box.disjoint(other)) continue;
            near_[i].push_back(f);
            boxes_[i].push_back({box, f});
        }
    }

    void find_pairs() {
        if (near_[0].empty() || near_[1].empty()) return;
        for_each_meeting_pair<3>(boxes_[0], boxes_[1], [&](std::uint32_t f, std::uint32_t g) {
            if ((++pair_count_ & 0xfffU) == 0 && progress_ != nullptr) progress_->throw_if_stopped();
            if (contact_.reach(0, f, 1, g)) pairs_.push_back({f, g});
        });
        std::sort(pairs_.begin(), pairs_.end());
    }

    void meet(std::uint32_t f, std::uint32_t g) {
        if (contact_.find(0, f, 1, g)) {
            meet_coplanar(f, g);
            return;
        }
        for (const ContactSegment& s : contact_.segments())
            common_.push_back(
                {{f, g}, {s.of_f.corner, s.of_g.corner}, s.from, s.to, {s.f_sides, s.g_sides}, no_id, false});
        for (const ContactPoint& p : contact_.points()) add_point(0, f, p.of_f, g, p.of_g, p.point);
    }

    void meet_coplanar(std::uint32_t f, std::uint32_t g) {
        const bool opposite = operands_->plane(0, f) != operands_->plane(1, g);
        if (meet_equal(f, g, opposite)) return;
        for (const std::uint32_t i : {0U, 1U}) {
            const std::uint32_t own = i == 0 ? f : g;
            const std::uint32_t other = i == 0 ? g : f;
            FaceOutline outline;
            outline.read(*operands_, i, own);
            for (std::uint32_t n = 0; n < outline.entries.size(); ++n) {
                contact_.find_coplanar(i, own, 1 - i, other, n);
                for (const ContactSegment& s : contact_.segments()) {
                    // What both faces have as an edge is found twice.
                    if (i == 1 && s.of_g.kind == Feature::Kind::edge) continue;
                    CommonSegment c{{f, g}, {no_id, no_id}, s.from, s.to, {1, 1}, i, opposite};
                    c.corner[i] = s.of_f.corner;
                    c.corner[1 - i] = s.of_g.corner;
                    c.sides[1 - i] = s.g_sides;
                    common_.push_back(c);
                }
                for (const ContactPoint& p : contact_.points()) add_point(i, own, p.of_f, other, p.of_g, p.point);
            }
        }
    }

    /// Triangles with the same corners have their edges in common. Returns: whether they are such.
    bool meet_equal(std::uint32_t f, std::uint32_t g, bool opposite) {
        const FaceOutline& a = contact_.f();
        const FaceOutline& b = contact_.g();
        if (!a.is_triangle() || !b.is_triangle()) return false;
        std::array<PointId, 3> p{};
        std::array<PointId, 3> q{};
        for (std::size_t n = 0; n < 3; ++n) {
            p[n] = operands_->point(0, a.entries[n].point);
            q[n] = operands_->point(1, b.entries[n].point);
        }
        std::size_t shift = 0;
        while (shift < 3 && q[shift] != p[0]) ++shift;
        if (shift == 3) return false;
        const auto match = [&](std::size_t n) { return opposite ? (shift + 3 - n) % 3 : (shift + n) % 3; };
        if (q[match(1)] != p[1] || q[match(2)] != p[2]) return false;
        for (std::size_t n = 0; n < 3; ++n) {
            const std::size_t next = (n + 1) % 3;
            const std::uint32_t edge = b.entries[opposite ? match(next) : match(n)].corner;
            common_.push_back({{f, g}, {a.entries[n].corner, edge}, p[n], p[next], {1, 1}, 0, opposite});
            add_point(0, f, {Feature::Kind::vertex, a.entries[n].corner}, g,
                      {Feature::Kind::vertex, b.entries[match(n)].corner}, p[n]);
        }
        return true;
    }

    /// The segments as the faces of either operand see them.
    void list_segments() {
        for (const CommonSegment& s : common_) {
            if (s.edge_of == no_id) {
                segments_[0].push_back({s.face[0], s.corner[0], s.from, s.to, s.face[1], s.sides[1], 0, false});
                segments_[1].push_back({s.face[1], s.corner[1], s.to, s.from, s.face[0], s.sides[0], 0, false});
                continue;
            }
            const std::uint32_t i = s.edge_of;
            const std::uint32_t j = 1 - i;
            // The face whose edge it is lies on the edge's left, seen from its own outside.
            const std::uint8_t left = s.opposite ? 2 : 1;
            segments_[i].push_back({s.face[i], s.corner[i], s.from, s.to, s.face[j], 0, s.sides[j], s.opposite});
            segments_[j].push_back({s.face[j], s.corner[j], s.from, s.to, s.face[i], 0, left, s.opposite});
        }
        for (const std::uint32_t i : {0U, 1U}) sort_by_face(i, segments_[i]);
    }

    void add_point(std::uint32_t i, std::uint32_t own, Feature of_own, std::uint32_t other, Feature of_other,
                   PointId point) {
        points_[i].push_back({own, of_own, of_other, point, other});
        points_[1 - i].push_back({other, of_other, of_own, point, own});
    }

    SurfaceOperands* operands_;
    ProgressReporter* progress_;
    FaceContact contact_;
    std::array<std::vector<std::uint32_t>, 2> near_;
    std::array<std::vector<NamedBox<3>>, 2> boxes_;
    std::vector<std::array<std::uint32_t, 2>> pairs_;
    std::vector<CommonSegment> common_;
    std::array<std::vector<SegmentRecord>, 2> segments_;
    std::array<std::vector<PointContact>, 2> points_;
    std::size_t pair_count_ = 0;
};

CLEAVE_END_NAMESPACE

#endif
