// SPDX-License-Identifier: Apache-2.0
/// Which segments of one set in the plane may meet which of another. Boxes say little about long segments that run
/// side by side and not along an axis; a line between them says it all.
#ifndef CLEAVE_GEOMETRY_SEGMENT_PAIRS_HPP
#define CLEAVE_GEOMETRY_SEGMENT_PAIRS_HPP

#include <cleave/geometry/bounds.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A segment with its name; its ends are known up to an error. What matters is the part between two shares of the way.
struct NamedSegment {
    std::array<double, 2> from{}, to{};
    double error = 0;
    double begin = 0;
    double end = 1;
    std::uint32_t name = 0;
};

/// Parts of segments along a direction. All is computed in doubles, and every rounding is covered by slack: intervals
/// and parts are never too small.
class SegmentProjection {
public:
    struct Interval {
        double lo, hi;
    };

    /// Requires: no entry is larger than 1.
    explicit SegmentProjection(std::array<double, 2> normal) : normal_(normal) {}

    /// Where the segment's part is, as seen along the direction.
    [[nodiscard]] Interval interval(const NamedSegment& s) const {
        const Ends e = project(s, 0);
        const double a = e.from + s.begin * (e.to - e.from);
        const double b = e.from + s.end * (e.to - e.from);
        if (!(std::abs(a) + std::abs(b) + e.slack < limit)) return {-limit, limit};
        return {std::min(a, b) - e.slack, std::max(a, b) + e.slack};
    }

    /// Makes the part smaller; it still contains all points of it that are below (above) `at`.
    void clip(NamedSegment& s, double at, bool below) const {
        const Ends e = project(s, at);
        const double length = e.to - e.from;
        if (!(std::abs(e.from) + std::abs(e.to) + e.slack < limit) || !(std::abs(length) > 0)) return;
        const double way = (at + (below ? e.slack : -e.slack) - e.from) / length;
        if (below == (length > 0))
            s.end = std::min(s.end, way + std::abs(way) * 0x1p-48 + 0x1p-48);
        else
            s.begin = std::max(s.begin, way - std::abs(way) * 0x1p-48 - 0x1p-48);
    }

private:
    static constexpr double limit = std::numeric_limits<double>::max() / 16;

    struct Ends {
        double from, to, slack;
    };

    [[nodiscard]] Ends project(const NamedSegment& s, double at) const {
        double size = std::abs(at);
        for (std::size_t i = 0; i < 2; ++i) size += std::abs(normal_[i]) * (std::abs(s.from[i]) + std::abs(s.to[i]));
        return {normal_[0] * s.from[0] + normal_[1] * s.from[1], normal_[0] * s.to[0] + normal_[1] * s.to[1],
                4 * s.error + size * 0x1p-47 + 0x1p-1000};
    }

    std::array<double, 2> normal_;
};

namespace detail {

/// See `for_each_near_pair`.
class SegmentPairs {
public:
    using Segments = std::vector<NamedSegment>;

    template <class Visit>
    static void run(Segments first, Segments second, Visit&& visit) {
        SegmentPairs pairs;
        pairs.work_.push_back({std::move(first), std::move(second), 0});
        while (!pairs.work_.empty()) {
            Task task = std::move(pairs.work_.back());
            pairs.work_.pop_back();
            pairs.cull(task);
            if (task.a.empty() || task.b.empty()) continue;
            const bool is_small = task.a.size() <= few && task.b.size() <= few;
            if (is_small || task.depth == deepest || !pairs.split(task)) {
                for (std::size_t x = 0; x < task.a.size(); ++x)
                    for (std::size_t y = 0; y < task.b.size(); ++y)
                        if (!pairs.a_boxes_[x].disjoint(pairs.b_boxes_[y])) visit(task.a[x].name, task.b[y].name);
            }
        }
    }

private:
    static constexpr std::size_t few = 8;
    static constexpr int deepest = 64;

    struct Task {
        Segments a, b;
        int depth;
    };

    static Bounds<2> box_of(const NamedSegment& s) {
        Bounds<2> box;
        for (std::size_t i = 0; i < 2; ++i) {
            const SegmentProjection::Interval x =
                SegmentProjection({i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0}).interval(s);
            box.lo[i] = x.lo;
            box.hi[i] = x.hi;
        }
        return box;
    }

    /// Drops what does not reach the other set's box; the boxes of the rest are `a_boxes_` and `b_boxes_`.
    void cull(Task& task) {
        Bounds<2> a_box;
        a_boxes_.clear();
        for (const NamedSegment& s : task.a) {
            a_boxes_.push_back(box_of(s));
            a_box.include(a_boxes_.back());
        }
        Bounds<2> b_box;
        b_boxes_.clear();
        for (const NamedSegment& s : task.b) b_boxes_.push_back(box_of(s));
        keep_reaching(task.b, b_boxes_, a_box);
        for (const Bounds<2>& box : b_boxes_) b_box.include(box);
        keep_reaching(task.a, a_boxes_, b_box);
        box_ = task.a.size() >= task.b.size() ? a_box : b_box;
    }

    static void keep_reaching(Segments& segments, std::vector<Bounds<2>>& boxes, const Bounds<2>& other) {
        std::size_t kept = 0;
        for (std::size_t n = 0; n < segments.size(); ++n) {
            if (boxes[n].disjoint(other)) continue;
            segments[kept] = segments[n];
            boxes[kept++] = boxes[n];
        }
        segments.resize(kept);
        boxes.resize(kept);
    }

    /// Splits the task across an axis or, where that parts little, along one of its segments. Returns: whether any of
    /// them parts the sets.
    bool split(const Task& task) {
        const std::size_t longer = box_.extent(1) > box_.extent(0) ? 1 : 0;
        std::array<double, 2> axis{};
        axis[longer] = 1;
        if (split_across(task, axis, 0.6) || split_across(task, {axis[1], axis[0]}, 0.6)) return true;
        for (const NamedSegment& s : {task.a[task.a.size() / 2], task.b[task.b.size() / 2]}) {
            const std::array<double, 2> normal{s.from[1] - s.to[1], s.to[0] - s.from[0]};
            const double size = std::max(std::abs(normal[0]), std::abs(normal[1]));
            if (!(size > 0x1p-900 && size < 0x1p900)) continue;
            if (split_across(task, {normal[0] / size, normal[1] / size}, 0.6)) return true;
        }
        return split_across(task, axis, 0.9);
    }

    /// Splits at the median of the larger set if at most the given share of the pairs remain.
    bool split_across(const Task& task, const std::array<double, 2>& normal, double share) {
        const SegmentProjection projection(normal);
        const Segments& larger = task.a.size() >= task.b.size() ? task.a : task.b;
        centres_.clear();
        for (const NamedSegment& s : larger) {
            const SegmentProjection::Interval x = projection.interval(s);
            centres_.push_back(x.lo / 2 + x.hi / 2);
        }
        const auto half = centres_.begin() + std::ptrdiff_t(centres_.size() / 2);
        std::nth_element(centres_.begin(), half, centres_.end());
        const double at = *half;
        Task below{{}, {}, task.depth + 1};
        Task above{{}, {}, task.depth + 1};
        const double all = double(task.a.size()) * double(task.b.size());
        part(projection, at, task.a, below.a, above.a);
        part(projection, at, task.b, below.b, above.b);
        if (double(below.a.size()) * double(below.b.size()) + double(above.a.size()) * double(above.b.size()) >
            share * all)
            return false;
        work_.push_back(std::move(above));
        work_.push_back(std::move(below));
        return true;
    }

    static void part(const SegmentProjection& projection, double at, const Segments& segments, Segments& below,
                     Segments& above) {
        for (const NamedSegment& s : segments) {
            const SegmentProjection::Interval x = projection.interval(s);
            const bool is_below = x.lo <= at;
            const bool is_above = x.hi >= at;
            if (is_below) below.push_back(s);
            if (is_above) above.push_back(s);
            if (!is_below || !is_above) continue;
            projection.clip(below.back(), at, true);
            projection.clip(above.back(), at, false);
        }
    }

    std::vector<Task> work_;
    std::vector<Bounds<2>> a_boxes_, b_boxes_;
    std::vector<double> centres_;
    Bounds<2> box_;
};

}  // namespace detail

/// Calls `visit(a, b)` with the names of every pair of segments of `first` and `second` that have a common point, and
/// of some that have none; of some pairs more than once.
///
/// The plane is split at the median of the larger set, across an axis or along a segment, and either set loses what
/// does not reach the other. A segment on both sides goes to both, its part there. Where no split parts the sets, all
/// are compared. Cost: O((n + m) log(n + m) + answers) for well-shaped sets.
template <class Visit>
void for_each_near_pair(std::vector<NamedSegment> first, std::vector<NamedSegment> second, Visit&& visit) {
    detail::SegmentPairs::run(std::move(first), std::move(second), std::forward<Visit>(visit));
}

CLEAVE_END_NAMESPACE

#endif
