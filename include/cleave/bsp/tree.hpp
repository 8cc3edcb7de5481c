// SPDX-License-Identifier: Apache-2.0
/// The binary space partition itself: nodes that carry a cut, leaves that carry a label, in two flat arrays.
///
/// A tree stands for a map from space to labels. A node divides its cell by its *cut*, an oriented plane: the `minus`
/// child is the part below (inside) the cut, the `plus` child the part above (outside). A leaf gives its label to its
/// whole cell, an open convex set. With `bool` labels the tree is a set: `true` is inside, `false` is outside.
///
///                 cut h                        space
///                /     \                   inside | outside
///        minus: true   plus: false          h < 0 h   h > 0
///
/// Neither numbers nor dimensions appear here: `Plane` is any copyable type, and geometry enters through a `Clip` model
/// that is passed to the algorithms. Nothing in this folder recurses: a convex body of n facets can give a tree of
/// depth n, so every walk keeps its own stack.
///
/// After [Fuchs-Kedem-Naylor-1980] and [Thibault-Naylor-1987].
#ifndef CLEAVE_BSP_TREE_HPP
#define CLEAVE_BSP_TREE_HPP

#include <cleave/base/contract.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The two children of a node. minus: inside its cut; plus: outside.
enum class ChildSide : std::uint8_t { minus, plus };

/// The other side of the same cut.
[[nodiscard]] constexpr ChildSide operator~(ChildSide side) noexcept {
    return side == ChildSide::minus ? ChildSide::plus : ChildSide::minus;
}

/// What hangs on a side of a node, and what the root of a tree is: a node or a leaf, by its number.
class Branch {
public:
    /// Numbers are below this: one bit of 32 tells nodes from leaves.
    static constexpr std::uint32_t limit = 0x7fff'ffffU;

    /// No branch: what an unfinished node holds. A finished tree has none.
    constexpr Branch() noexcept = default;

    /// Requires: `index < limit`.
    [[nodiscard]] static constexpr Branch node(std::uint32_t index) noexcept { return Branch(index); }
    /// Requires: `index < limit`.
    [[nodiscard]] static constexpr Branch leaf(std::uint32_t index) noexcept { return Branch(index | leaf_bit); }

    [[nodiscard]] constexpr bool is_none() const noexcept { return code_ == none_code; }
    [[nodiscard]] constexpr bool is_node() const noexcept { return (code_ & leaf_bit) == 0; }
    [[nodiscard]] constexpr bool is_leaf() const noexcept { return !is_node() && !is_none(); }
    /// The position among the tree's nodes, or among its leaves.
    [[nodiscard]] constexpr std::uint32_t index() const noexcept { return code_ & ~leaf_bit; }

    friend constexpr bool operator==(Branch, Branch) noexcept = default;

private:
    static constexpr std::uint32_t leaf_bit = 0x8000'0000U;
    static constexpr std::uint32_t none_code = 0xffff'ffffU;

    explicit constexpr Branch(std::uint32_t code) noexcept : code_(code) {}

    std::uint32_t code_ = none_code;
};

/// A node: an oriented plane and what lies on its two sides.
template <class Plane>
struct TreeNode {
    Plane cut;
    Branch minus;
    Branch plus;

    [[nodiscard]] Branch child(ChildSide side) const noexcept { return side == ChildSide::minus ? minus : plus; }
    [[nodiscard]] Branch& child(ChildSide side) noexcept { return side == ChildSide::minus ? minus : plus; }
};

/// A leaf: a label. (A struct, so that a vector of leaves with `bool` labels is an ordinary vector.)
template <class Label>
struct TreeLeaf {
    Label label;
};

/// The raw material of a tree, for algorithms that assemble one.
template <class Plane, class Label = bool>
struct TreeParts {
    std::vector<TreeNode<Plane>> nodes;
    std::vector<TreeLeaf<Label>> leaves;
    Branch root;

    /// Appends a node whose children are still to be set.
    /// Throws: std::length_error beyond 2^31 - 1 nodes.
    Branch add_node(Plane cut) {
        const Branch b = Branch::node(checked_index(nodes.size()));
        nodes.push_back(TreeNode<Plane>{std::move(cut), Branch{}, Branch{}});
        return b;
    }
    /// Appends a leaf. Throws: std::length_error beyond 2^31 - 1 leaves.
    Branch add_leaf(Label label) {
        const Branch b = Branch::leaf(checked_index(leaves.size()));
        leaves.push_back(TreeLeaf<Label>{std::move(label)});
        return b;
    }
    /// Makes `child` the child of `parent` on that side, or the root where there is no parent.
    void hang(Branch parent, ChildSide side, Branch child) {
        if (parent.is_none())
            root = child;
        else
            nodes[parent.index()].child(side) = child;
    }

private:
    static std::uint32_t checked_index(std::size_t size) {
        if (size >= Branch::limit) throw std::length_error("cleave: a tree of more than 2^31 - 1 nodes or leaves");
        return static_cast<std::uint32_t>(size);
    }
};

/// A binary space partition with planes as cuts and labels at its leaves. A value: copies are independent, and moving
/// is cheap (a moved-from tree may only be assigned to or destroyed).
///
/// Invariant: every node and every leaf hangs on exactly one side of one node, or is the root (`bsp/invariant.hpp`
/// checks it). There is no empty tree: the empty set and all of space are single leaves.
///
/// Cost: a node is a plane and 8 bytes, a leaf is a label. The order of nodes in memory is not part of the value.
template <class Plane, class Label = bool>
class PlaneTree {
public:
    using plane_type = Plane;
    using label_type = Label;
    using node_type = TreeNode<Plane>;
    using leaf_type = TreeLeaf<Label>;
    using parts_type = TreeParts<Plane, Label>;

    /// One leaf with the default label: for `bool` the empty set.
    PlaneTree() : PlaneTree(Label{}) {}

    /// One leaf: all of space has this label.
    explicit PlaneTree(Label label) {
        parts_.leaves.push_back(leaf_type{std::move(label)});
        parts_.root = Branch::leaf(0);
    }

    /// Divides space by `cut`: `minus` holds inside it, `plus` outside.
    /// Cost: the smaller tree's nodes are moved to those of the larger, so growing a chain is linear.
    PlaneTree(Plane cut, PlaneTree minus, PlaneTree plus) {
        const bool grow_minus = minus.node_count() >= plus.node_count();
        PlaneTree& base = grow_minus ? minus : plus;
        const Branch kept = base.root();
        parts_ = std::move(base.parts_);
        const Branch added = append(std::move(grow_minus ? plus : minus));
        parts_.root = parts_.add_node(std::move(cut));
        parts_.nodes.back().minus = grow_minus ? kept : added;
        parts_.nodes.back().plus = grow_minus ? added : kept;
    }

    /// Takes over assembled parts.
    /// Requires: they satisfy the invariant of the class. It is not checked here, so that checkers can be tested.
    explicit PlaneTree(parts_type parts) noexcept : parts_(std::move(parts)) {}

    [[nodiscard]] Branch root() const noexcept { return parts_.root; }
    /// Whether all of space has one label because no cut is left. A set may be all of space without being told so by
    /// its tree; `bsp/collapse.hpp` makes this test exact for trees without empty cells.
    [[nodiscard]] bool is_single_leaf() const noexcept { return parts_.root.is_leaf(); }

    /// Numbers of cuts and of cells. A tree of n nodes has n + 1 leaves.
    [[nodiscard]] std::size_t node_count() const noexcept { return parts_.nodes.size(); }
    [[nodiscard]] std::size_t leaf_count() const noexcept { return parts_.leaves.size(); }

    /// All nodes and all leaves, in the order of their numbers.
    [[nodiscard]] std::span<const node_type> nodes() const noexcept { return parts_.nodes; }
    [[nodiscard]] std::span<const leaf_type> leaves() const noexcept { return parts_.leaves; }

    /// Requires (all below): `b` belongs to this tree and is of the kind that the name says.
    [[nodiscard]] const node_type& node(Branch b) const {
        CLEAVE_REQUIRES(b.is_node() && b.index() < parts_.nodes.size());
        return parts_.nodes[b.index()];
    }
    [[nodiscard]] const Plane& cut(Branch b) const { return node(b).cut; }
    [[nodiscard]] Branch minus(Branch b) const { return node(b).minus; }
    [[nodiscard]] Branch plus(Branch b) const { return node(b).plus; }
    [[nodiscard]] Branch child(Branch b, ChildSide side) const { return node(b).child(side); }
    [[nodiscard]] const Label& label(Branch b) const {
        CLEAVE_REQUIRES(b.is_leaf() && b.index() < parts_.leaves.size());
        return parts_.leaves[b.index()].label;
    }
    void set_label(Branch b, Label label) {
        CLEAVE_REQUIRES(b.is_leaf() && b.index() < parts_.leaves.size());
        parts_.leaves[b.index()].label = std::move(label);
    }

    /// The parts, to be read, or taken out of a tree that is no longer needed.
    [[nodiscard]] const parts_type& parts() const& noexcept { return parts_; }
    [[nodiscard]] parts_type parts() && noexcept { return std::move(parts_); }

    /// Whether both trees have the same cuts and labels in the same places; how they are numbered does not matter.
    /// Different trees may still stand for the same set.
    friend bool operator==(const PlaneTree& a, const PlaneTree& b) requires std::equality_comparable<Plane> &&
        std::equality_comparable<Label> {
        if (a.node_count() != b.node_count()) return false;
        std::vector<std::pair<Branch, Branch>> open{{a.root(), b.root()}};
        while (!open.empty()) {
            const std::pair<Branch, Branch> at = open.back();
            open.pop_back();
            if (at.first.is_leaf() != at.second.is_leaf()) return false;
            if (at.first.is_leaf()) {
                if (!(a.label(at.first) == b.label(at.second))) return false;
                continue;
            }
            const node_type& m = a.node(at.first);
            const node_type& n = b.node(at.second);
            if (!(m.cut == n.cut)) return false;
            open.emplace_back(m.plus, n.plus);
            open.emplace_back(m.minus, n.minus);
        }
        return true;
    }

private:
    /// Moves the nodes and leaves of another tree behind the own ones and returns its root under its new number.
    Branch append(PlaneTree&& other) {
        if (parts_.nodes.size() + other.parts_.nodes.size() >= Branch::limit) {
            throw std::length_error("cleave: a tree of more than 2^31 - 1 nodes");
        }
        const auto node_shift = static_cast<std::uint32_t>(parts_.nodes.size());
        const auto leaf_shift = static_cast<std::uint32_t>(parts_.leaves.size());
        const auto shifted = [&](Branch b) {
            return b.is_node() ? Branch::node(b.index() + node_shift) : Branch::leaf(b.index() + leaf_shift);
        };
        for (node_type& n : other.parts_.nodes) {
            n.minus = shifted(n.minus);
            n.plus = shifted(n.plus);
        }
        parts_.nodes.insert(parts_.nodes.end(), std::make_move_iterator(other.parts_.nodes.begin()),
                            std::make_move_iterator(other.parts_.nodes.end()));
        parts_.leaves.insert(parts_.leaves.end(), std::make_move_iterator(other.parts_.leaves.begin()),
                             std::make_move_iterator(other.parts_.leaves.end()));
        return shifted(other.parts_.root);
    }

    parts_type parts_;
};

CLEAVE_END_NAMESPACE

#endif
