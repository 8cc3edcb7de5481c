// SPDX-License-Identifier: Apache-2.0
/// Fewer cuts for the same set: a cut whose two sides are the same tree says nothing and is dropped.
///
/// Bottom-up, so that dropping a cut can make the one above it superfluous: two leaves with equal labels become one
/// leaf, and two equal subtrees become one subtree. The map from points to labels is unchanged off the dropped cuts,
/// and cells only grow, so a tree without empty cells stays one.
///
/// It is not a normal form: subtrees that describe the same labels by different cuts are not recognised.
#ifndef CLEAVE_BSP_COLLAPSE_HPP
#define CLEAVE_BSP_COLLAPSE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/bsp/tree.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// Rebuilds a tree children first. A finished subtree occupies the end of both arrays, so dropping it again is a
/// truncation and nothing is ever orphaned.
template <class Plane, class Label, class SameCut>
class TreeCollapser {
public:
    TreeCollapser(TreeParts<Plane, Label> from, SameCut& same_cut) : from_(std::move(from)), same_cut_(same_cut) {}

    TreeParts<Plane, Label> run() {
        struct Visit {
            Branch branch;
            bool children_done;
        };
        std::vector<Visit> open{{from_.root, false}};
        while (!open.empty()) {
            const Visit v = open.back();
            open.pop_back();
            if (v.branch.is_leaf()) {
                const Start at = here();
                done_.push_back(Subtree{to_.add_leaf(std::move(from_.leaves[v.branch.index()].label)), at});
            } else if (v.children_done) {
                join(from_.nodes[v.branch.index()].cut);
            } else {
                const TreeNode<Plane>& n = from_.nodes[v.branch.index()];
                open.push_back({v.branch, true});
                open.push_back({n.plus, false});
                open.push_back({n.minus, false});
            }
        }
        to_.root = done_.back().root;
        return std::move(to_);
    }

private:
    /// Where a subtree begins in the arrays of the result.
    struct Start {
        std::size_t node = 0;
        std::size_t leaf = 0;
    };
    struct Subtree {
        Branch root;
        Start start;
    };

    [[nodiscard]] Start here() const { return Start{to_.nodes.size(), to_.leaves.size()}; }

    /// Both children of a node with this cut are finished: makes the node, or drops the plus child if it is a copy.
    void join(Plane& cut) {
        const Subtree plus = done_.back();
        done_.pop_back();
        Subtree& minus = done_.back();
        if (equal(minus, plus)) {
            to_.nodes.erase(to_.nodes.begin() + static_cast<std::ptrdiff_t>(plus.start.node), to_.nodes.end());
            to_.leaves.erase(to_.leaves.begin() + static_cast<std::ptrdiff_t>(plus.start.leaf), to_.leaves.end());
            return;
        }
        const Branch node = to_.add_node(std::move(cut));
        to_.nodes.back().minus = minus.root;
        to_.nodes.back().plus = plus.root;
        minus.root = node;
    }

    /// Subtrees are numbered children first, minus first, so equal trees have equal arrays up to a shift. Different
    /// sizes are told apart at once; with equal ones the cost is that of the smaller, so all of `run` is O(n log n).
    [[nodiscard]] bool equal(const Subtree& minus, const Subtree& plus) const {
        const std::size_t nodes = plus.start.node - minus.start.node;
        const std::size_t leaves = plus.start.leaf - minus.start.leaf;
        if (to_.nodes.size() - plus.start.node != nodes || to_.leaves.size() - plus.start.leaf != leaves) return false;
        const auto matches = [&](Branch a, Branch b) {
            return a.is_node() == b.is_node() && a.index() + (a.is_node() ? nodes : leaves) == b.index();
        };
        for (std::size_t i = 0; i < leaves; ++i) {
            const std::size_t k = minus.start.leaf + i;
            if (!(to_.leaves[k].label == to_.leaves[k + leaves].label)) return false;
        }
        for (std::size_t i = 0; i < nodes; ++i) {
            const TreeNode<Plane>& a = to_.nodes[minus.start.node + i];
            const TreeNode<Plane>& b = to_.nodes[plus.start.node + i];
            if (!matches(a.minus, b.minus) || !matches(a.plus, b.plus)) return false;
            if (!std::invoke(same_cut_, a.cut, b.cut)) return false;
        }
        return true;
    }

    TreeParts<Plane, Label> from_;
    SameCut& same_cut_;
    TreeParts<Plane, Label> to_;
    std::vector<Subtree> done_;
};

}  // namespace detail

/// The same map from space to labels with superfluous cuts dropped.
/// `same_cut(g, h)` says whether two planes are the same with the same orientation; it may say no at will. With a Clip
/// model: `[&](const auto& g, const auto& h) { return model.relation(g, h) == PlaneRelation::same; }`.
/// Cost: O(nodes) label comparisons and moves, O(nodes log nodes) plane comparisons at worst.
/// Nodes are renumbered (children first), so kept facets (`NodeFacets`) no longer fit the result.
template <class Plane, std::equality_comparable Label, class SameCut = std::equal_to<>>
requires std::predicate<SameCut&, const Plane&, const Plane&>
[[nodiscard]] PlaneTree<Plane, Label> collapse(PlaneTree<Plane, Label> tree, SameCut same_cut = {}) {
    detail::TreeCollapser<Plane, Label, SameCut> collapser(std::move(tree).parts(), same_cut);
    return PlaneTree<Plane, Label>(collapser.run());
}

CLEAVE_END_NAMESPACE

#endif
