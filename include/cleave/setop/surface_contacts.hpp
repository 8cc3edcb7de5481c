// SPDX-License-Identifier: Apache-2.0
/// All contacts of the operands' faces, listed by face.
#ifndef CLEAVE_SETOP_SURFACE_CONTACTS_HPP
#define CLEAVE_SETOP_SURFACE_CONTACTS_HPP

#include <cleave/execution/progress.hpp>
#include <cleave/setop/face_pairs.hpp>
#include <cleave/setop/segment_noding.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Finds where operands meet. Requires: operands of `SurfaceOperands`, at most 64.
class SurfaceContacts {
public:
    using Bits = FacePairs::Bits;

    /// Tells `progress` of twice `share` units of work.
    SurfaceContacts(SurfaceOperands& operands, ExecutorRef executor, ProgressReporter* progress, std::size_t share)
        : operands_(&operands),
          progress_(progress),
          contact_(operands),
          faces_(operands, contact_, executor, progress),
          segments_(operands.count()),
          points_(operands.count()) {
        connect();
        // Finding pairs was a share of the work, what they have in common is another.
        std::size_t told = 0;
        advance(share);
        const std::span<const FacePair> pairs = faces_.pairs();
        for (std::size_t n = 0; n < pairs.size(); ++n) {
            meet(pairs[n]);
            const std::size_t reached = share * (n + 1) / pairs.size();
            advance(reached - told);
            told = reached;
        }
        advance(share - told);
        sort_points();
        while (SegmentNoding(operands, common_, points_).run()) sort_points();
        list_segments();
    }

    /// The operands whose bounds meet those of operand i.
    [[nodiscard]] Bits neighbours(std::uint32_t i) const { return faces_.neighbours(i); }
    /// Faces of operand i whose boxes meet another operand's box, ascending.
    [[nodiscard]] std::span<const std::uint32_t> near(std::uint32_t i) const { return faces_.near(i); }
    /// Records ascend by face.
    [[nodiscard]] std::span<const PointContact> points(std::uint32_t i) const { return points_[i]; }
    [[nodiscard]] RecordWalk walk(std::uint32_t i) const { return RecordWalk(segments_[i], points_[i]); }
    [[nodiscard]] std::size_t pair_count() const noexcept { return faces_.box_pair_count(); }

private:
    /// A stable sort by face: by counting where there are many records, by comparing where there are few.
    template <class Record>
    void sort_by_face(std::uint32_t i, std::vector<Record>& records) {
        const auto is_before = [](const Record& a, const Record& b) { return a.face < b.face; };
        const std::size_t faces = operands_->boundary(i).faces.faces.size();
        if (std::is_sorted(records.begin(), records.end(), is_before)) return;
        if (records.size() < faces / 8) {
            std::stable_sort(records.begin(), records.end(), is_before);
            return;
        }
        std::vector<std::uint32_t> next(faces + 1, 0);
        for (const Record& r : records) ++next[r.face + 1];
        for (std::size_t f = 0; f < faces; ++f) next[f + 1] += next[f];
        std::vector<Record> sorted(records.size());
        for (const Record& r : records) sorted[next[r.face]++] = r;
        records.swap(sorted);
    }

    void sort_points() {
        for (std::uint32_t i = 0; i < operands_->count(); ++i) sort_by_face(i, points_[i]);
    }

    void advance(std::size_t units) {
        if (progress_ != nullptr && units != 0) progress_->advance(units);
    }

    /// Makes neighbours known among the faces that may be cut.
    void connect() {
        std::vector<std::vector<bool>> paired(operands_->count());
        for (const FacePair& p : faces_.pairs())
            for (const auto& [i, f] : {std::pair(p.i, p.f), std::pair(p.j, p.g)}) {
                if (paired[i].empty()) paired[i].resize(operands_->boundary(i).faces.faces.size());
                paired[i][f] = true;
            }
        std::vector<std::uint32_t> faces;
        for (std::uint32_t i = 0; i < operands_->count(); ++i) {
            if (progress_ != nullptr) progress_->throw_if_stopped();
            faces.clear();
            if (!paired[i].empty())
                for (const std::uint32_t f : faces_.near(i))
                    if (paired[i][f]) faces.push_back(f);
            operands_->connect(i, faces);
        }
    }

    void meet(const FacePair& p) {
        if (contact_.find(p.i, p.f, p.j, p.g, p.signs)) {
            meet_coplanar(p);
            return;
        }
        for (const ContactSegment& s : contact_.segments())
            common_.push_back({{p.i, p.j},
                               {p.f, p.g},
                               {s.of_f.corner, s.of_g.corner},
                               s.from,
                               s.to,
                               {s.f_sides, s.g_sides},
                               no_id,
                               false});
        for (const ContactPoint& c : contact_.points()) add_point(p.i, p.f, c.of_f, p.j, p.g, c.of_g, c.point);
    }

    void meet_coplanar(const FacePair& p) {
        const bool opposite = operands_->plane(p.i, p.f) != operands_->plane(p.j, p.g);
        if (meet_equal(p, opposite)) return;
        const std::array<std::uint32_t, 2> operand{p.i, p.j};
        const std::array<std::uint32_t, 2> face{p.f, p.g};
        for (const std::uint32_t own : {0U, 1U}) {
            const std::uint32_t other = 1 - own;
            FaceOutline outline;
            outline.read(*operands_, operand[own], face[own]);
            for (std::uint32_t n = 0; n < outline.entries.size(); ++n) {
                contact_.find_coplanar(operand[own], face[own], operand[other], face[other], n);
                for (const ContactSegment& s : contact_.segments()) {
                    // What both faces have as an edge is found twice.
                    if (own == 1 && s.of_g.kind == Feature::Kind::edge) continue;
                    CommonSegment c{operand, face, {no_id, no_id}, s.from, s.to, {1, 1}, own, opposite};
                    c.corner[own] = s.of_f.corner;
                    c.corner[other] = s.of_g.corner;
                    c.sides[other] = s.g_sides;
                    common_.push_back(c);
                }
                for (const ContactPoint& c : contact_.points())
                    add_point(operand[own], face[own], c.of_f, operand[other], face[other], c.of_g, c.point);
            }
        }
    }

    /// Triangles with the same corners have their edges in common. Returns: whether they are such.
    bool meet_equal(const FacePair& pair, bool opposite) {
        const FaceOutline& a = contact_.f();
        const FaceOutline& b = contact_.g();
        if (!a.is_triangle() || !b.is_triangle()) return false;
        std::array<PointId, 3> p{};
        std::array<PointId, 3> q{};
        for (std::size_t n = 0; n < 3; ++n) {
            p[n] = operands_->point(pair.i, a.entries[n].point);
            q[n] = operands_->point(pair.j, b.entries[n].point);
        }
        std::size_t shift = 0;
        while (shift < 3 && q[shift] != p[0]) ++shift;
        if (shift == 3) return false;
        const auto match = [&](std::size_t n) { return opposite ? (shift + 3 - n) % 3 : (shift + n) % 3; };
        if (q[match(1)] != p[1] || q[match(2)] != p[2]) return false;
        for (std::size_t n = 0; n < 3; ++n) {
            const std::size_t next = (n + 1) % 3;
            const std::uint32_t edge = b.entries[opposite ? match(next) : match(n)].corner;
            common_.push_back(
                {{pair.i, pair.j}, {pair.f, pair.g}, {a.entries[n].corner, edge}, p[n], p[next], {1, 1}, 0, opposite});
            add_point(pair.i, pair.f, {Feature::Kind::vertex, a.entries[n].corner}, pair.j, pair.g,
                      {Feature::Kind::vertex, b.entries[match(n)].corner}, p[n]);
        }
        return true;
    }

    /// The segments as their faces see them.
    void list_segments() {
        for (const CommonSegment& s : common_) {
            const auto add = [&](std::size_t own, PointId from, PointId to, std::uint8_t up_down,
                                 std::uint8_t left_right) {
                segments_[s.operand[own]].push_back({s.face[own], s.corner[own], from, to, s.operand[1 - own],
                                                     s.face[1 - own], up_down, left_right, s.opposite});
            };
            if (s.edge_of == no_id) {
                add(0, s.from, s.to, s.sides[1], 0);
                add(1, s.to, s.from, s.sides[0], 0);
                continue;
            }
            // The face whose edge it is lies on the edge's left, seen from its own outside.
            add(s.edge_of, s.from, s.to, 0, s.sides[1 - s.edge_of]);
            add(1 - s.edge_of, s.from, s.to, 0, s.opposite ? 2 : 1);
        }
        for (std::uint32_t i = 0; i < operands_->count(); ++i) sort_by_face(i, segments_[i]);
    }

    void add_point(std::uint32_t i, std::uint32_t own, Feature of_own, std::uint32_t j, std::uint32_t other,
                   Feature of_other, PointId point) {
        points_[i].push_back({own, of_own, of_other, point, j, other});
        points_[j].push_back({other, of_other, of_own, point, i, own});
    }

    SurfaceOperands* operands_;
    ProgressReporter* progress_;
    FaceContact contact_;
    FacePairs faces_;
    std::vector<CommonSegment> common_;
    std::vector<std::vector<SegmentRecord>> segments_;
    std::vector<std::vector<PointContact>> points_;
};

CLEAVE_END_NAMESPACE

#endif
