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

/// Calls `visit(a, b)` with the names of every pair of a box of `first` and one of `second` that meet (closed boxes:
/// touching is meeting), each pair once, in an order that depends on the boxes alone. Reorders both sets.
///
/// Both sets are split together, the larger at the median of its centres, and before each split either set loses what
/// does not reach the other's box: where the sets hardly overlap, nearly everything goes in the first pass, and no tree
/// is ever built for it. Cost: O((n + m) log(n + m) + answers) for well-shaped boxes.
template <int D, class Visit>
void for_each_meeting_pair(std::span<NamedBox<D>> first, std::span<NamedBox<D>> second, Visit&& visit) {
    using Boxes = std::span<NamedBox<D>>;
    constexpr std::size_t few = 8;
    const auto bounds_of = [](Boxes boxes) {
        Bounds<D> all;
        for (const NamedBox<D>& b : boxes) all.include(b.box);
        return all;
    };
    const auto reaching = [](Boxes boxes, const Bounds<D>& other) {
        const auto end =
            std::partition(boxes.begin(), boxes.end(), [&](const NamedBox<D>& b) { return !b.box.disjoint(other); });
        return boxes.first(std::size_t(end - boxes.begin()));
    };
    std::vector<std::pair<Boxes, Boxes>> work{{first, second}};
    while (!work.empty()) {
        auto [a, b] = work.back();
        work.pop_back();
        if (a.empty() || b.empty()) continue;
        Bounds<D> common;
        if (a.size() > few || b.size() > few) {
            const Bounds<D> a_box = bounds_of(a);
            b = reaching(b, a_box);
            const Bounds<D> b_box = bounds_of(b);
            a = reaching(a, b_box);
            if (a.empty() || b.empty()) continue;
            common = a.size() >= b.size() ? a_box : b_box;
        }
        if (a.size() <= few && b.size() <= few) {
            for (const NamedBox<D>& x : a)
                for (const NamedBox<D>& y : b)
                    if (!x.box.disjoint(y.box)) visit(x.name, y.name);
            continue;
        }
        const bool split_a = a.size() >= b.size();
        const Boxes larger = split_a ? a : b;
        int axis = 0;
        for (int i = 1; i < D; ++i)
            if (common.extent(i) > common.extent(axis)) axis = i;
        const auto x = std::size_t(axis);
        const std::size_t half = larger.size() / 2;
        std::nth_element(larger.begin(), larger.begin() + std::ptrdiff_t(half), larger.end(),
                         [x](const NamedBox<D>& p, const NamedBox<D>& q) {
                             const double s = p.box.lo[x] / 2 + p.box.hi[x] / 2;
                             const double t = q.box.lo[x] / 2 + q.box.hi[x] / 2;
                             return s < t || (s == t && p.name < q.name);
                         });
        if (split_a) {
            work.push_back({a.subspan(half), b});
            work.push_back({a.first(half), b});
        } else {
            work.push_back({a, b.subspan(half)});
            work.push_back({a, b.first(half)});
        }
    }
}

/// The same within one set: calls `visit(a, b)` with the names of every two of `boxes` that meet, each pair once.
/// Reorders the set. Cost: O(n log n + answers) for well-shaped boxes.
template <int D, class Visit>
void for_each_meeting_pair(std::span<NamedBox<D>> boxes, Visit&& visit) {
    constexpr std::size_t few = 8;
    std::vector<std::span<NamedBox<D>>> work{boxes};
    while (!work.empty()) {
        const std::span<NamedBox<D>> part = work.back();
        work.pop_back();
        if (part.size() <= few) {
            for (std::size_t i = 0; i < part.size(); ++i)
                for (std::size_t j = i + 1; j < part.size(); ++j)
                    if (!part[i].box.disjoint(part[j].box)) visit(part[i].name, part[j].name);
            continue;
        }
        Bounds<D> all;
        for (const NamedBox<D>& b : part) all.include(b.box);
        std::size_t x = 0;
        for (int i = 1; i < D; ++i)
            if (all.extent(i) > all.extent(int(x))) x = std::size_t(i);
        const std::size_t half = part.size() / 2;
        std::nth_element(part.begin(), part.begin() + std::ptrdiff_t(half), part.end(),
                         [x](const NamedBox<D>& p, const NamedBox<D>& q) {
                             const double s = p.box.lo[x] / 2 + p.box.hi[x] / 2;
                             const double t = q.box.lo[x] / 2 + q.box.hi[x] / 2;
                             return s < t || (s == t && p.name < q.name);
                         });
        // Between the halves the other function discards at once what does not reach over the cut.
        for_each_meeting_pair<D>(part.first(half), part.subspan(half), visit);
        work.push_back(part.subspan(half));
        work.push_back(part.first(half));
    }
}

CLEAVE_END_NAMESPACE

#endif
