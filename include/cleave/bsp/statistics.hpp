// SPDX-License-Identifier: Apache-2.0
/// Counts and depths of a tree, by which pivots are compared.
#ifndef CLEAVE_BSP_STATISTICS_HPP
#define CLEAVE_BSP_STATISTICS_HPP

#include <cleave/bsp/tree.hpp>
#include <cleave/bsp/visit.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

CLEAVE_BEGIN_NAMESPACE

/// The size and shape of a tree. The depth of a branch is the number of cuts above it; a single leaf has depth 0.
struct TreeStatistics {
    std::size_t nodes = 0;
    std::size_t leaves = 0;
    std::size_t depth = 0;          ///< of the deepest leaf
    std::uint64_t leaf_depths = 0;  ///< sum of the depths of all leaves

    /// The mean depth of the leaves: what locating a point costs if all leaves are equally likely.
    [[nodiscard]] double average_depth() const noexcept {
        return leaves == 0 ? 0.0 : static_cast<double>(leaf_depths) / static_cast<double>(leaves);
    }

    friend bool operator==(const TreeStatistics&, const TreeStatistics&) = default;
};

/// Counts what the tree's root reaches.
/// Cost: O(nodes).
template <class Plane, class Label>
[[nodiscard]] TreeStatistics statistics(const PlaneTree<Plane, Label>& tree) {
    TreeStatistics s;
    visit_preorder(tree, [&](Branch b, std::span<const Step> path) {
        if (b.is_node()) {
            ++s.nodes;
            return;
        }
        ++s.leaves;
        s.depth = std::max(s.depth, path.size());
        s.leaf_depths += path.size();
    });
    return s;
}

CLEAVE_END_NAMESPACE

#endif
