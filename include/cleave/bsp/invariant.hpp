// SPDX-License-Identifier: Apache-2.0
/// Checkers: is this a tree, and do the facets kept at its nodes agree with its cuts, cells and labels?
///
/// They trust nothing, report every defect with the place where it is, and change nothing.
#ifndef CLEAVE_BSP_INVARIANT_HPP
#define CLEAVE_BSP_INVARIANT_HPP

#include <cleave/bsp/facet_tree.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/bsp/visit.hpp>
#include <cleave/clip/concepts.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// What can be wrong with the links of a tree.
/// missing: a root or child that was never set; out_of_range: an index beyond the array; cycle: a node is its own
/// descendant; shared: two parents have the same child; orphan: no path from the root leads there.
enum class TreeDefectKind : std::uint8_t { missing, out_of_range, cycle, shared, orphan };

/// A broken link: `branch` is where it leads, `parent` the node that has it (none for the root and for orphans).
struct TreeDefect {
    TreeDefectKind kind;
    Branch parent;
    Branch branch;

    friend bool operator==(const TreeDefect&, const TreeDefect&) = default;
};

/// Checks the invariant of `PlaneTree`: every node and leaf hangs in exactly one place.
/// Returns: all defects, found from the root down, then orphans by number; none for a sound tree.
/// Cost: O(nodes) time and memory; safe for any contents, cycles included.
template <class Plane, class Label>
[[nodiscard]] std::vector<TreeDefect> check_structure(const PlaneTree<Plane, Label>& tree) {
    enum class Mark : std::uint8_t { unseen, open, done };
    std::vector<TreeDefect> defects;
    std::vector<Mark> nodes(tree.node_count(), Mark::unseen);
    std::vector<Mark> leaves(tree.leaf_count(), Mark::unseen);
    struct Visit {
        Branch parent;
        Branch branch;
        bool leaving;
    };
    std::vector<Visit> open{{Branch{}, tree.root(), false}};
    while (!open.empty()) {
        const Visit v = open.back();
        open.pop_back();
        const auto report = [&](TreeDefectKind kind) { defects.push_back(TreeDefect{kind, v.parent, v.branch}); };
        if (v.branch.is_none()) {
            report(TreeDefectKind::missing);
            continue;
        }
        std::vector<Mark>& marks = v.branch.is_node() ? nodes : leaves;
        if (v.branch.index() >= marks.size()) {
            report(TreeDefectKind::out_of_range);
            continue;
        }
        Mark& mark = marks[v.branch.index()];
        if (v.leaving) {
            mark = Mark::done;
        } else if (mark != Mark::unseen) {
            report(mark == Mark::open ? TreeDefectKind::cycle : TreeDefectKind::shared);
        } else if (v.branch.is_leaf()) {
            mark = Mark::done;
        } else {
            mark = Mark::open;
            const TreeNode<Plane>& n = tree.node(v.branch);
            open.push_back({v.parent, v.branch, true});
            open.push_back({v.branch, n.plus, false});
            open.push_back({v.branch, n.minus, false});
        }
    }
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i] == Mark::unseen) defects.push_back({TreeDefectKind::orphan, Branch{}, Branch::node(i)});
    }
    for (std::uint32_t i = 0; i < leaves.size(); ++i) {
        if (leaves[i] == Mark::unseen) defects.push_back({TreeDefectKind::orphan, Branch{}, Branch::leaf(i)});
    }
    return defects;
}

/// What can be wrong with a facet that is kept at a node.
/// not_in_cut: it does not lie in the node's plane; misfiled: it does, but faces the other way than its list says;
/// outside_cell: a cut above has it on the wrong side, or splits it; cut_again: a cut below lies in it too, so that a
/// cell is empty; label_inside, label_outside: a leaf next to its inner (outer) side is not labelled inside (outside).
enum class FacetDefectKind : std::uint8_t {
    not_in_cut,
    misfiled,
    outside_cell,
    cut_again,
    label_inside,
    label_outside
};

/// A facet that disagrees with the tree: its node and its place in `facets.all()`.
struct FacetDefect {
    FacetDefectKind kind;
    Branch node;
    std::size_t facet = 0;

    friend bool operator==(const FacetDefect&, const FacetDefect&) = default;
};

namespace detail {

/// Sends a facet down a subtree, piece by piece, and looks at the labels of the leaves that it borders on.
/// Returns: {a cut of the subtree lies in the facet, a leaf has another label than `expected`}.
template <Clip M>
std::pair<bool, bool> probe_side(M& model, const PlaneTree<typename M::plane_type>& tree, Branch start,
                                 const typename M::facet_type& facet, bool expected) {
    std::pair<bool, bool> found{false, false};
    std::vector<std::pair<Branch, typename M::facet_type>> open{{start, facet}};
    while (!open.empty()) {
        std::pair<Branch, typename M::facet_type> at = std::move(open.back());
        open.pop_back();
        if (at.first.is_leaf()) {
            found.second = found.second || tree.label(at.first) != expected;
            continue;
        }
        const TreeNode<typename M::plane_type>& n = tree.node(at.first);
        Split<typename M::facet_type> s = model.split(n.cut, at.second);
        if (s.on) found.first = true;
        if (s.minus) open.emplace_back(n.minus, *std::move(s.minus));
        if (s.plus) open.emplace_back(n.plus, *std::move(s.plus));
    }
    return found;
}

}  // namespace detail

/// Checks a tree that kept its facets: each lies in the cut and the closed cell of its node, in the right list, and
/// borders on inside below and outside above.
/// Requires: `check_structure(t.tree)` is empty, and facets were kept for every node.
/// Returns: all defects, one of each kind a facet, in preorder; none for the boundary of a regular set.
/// Cost: for each facet the cuts above it, and two searches of the subtrees below it.
template <Clip M>
[[nodiscard]] std::vector<FacetDefect> check_facets(
    M& model, const FacetTree<typename M::plane_type, typename M::facet_type>& t) {
    using Facet = typename M::facet_type;
    CLEAVE_REQUIRES(t.facets.node_count() == t.tree.node_count());
    std::vector<FacetDefect> defects;
    const auto check = [&](Branch node, std::span<const Step> path, const Facet& f, bool is_same) {
        const auto place = static_cast<std::size_t>(&f - t.facets.all().data());
        const auto report = [&](bool found, FacetDefectKind kind) {
            if (found) defects.push_back(FacetDefect{kind, node, place});
        };
        const FacetSide in_cut = model.side(t.tree.cut(node), f);
        const FacetSide wanted = is_same ? FacetSide::on_same : FacetSide::on_opposite;
        const FacetSide mirrored = is_same ? FacetSide::on_opposite : FacetSide::on_same;
        report(in_cut != wanted && in_cut != mirrored, FacetDefectKind::not_in_cut);
        report(in_cut == mirrored, FacetDefectKind::misfiled);
        bool outside = false;
        for (const Step& step : path) {
            const FacetSide side = model.side(t.tree.cut(step.node), f);
            outside = outside || side != (step.side == ChildSide::minus ? FacetSide::minus : FacetSide::plus);
        }
        report(outside, FacetDefectKind::outside_cell);
        const ChildSide inner = is_same ? ChildSide::minus : ChildSide::plus;
        const std::pair<bool, bool> below = detail::probe_side(model, t.tree, t.tree.child(node, inner), f, true);
        const std::pair<bool, bool> above = detail::probe_side(model, t.tree, t.tree.child(node, ~inner), f, false);
        report(below.first || above.first, FacetDefectKind::cut_again);
        report(below.second, FacetDefectKind::label_inside);
        report(above.second, FacetDefectKind::label_outside);
    };
    visit_preorder(t.tree, [&](Branch b, std::span<const Step> path) {
        if (b.is_leaf()) return;
        for (const Facet& f : t.facets.same(b)) check(b, path, f, true);
        for (const Facet& f : t.facets.opposite(b)) check(b, path, f, false);
    });
    return defects;
}

CLEAVE_END_NAMESPACE

#endif
