// SPDX-License-Identifier: Apache-2.0
/// Which boxes of one set meet which of another, or each other, without a hierarchy of either.
#ifndef CLEAVE_GEOMETRY_BOX_PAIRS_HPP
#define CLEAVE_GEOMETRY_BOX_PAIRS_HPP

#include <cleave/geometry/bounds.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A box with the name of what it bounds.
template <int D>
struct NamedBox {
    Bounds<D> box;
    std::uint32_t name = 0;
};

/// Named boxes and a box around them all.
template <int D>
struct BoxGroup {
    std::span<NamedBox<D>> boxes;
    Bounds<D> bounds;

    explicit BoxGroup(std::span<NamedBox<D>> all) : boxes(all) {
        for (const NamedBox<D>& b : all) bounds.include(b.box);
    }

    /// Keeps those that meet `other`; the rest stays behind them in memory. Returns: whether any does.
    bool keep_meeting(const Bounds<D>& other) {
        if (!other.contains(bounds)) {
            std::size_t kept = 0;
            bounds = {};
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                if (boxes[i].box.disjoint(other)) continue;
                if (kept != i) std::swap(boxes[kept], boxes[i]);
                bounds.include(boxes[kept++].box);
            }
            boxes = boxes.first(kept);
        }
        return !boxes.empty();
    }

    /// Two halves: at the middle of the longest side, or where nearly all boxes are on one side of that, at the median
    /// of the centres.
    [[nodiscard]] std::pair<BoxGroup, BoxGroup> split() const {
        std::size_t x = 0;
        for (int i = 1; i < D; ++i)
            if (bounds.extent(i) > bounds.extent(int(x))) x = std::size_t(i);
        const double middle = bounds.lo[x] / 2 + bounds.hi[x] / 2;
        std::pair<BoxGroup, BoxGroup> halves{BoxGroup({}), BoxGroup({})};
        std::size_t lower = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (centre(boxes[i], x) < middle) {
                halves.first.bounds.include(boxes[i].box);
                std::swap(boxes[lower++], boxes[i]);
            } else {
                halves.second.bounds.include(boxes[i].box);
            }
        }
        if (lower < boxes.size() / 8 || boxes.size() - lower < boxes.size() / 8 || lower == 0 ||
            lower == boxes.size()) {
            lower = boxes.size() / 2;
            std::nth_element(boxes.begin(), boxes.begin() + std::ptrdiff_t(lower), boxes.end(),
                             [x](const NamedBox<D>& p, const NamedBox<D>& q) {
                                 const double s = centre(p, x);
                                 const double t = centre(q, x);
                                 return s < t || (s == t && p.name < q.name);
                             });
            return {BoxGroup(boxes.first(lower)), BoxGroup(boxes.subspan(lower))};
        }
        halves.first.boxes = boxes.first(lower);
        halves.second.boxes = boxes.subspan(lower);
        return halves;
    }

private:
    /// Zero where the box has no end on either side, so that centres have an order.
    static double centre(const NamedBox<D>& b, std::size_t x) {
        const double c = b.box.lo[x] / 2 + b.box.hi[x] / 2;
        return c == c ? c : 0;
    }
};

/// Calls `visit(a, b)` with the names of every pair of a box of `first` and one of `second` that meet (closed boxes:
/// touching is meeting), each pair once, in an order that depends on the boxes alone. Reorders both sets.
///
/// Both sets are split together, the larger first, and before each split either set loses what does not reach the
/// other's box: where the sets hardly overlap, nearly everything goes in the first pass, and no tree is ever built for
/// it. `poll(n)` is called before n boxes are looked at; what it throws ends the search.
/// Cost: O((n + m) log(n + m) + answers) for well-shaped boxes.
template <int D, class Visit, class Poll>
void for_each_meeting_pair(std::span<NamedBox<D>> first, std::span<NamedBox<D>> second, Visit&& visit, Poll&& poll) {
    using Group = BoxGroup<D>;
    constexpr std::size_t few = 8;
    std::vector<std::pair<Group, Group>> work{{Group(first), Group(second)}};
    while (!work.empty()) {
        auto [a, b] = work.back();
        work.pop_back();
        if (a.boxes.size() <= few && b.boxes.size() <= few) {
            for (const NamedBox<D>& x : a.boxes)
                for (const NamedBox<D>& y : b.boxes)
                    if (!x.box.disjoint(y.box)) visit(x.name, y.name);
            continue;
        }
        poll(a.boxes.size() + b.boxes.size());
        if (!b.keep_meeting(a.bounds) || !a.keep_meeting(b.bounds)) continue;
        if (a.boxes.size() <= few && b.boxes.size() <= few) {
            work.push_back({a, b});
        } else if (a.boxes.size() >= b.boxes.size()) {
            const auto [lower, upper] = a.split();
            work.push_back({upper, b});
            work.push_back({lower, b});
        } else {
            const auto [lower, upper] = b.split();
            work.push_back({a, upper});
            work.push_back({a, lower});
        }
    }
}

/// The same without a poll.
template <int D, class Visit>
void for_each_meeting_pair(std::span<NamedBox<D>> first, std::span<NamedBox<D>> second, Visit&& visit) {
    for_each_meeting_pair<D>(first, second, visit, [](std::size_t) {});
}

/// The same within one set: calls `visit(a, b)` with the names of every two of `boxes` that meet, each pair once.
/// Reorders the set. Cost: O(n log n + answers) for well-shaped boxes.
template <int D, class Visit>
void for_each_meeting_pair(std::span<NamedBox<D>> boxes, Visit&& visit) {
    constexpr std::size_t few = 8;
    std::vector<BoxGroup<D>> work{BoxGroup<D>(boxes)};
    while (!work.empty()) {
        const BoxGroup<D> part = work.back();
        work.pop_back();
        if (part.boxes.size() <= few) {
            for (std::size_t i = 0; i < part.boxes.size(); ++i)
                for (std::size_t j = i + 1; j < part.boxes.size(); ++j)
                    if (!part.boxes[i].box.disjoint(part.boxes[j].box)) visit(part.boxes[i].name, part.boxes[j].name);
            continue;
        }
        const auto [lower, upper] = part.split();
        // Between the halves the other function discards at once what does not reach over the cut.
        for_each_meeting_pair<D>(lower.boxes, upper.boxes, visit);
        work.push_back(upper);
        work.push_back(lower);
    }
}

CLEAVE_END_NAMESPACE

#endif
