// SPDX-License-Identifier: Apache-2.0
/// A static hierarchy of boxes in any dimension: which boxes meet a box, and which pairs of two sets of boxes meet.
///
/// A binary tree by median splits along the longest axis of the centres, as is usual since [Goldsmith-Salmon-1987]; the
/// tree is balanced by construction, so its depth is at most log2 of the number of boxes. Everything is iterative, and
/// the answers come in an order that depends on the boxes alone.
#ifndef CLEAVE_GEOMETRY_BOX_HIERARCHY_HPP
#define CLEAVE_GEOMETRY_BOX_HIERARCHY_HPP

#include <cleave/base/contract.hpp>
#include <cleave/geometry/box.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A balanced tree over boxes of doubles that are named by their index. Boxes are closed: touching is meeting. Empty
/// boxes meet nothing and are left out. Const objects may be queried from several threads at once.
template <int D>
class BoxHierarchy {
public:
    using box_type = Box<D>;

    BoxHierarchy() = default;

    /// Requires: fewer than 2^31 boxes, no NaN. Cost: O(n log n) comparisons, 2n nodes at most.
    explicit BoxHierarchy(std::span<const box_type> boxes) {
        CLEAVE_REQUIRES(boxes.size() < (std::size_t(1) << 31U));
        std::vector<std::uint32_t> order;
        order.reserve(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (!boxes[i].is_empty()) order.push_back(static_cast<std::uint32_t>(i));
        }
        build(boxes, order);
    }

    /// Number of non-empty boxes.
    [[nodiscard]] std::size_t size() const noexcept { return items_.size(); }

    /// The box of all boxes.
    [[nodiscard]] box_type bounds() const { return nodes_.empty() ? box_type() : nodes_.front().box; }

    /// Calls `visit(i)` for every box i that meets `query`, each once.
    /// Cost: O(log n + answers) for well-shaped input, O(n) at worst.
    template <class Visit>
    void for_each_meeting(const box_type& query, Visit&& visit) const {
        visit_if([&](const box_type& b) { return !disjoint(query, b); }, std::forward<Visit>(visit));
    }

    /// The general descent: calls `visit(i)` for every box i with `reaches(box)`, each once.
    /// Requires: `reaches` is monotone, true for a box whenever it is true for a box inside it (a ray meets it, say).
    template <class Reaches, class Visit>
    void visit_if(Reaches&& reaches, Visit&& visit) const {
        if (nodes_.empty()) return;
        std::vector<std::uint32_t> stack{0};
        while (!stack.empty()) {
            const Node& node = nodes_[stack.back()];
            stack.pop_back();
            if (!reaches(node.box)) continue;
            if (!node.is_leaf()) {
                stack.push_back(node.second);
                stack.push_back(node.first);
                continue;
            }
            for (const Item& item : items_of(node)) {
                if (reaches(item.box)) visit(static_cast<std::size_t>(item.index));
            }
        }
    }

    /// Calls `visit(i, j)` for every pair of a box i of `a` and a box j of `b` that meet, each pair once.
    /// Cost: O(n log n + answers) for well-shaped input. Both trees are descended together, the fuller node first, so
    /// that long thin boxes do not spoil their neighbours.
    template <class Visit>
    static void for_each_meeting_pair(const BoxHierarchy& a, const BoxHierarchy& b, Visit&& visit) {
        if (a.nodes_.empty() || b.nodes_.empty()) return;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
        while (!stack.empty()) {
            const Node& left = a.nodes_[stack.back().first];
            const Node& right = b.nodes_[stack.back().second];
            const std::pair<std::uint32_t, std::uint32_t> at = stack.back();
            stack.pop_back();
            if (disjoint(left.box, right.box)) continue;
            if (left.is_leaf() && right.is_leaf()) {
                for (const Item& i : a.items_of(left)) {
                    for (const Item& j : b.items_of(right)) {
                        if (!disjoint(i.box, j.box)) visit(std::size_t(i.index), std::size_t(j.index));
                    }
                }
            } else if (right.is_leaf() || (!left.is_leaf() && right.count <= left.count)) {
                stack.emplace_back(left.second, at.second);
                stack.emplace_back(left.first, at.second);
            } else {
                stack.emplace_back(at.first, right.second);
                stack.emplace_back(at.first, right.first);
            }
        }
    }

    /// Number of edges on the longest path from the root to a leaf.
    [[nodiscard]] std::size_t depth() const {
        std::size_t deepest = 0;
        std::vector<std::pair<std::uint32_t, std::size_t>> stack;
        if (!nodes_.empty()) stack.emplace_back(0, 0);
        while (!stack.empty()) {
            const std::pair<std::uint32_t, std::size_t> at = stack.back();
            stack.pop_back();
            deepest = std::max(deepest, at.second);
            const Node& node = nodes_[at.first];
            if (node.is_leaf()) continue;
            stack.emplace_back(node.first, at.second + 1);
            stack.emplace_back(node.second, at.second + 1);
        }
        return deepest;
    }

private:
    static constexpr std::uint32_t leaf_size = 4;
    static constexpr std::uint32_t no_child = std::numeric_limits<std::uint32_t>::max();

    struct Item {
        box_type box;
        std::uint32_t index = 0;
    };

    /// Inner node: `first`, `second` are its children. Leaf: `second` is `no_child`, `first` the first of its items.
    struct Node {
        box_type box;
        std::uint32_t first = 0;
        std::uint32_t second = no_child;
        std::uint32_t count = 0;

        [[nodiscard]] bool is_leaf() const noexcept { return second == no_child; }
    };

    [[nodiscard]] std::span<const Item> items_of(const Node& leaf) const {
        return std::span<const Item>(items_).subspan(leaf.first, leaf.count);
    }

    /// Half the sum of the bounds, kept finite so that unbounded boxes sort like any other.
    static double centre(const box_type& box, std::size_t axis) {
        constexpr double limit = std::numeric_limits<double>::max();
        return std::clamp(box.lo[axis], -limit, limit) / 2 + std::clamp(box.hi[axis], -limit, limit) / 2;
    }

    void build(std::span<const box_type> boxes, std::vector<std::uint32_t>& order) {
        if (order.empty()) return;
        nodes_.reserve(2 * order.size() / leaf_size + 1);
        nodes_.emplace_back();
        struct Task {
            std::uint32_t node, first, count;
        };
        std::vector<Task> stack{{0, 0, static_cast<std::uint32_t>(order.size())}};
        while (!stack.empty()) {
            const Task task = stack.back();
            stack.pop_back();
            const std::span<std::uint32_t> part = std::span<std::uint32_t>(order).subspan(task.first, task.count);
            box_type all;
            box_type centres;
            for (const std::uint32_t i : part) {
                all.extend(boxes[i]);
                box_type c;
                for (std::size_t axis = 0; axis < c.size; ++axis) c.lo[axis] = c.hi[axis] = centre(boxes[i], axis);
                centres.extend(c);
            }
            Node& node = nodes_[task.node];
            node.box = all;
            node.count = task.count;
            node.first = task.first;
            if (task.count <= leaf_size) continue;
            const std::size_t axis = longest_axis(centres);
            const std::uint32_t half = task.count / 2;
            // The index breaks ties, so that the tree is the same whatever nth_element does with equal keys.
            std::nth_element(part.begin(), part.begin() + half, part.end(), [&](std::uint32_t i, std::uint32_t j) {
                const double x = centre(boxes[i], axis);
                const double y = centre(boxes[j], axis);
                return x < y || (x == y && i < j);
            });
            const auto child = static_cast<std::uint32_t>(nodes_.size());
            node.first = child;
            node.second = child + 1;
            nodes_.resize(nodes_.size() + 2);  // `node` is invalid from here on
            stack.push_back({child + 1, task.first + half, task.count - half});
            stack.push_back({child, task.first, half});
        }
        items_.reserve(order.size());
        for (const std::uint32_t i : order) items_.push_back({boxes[i], i});
        sort_leaves();
    }

    /// nth_element leaves the order inside a leaf to the standard library; answers must not depend on that.
    void sort_leaves() {
        for (const Node& node : nodes_) {
            if (!node.is_leaf()) continue;
            std::sort(items_.begin() + node.first, items_.begin() + node.first + node.count,
                      [](const Item& a, const Item& b) { return a.index < b.index; });
        }
    }

    std::vector<Node> nodes_;
    std::vector<Item> items_;  // leaf by leaf, so that a leaf reads consecutive memory
};

CLEAVE_END_NAMESPACE

#endif
