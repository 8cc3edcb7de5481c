// SPDX-License-Identifier: Apache-2.0
/// Where the segments of several bounded boundaries in the plane meet: crossings, touching ends, common stretches.
///
/// A contact is a point that segments of two operands have in common, told once to either segment. Points are
/// representatives: whatever segments name a place, its name is one id. Two segments on one line have the two ends of
/// their common stretch as contacts, so coincidence needs no record of its own.
#ifndef CLEAVE_SETOP_PLANAR_CONTACTS_HPP
#define CLEAVE_SETOP_PLANAR_CONTACTS_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/geometry/segment_pairs.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A segment of an operand, the operand on its left, which is the minus side of its line.
struct PlanarSegment {
    PlaneId line;
    PointId from, to;
    std::uint32_t operand;
};

/// A point of a segment that a segment of another operand contains as well.
struct PlanarContact {
    std::uint32_t segment;
    std::uint32_t other;
    PointId point;
    bool starts;  ///< whether the other segment starts there
    bool ends;    ///< whether the other segment ends there
};

/// Loads operands into a kernel and finds their contacts. Segments are numbered through all operands; segment
/// `first_segment(i) + l` is loop l of operand i.
class PlanarContacts {
public:
    using Bits = BooleanFunction::Bits;

    /// Requires: at most 64 finite boundaries.
    /// Progress: a stage of three units a segment is begun, and two of them are spent.
    PlanarContacts(std::span<const Boundary<2>* const> operands, ProgressReporter* progress)
        : points_(kernel_), boundaries_(operands.begin(), operands.end()) {
        load_operands();
        if (progress != nullptr) progress->begin("segments", 3 * segments_.size());
        find_pairs(progress);
        meet_pairs(progress);
    }

    [[nodiscard]] Kernel<2>& kernel() noexcept { return kernel_; }
    [[nodiscard]] PointInterner<2>& interner() noexcept { return points_; }

    [[nodiscard]] std::uint32_t operand_count() const noexcept {
        return static_cast<std::uint32_t>(boundaries_.size());
    }
    [[nodiscard]] const Boundary<2>& boundary(std::uint32_t i) const { return *boundaries_[i]; }
    [[nodiscard]] const LoadedBoundary<2>& loaded(std::uint32_t i) const { return loaded_[i]; }

    [[nodiscard]] const std::vector<PlanarSegment>& segments() const noexcept { return segments_; }
    [[nodiscard]] std::uint32_t first_segment(std::uint32_t i) const { return first_segment_[i]; }
    /// A box around a segment, within the range of doubles.
    [[nodiscard]] const Bounds<2>& box(std::uint32_t segment) const { return boxes_[segment]; }

    /// Points below this number are the operands' own.
    [[nodiscard]] PointId own_point_count() const noexcept { return static_cast<PointId>(place_.size()); }
    /// The representative of a point: itself for a point of an operand that no other operand touches.
    [[nodiscard]] PointId place(PointId p) { return p < place_.size() ? place_[p] : points_(p); }

    /// All contacts, by segment and other segment.
    [[nodiscard]] const std::vector<PlanarContact>& contacts() const noexcept { return contacts_; }

    /// The operands whose boxes do not meet operand i's.
    [[nodiscard]] Bits apart(std::uint32_t i) const { return apart_[i]; }
    /// Pairs of segments that were compared, whose boxes meet.
    [[nodiscard]] std::size_t pair_count() const noexcept { return pair_count_; }

    /// Corner 0 (start) or 1 (end) of a segment as the operand has it: the point, and a line through it with the
    /// segment on its minus side.
    [[nodiscard]] Corner corner(std::uint32_t segment, std::size_t n) const {
        const std::uint32_t i = segments_[segment].operand;
        return loaded_[i].corner(boundaries_[i]->faces.loop(segment - first_segment_[i])[n]);
    }

private:
    void load_operands() {
        CLEAVE_REQUIRES(boundaries_.size() <= BooleanFunction::max_arity);
        std::size_t points = 0;
        std::size_t planes = 0;
        std::size_t segments = 0;
        for (const Boundary<2>* b : boundaries_) {
            CLEAVE_REQUIRES(b->is_finite);
            points += b->points.size();
            planes += b->planes.size();
            segments += b->faces.loop_first.size() - 1;
        }
        kernel_.reserve_points(points);
        kernel_.planes.reserve(planes);
        loaded_.reserve(boundaries_.size());
        segments_.reserve(segments);
        boxes_.reserve(segments);
        for (std::uint32_t i = 0; i < boundaries_.size(); ++i) {
            const Boundary<2>& b = *boundaries_[i];
            loaded_.push_back(load(b, kernel_));
            first_segment_.push_back(static_cast<std::uint32_t>(segments_.size()));
            for (const FaceList::Face& face : b.faces.faces) {
                const PlaneId line = loaded_[i].plane(face.plane);
                for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                    const std::span<const Corner> loop = b.faces.loop(l);
                    const PointId first = loaded_[i].first_point;
                    segments_.push_back({line, first + loop[0].point, first + loop[1].point, i});
                    boxes_.push_back(box_between(b.points[loop[0].point], b.points[loop[1].point]));
                }
            }
        }
        place_.resize(kernel_.point_count());
        std::iota(place_.begin(), place_.end(), 0U);
        apart_.assign(boundaries_.size(), 0);
    }

    /// The box of a segment. Where it leaves the range of doubles it stops there: boxes that meet still do, and no
    /// centre of a box is undefined.
    static Bounds<2> box_between(const PointRecord<2>& a, const PointRecord<2>& b) {
        constexpr double largest = std::numeric_limits<double>::max();
        Bounds<2> box;
        box.include(a.approximation, a.error);
        box.include(b.approximation, b.error);
        for (std::size_t x = 0; x < 2; ++x) {
            box.lo[x] = std::clamp(box.lo[x], -largest, largest);
            box.hi[x] = std::clamp(box.hi[x], -largest, largest);
        }
        return box;
    }

    [[nodiscard]] std::uint32_t segment_count(std::uint32_t i) const {
        return static_cast<std::uint32_t>(boundaries_[i]->faces.loop_first.size() - 1);
    }

    void find_pairs(ProgressReporter* progress) {
        for (std::uint32_t i = 0; i < boundaries_.size(); ++i) {
            for (std::uint32_t j = i + 1; j < boundaries_.size(); ++j) {
                if (boundaries_[i]->bounds.disjoint(boundaries_[j]->bounds)) {
                    apart_[i] |= Bits(1) << j;
                    apart_[j] |= Bits(1) << i;
                } else {
                    find_pairs(i, j);
                }
            }
            if (progress != nullptr) progress->advance(segment_count(i));
        }
        // Names of points are those of the pair that came first: no order of boxes may decide that.
        std::sort(pairs_.begin(), pairs_.end());
        pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    }

    void find_pairs(std::uint32_t i, std::uint32_t j) {
        constexpr std::uint32_t few = 8;
        const std::uint32_t a = first_segment_[i];
        const std::uint32_t b = first_segment_[j];
        const std::uint32_t a_count = segment_count(i);
        const std::uint32_t b_count = segment_count(j);
        if (a_count <= few && b_count <= few) {
            for (std::uint32_t s = a; s < a + a_count; ++s)
                for (std::uint32_t t = b; t < b + b_count; ++t)
                    if (!boxes_[s].disjoint(boxes_[t])) compare(s, t);
            return;
        }
        std::vector<NamedSegment> first = select(i, boundaries_[j]->bounds);
        if (first.empty()) return;
        for_each_near_pair(std::move(first), select(j, boundaries_[i]->bounds),
                           [&](std::uint32_t s, std::uint32_t t) { compare(s, t); });
    }

    /// The segments of operand i that reach a box.
    [[nodiscard]] std::vector<NamedSegment> select(std::uint32_t i, const Bounds<2>& box) const {
        std::vector<NamedSegment> out;
        const std::uint32_t end = first_segment_[i] + segment_count(i);
        for (std::uint32_t s = first_segment_[i]; s < end; ++s) {
            if (boxes_[s].disjoint(box)) continue;
            const PointRecord<2>& from = kernel_.point(segments_[s].from);
            const PointRecord<2>& to = kernel_.point(segments_[s].to);
            out.push_back({from.approximation, to.approximation, std::max(from.error, to.error), 0, 1, s});
        }
        return out;
    }

    /// Notes the pair unless one segment is on one side of the other's line.
    void compare(std::uint32_t a, std::uint32_t b) {
        ++pair_count_;
        const PlanarSegment& s = segments_[a];
        const PlanarSegment& t = segments_[b];
        if (unoriented(s.line) == unoriented(t.line) || (kernel_.side(t.line, s.from) != kernel_.side(t.line, s.to) &&
                                                         kernel_.side(s.line, t.from) != kernel_.side(s.line, t.to)))
            pairs_.emplace_back(a, b);
    }

    void meet_pairs(ProgressReporter* progress) {
        std::uint32_t done = 0;
        for (const auto& [a, b] : pairs_) {
            meet(a, b);
            if (progress != nullptr && a > done) progress->advance(a - done);
            done = a;
        }
        if (progress != nullptr) progress->advance(segments_.size() - done);
        std::sort(contacts_.begin(), contacts_.end(), [](const PlanarContact& a, const PlanarContact& b) {
            return std::pair(a.segment, a.other) < std::pair(b.segment, b.other);
        });
        pairs_ = {};
    }

    /// Two segments that `compare` let pass.
    void meet(std::uint32_t a, std::uint32_t b) {
        const PlanarSegment s = segments_[a];
        const PlanarSegment t = segments_[b];
        if (unoriented(s.line) == unoriented(t.line)) return overlap(a, b);
        const Sign s_from = kernel_.side(t.line, s.from);
        const Sign s_to = kernel_.side(t.line, s.to);
        const Sign t_from = kernel_.side(s.line, t.from);
        const Sign t_to = kernel_.side(s.line, t.to);
        // Either line separates the ends of the other segment, or has one of them: the lines meet in both segments.
        PointId x = no_id;
        const auto end = [&](Sign side, PointId p) {
            if (side == Sign::zero) x = touch(p);
        };
        end(s_from, s.from);
        end(s_to, s.to);
        end(t_from, t.from);
        end(t_to, t.to);
        if (x == no_id) x = points_(kernel_.cross(t.line, s.from, s.to, {unoriented(s.line)}));
        add(a, b, x);
    }

    /// Two segments on one line.
    void overlap(std::uint32_t a, std::uint32_t b) {
        const PlanarSegment s = segments_[a];
        const PlanarSegment t = segments_[b];
        const AxisDirection d = edge_direction(kernel_, s.line, no_id);
        const auto order = [&](PointId p, PointId q) { return kernel_.compare(d.axis, p, q) * d.sign; };
        const PointId first = s.line == t.line ? t.from : t.to;
        const PointId last = s.line == t.line ? t.to : t.from;
        if (order(last, s.from) == Sign::minus || order(s.to, first) == Sign::minus) return;
        const Sign low = order(s.from, first);
        const Sign high = order(s.to, last);
        PointId lower = no_id;
        PointId upper = no_id;
        if (low != Sign::minus) lower = touch(s.from);
        if (low != Sign::plus) lower = touch(first);
        if (high != Sign::plus) upper = touch(s.to);
        if (high != Sign::minus) upper = touch(last);
        add(a, b, lower);
        if (upper != lower) add(a, b, upper);
    }

    /// Notes that an operand's point is on another operand. Returns: its representative.
    PointId touch(PointId p) { return place_[p] = points_(p); }

    void add(std::uint32_t a, std::uint32_t b, PointId x) {
        add_to(a, b, x);
        add_to(b, a, x);
    }

    void add_to(std::uint32_t a, std::uint32_t b, PointId x) {
        const PlanarSegment& t = segments_[b];
        contacts_.push_back({a, b, x, place_[t.from] == x, place_[t.to] == x});
    }

    Kernel<2> kernel_;
    PointInterner<2> points_;
    std::vector<const Boundary<2>*> boundaries_;
    std::vector<LoadedBoundary<2>> loaded_;
    std::vector<std::uint32_t> first_segment_;
    std::vector<PlanarSegment> segments_;
    std::vector<Bounds<2>> boxes_;
    std::vector<PointId> place_;
    std::vector<Bits> apart_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
    std::vector<PlanarContact> contacts_;
    std::size_t pair_count_ = 0;
};

CLEAVE_END_NAMESPACE

#endif
