// SPDX-License-Identifier: Apache-2.0
/// Where a point lies: sent down the tree by its side of each cut, into both children where it is on one.
///
/// The leaves that a point reaches in this way are exactly those whose closed cells contain it, *provided that no cell
/// is empty*: the closure of a non-empty intersection of open half-spaces is the intersection of the closed ones, and
/// that of an empty one is not. Trees from `build`, and what `collapse`, `relabel` and `complement` make of them, have
/// no empty cells. A cut is not boundary by itself: a point on it is a boundary point only if leaves with different
/// labels meet there.
#ifndef CLEAVE_BSP_CLASSIFY_HPP
#define CLEAVE_BSP_CLASSIFY_HPP

#include <cleave/bsp/tree.hpp>
#include <cleave/bsp/visit.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/number/sign.hpp>

#include <concepts>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Where a point lies with respect to a regular set: in its interior, in the interior of its complement, or on the
/// boundary between them.
enum class Location : std::uint8_t { inside, outside, boundary };

/// Calls `visitor(leaf)` for each leaf whose closed cell contains p, minus before plus. It may return a `Walk`; `stop`
/// ends the search.
/// Requires: the tree has no empty cells.
/// Returns: whether the search was completed.
/// Cost: one side test for each node reached: the depth of the leaf for a point on no cut.
template <LocatingClip M, class Label, std::invocable<Branch> Visitor>
bool visit_leaves_at(M& model, const PlaneTree<typename M::plane_type, Label>& tree, const typename M::point_type& p,
                     Visitor&& visitor) {
    std::vector<Branch> waiting;  // the plus children of the cuts that p is on
    Branch at = tree.root();
    for (;;) {
        while (at.is_node()) {
            const TreeNode<typename M::plane_type>& n = tree.node(at);
            const Sign s = model.side(n.cut, p);
            if (s == Sign::zero) waiting.push_back(n.plus);
            at = s == Sign::plus ? n.plus : n.minus;
        }
        if constexpr (std::is_void_v<std::invoke_result_t<Visitor&, Branch>>) {
            std::invoke(visitor, at);
        } else if (std::invoke(visitor, at) == Walk::stop) {
            return false;
        }
        if (waiting.empty()) return true;
        at = waiting.back();
        waiting.pop_back();
    }
}

/// Requires: the tree has no empty cells.
/// Returns: inside or outside if all leaves whose closed cells contain p say so, else boundary.
template <LocatingClip M>
[[nodiscard]] Location classify(M& model, const PlaneTree<typename M::plane_type, bool>& tree,
                                const typename M::point_type& p) {
    bool inside = false;
    bool outside = false;
    visit_leaves_at(model, tree, p, [&](Branch leaf) {
        (tree.label(leaf) ? inside : outside) = true;
        return inside && outside ? Walk::stop : Walk::proceed;
    });
    return inside ? (outside ? Location::boundary : Location::inside) : Location::outside;
}

CLEAVE_END_NAMESPACE

#endif
