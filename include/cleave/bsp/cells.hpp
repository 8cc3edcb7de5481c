// SPDX-License-Identifier: Apache-2.0
/// A tree and the convex cells that its branches stand for: the part of a tree inside a cell, the two parts on the
/// sides of a plane, the part of each cut inside its cell, and the check that no cell is empty.
#ifndef CLEAVE_BSP_CELLS_HPP
#define CLEAVE_BSP_CELLS_HPP

#include <cleave/base/contract.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/clip/concepts.hpp>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// Appends a copy of the subtree under `from`, its labels passed through f. Returns its root.
template <class Plane, class From, class Label, class F>
Branch copy_subtree(const PlaneTree<Plane, From>& tree, Branch from, TreeParts<Plane, Label>& to, F&& f) {
    struct Copy {
        Branch branch;
        Branch parent;
        ChildSide side;
    };
    Branch root;
    std::vector<Copy> open{{from, Branch{}, ChildSide::minus}};
    while (!open.empty()) {
        const Copy c = open.back();
        open.pop_back();
        const Branch made = c.branch.is_leaf() ? to.add_leaf(f(tree.label(c.branch))) : to.add_node(tree.cut(c.branch));
        if (c.parent.is_none())
            root = made;
        else
            to.hang(c.parent, c.side, made);
        if (c.branch.is_leaf()) continue;
        open.push_back({tree.plus(c.branch), made, ChildSide::plus});
        open.push_back({tree.minus(c.branch), made, ChildSide::minus});
    }
    return root;
}

/// Calls `visit(branch, cell, split)` as `for_each_cell` does, while it returns true. Returns whether it did to the
/// end.
template <CellClip M, class Label, class Visit>
bool walk_cells(M& model, const PlaneTree<typename M::plane_type, Label>& tree, typename M::cell_type space,
                Visit&& visit) {
    using Cell = typename M::cell_type;
    std::vector<std::pair<Branch, Cell>> open;
    open.emplace_back(tree.root(), std::move(space));
    while (!open.empty()) {
        const Branch b = open.back().first;
        const Cell cell = std::move(open.back().second);
        open.pop_back();
        CellSplit<Cell, typename M::facet_type> s;
        if (b.is_node()) s = model.split_cell(tree.cut(b), cell);
        if (!visit(b, cell, s)) return false;
        if (b.is_leaf()) continue;
        open.emplace_back(tree.plus(b), *std::move(s.plus));
        open.emplace_back(tree.minus(b), *std::move(s.minus));
    }
    return true;
}

}  // namespace detail

/// Calls `visit(branch, cell, split)` for every node and leaf, parents first, minus before plus. `split` is that of a
/// node's cell by its cut; the visitor may take the lid out of it. A leaf's is empty. `space` is the root's cell.
/// Requires: no cell is empty. Cost: a cell split for each node.
template <CellClip M, class Label, class Visit>
void for_each_cell(M& model, const PlaneTree<typename M::plane_type, Label>& tree, typename M::cell_type space,
                   Visit&& visit) {
    detail::walk_cells(model, tree, std::move(space), [&](Branch b, const auto& cell, auto& split) {
        CLEAVE_CHECK_CONTRACT("requirement", b.is_leaf() || split.side == FacetSide::crossing);
        visit(b, cell, split);
        return true;
    });
}

/// The same for all of space.
template <CellClip M, class Label, class Visit>
void for_each_cell(M& model, const PlaneTree<typename M::plane_type, Label>& tree, Visit&& visit) {
    for_each_cell(model, tree, model.universe(), std::forward<Visit>(visit));
}

/// Whether every cut runs through the interior of its node's cell, so that every branch stands for a set with an
/// interior. Trees made by this library are like that; `restricted` makes any tree so.
template <CellClip M, class Label>
[[nodiscard]] bool has_no_empty_cell(M& model, const PlaneTree<typename M::plane_type, Label>& tree) {
    return detail::walk_cells(model, tree, model.universe(), [](Branch b, const auto&, const auto& split) {
        return b.is_leaf() || split.side == FacetSide::crossing;
    });
}

/// The *sub-hyperplane* of each node, the part of its cut inside its cell, facing as the cut does; by number of node.
template <CellClip M, class Label>
[[nodiscard]] std::vector<typename M::facet_type> sub_hyperplanes(
    M& model, const PlaneTree<typename M::plane_type, Label>& tree) {
    std::vector<std::optional<typename M::facet_type>> found(tree.node_count());
    for_each_cell(model, tree, [&](Branch b, const auto&, auto& split) {
        if (b.is_node()) found[b.index()] = std::move(split.lid);
    });
    std::vector<typename M::facet_type> all;
    all.reserve(found.size());
    for (auto& f : found) all.push_back(*std::move(f));
    return all;
}

/// What the tree looks like inside a cell: cuts that miss the cell's interior are left out.
/// Cost: a test or a split of (a part of) the cell for each cut that may meet it.
template <CellClip M, class Label>
[[nodiscard]] PlaneTree<typename M::plane_type, Label> restricted(M& model,
                                                                  const PlaneTree<typename M::plane_type, Label>& tree,
                                                                  typename M::cell_type cell) {
    using Cell = typename M::cell_type;
    struct Task {
        Cell cell;
        Branch from;
        Branch parent;
        ChildSide side;
    };
    TreeParts<typename M::plane_type, Label> to;
    std::vector<Task> open;
    open.push_back({std::move(cell), tree.root(), Branch{}, ChildSide::minus});
    while (!open.empty()) {
        Task t = std::move(open.back());
        open.pop_back();
        for (;;) {
            if (t.from.is_leaf()) {
                to.hang(t.parent, t.side, to.add_leaf(tree.label(t.from)));
                break;
            }
            auto s = model.split_cell(tree.cut(t.from), t.cell);
            if (s.side == FacetSide::crossing) {
                const Branch node = to.add_node(tree.cut(t.from));
                to.hang(t.parent, t.side, node);
                open.push_back({*std::move(s.plus), tree.plus(t.from), node, ChildSide::plus});
                open.push_back({*std::move(s.minus), tree.minus(t.from), node, ChildSide::minus});
                break;
            }
            t.from = s.side == FacetSide::minus ? tree.minus(t.from) : tree.plus(t.from);
        }
    }
    return PlaneTree<typename M::plane_type, Label>(std::move(to));
}

/// Two trees for the two sides of a plane.
template <class Plane, class Label>
struct PartitionedTree {
    PlaneTree<Plane, Label> minus;
    PlaneTree<Plane, Label> plus;
};

/// Divides a tree by a plane: `PlaneTree(h, minus, plus)` is the same map from space to labels, with h at the root.
/// After [Naylor-Amanatides-Thibault-1990, section 4]; what can't be in a half is known from cells, not from relations
/// of sub-hyperplanes, so nothing empty is kept.
template <CellClip M, class Label>
[[nodiscard]] PartitionedTree<typename M::plane_type, Label> partition(
    M& model, const PlaneTree<typename M::plane_type, Label>& tree, const typename M::plane_type& h) {
    auto s = model.split_cell(h, model.universe());
    CLEAVE_ASSERT(s.side == FacetSide::crossing);
    return {restricted(model, tree, *std::move(s.minus)), restricted(model, tree, *std::move(s.plus))};
}

CLEAVE_END_NAMESPACE

#endif
