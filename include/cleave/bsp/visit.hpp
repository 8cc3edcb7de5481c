// SPDX-License-Identifier: Apache-2.0
/// Walks over a tree: parents first, children first, or across space from near to far, always with an explicit stack.
///
/// A visitor is called with a `Branch`, and with the path that leads to it if it takes one: `visitor(branch)` or
/// `visitor(branch, path)`. It returns nothing, or a `Walk` to steer.
#ifndef CLEAVE_BSP_VISIT_HPP
#define CLEAVE_BSP_VISIT_HPP

#include <cleave/bsp/tree.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// One step of a path: a node, and the side that was taken there. The cell of a branch is the intersection of the open
/// half-spaces of its path.
struct Step {
    Branch node;
    ChildSide side = ChildSide::minus;

    friend constexpr bool operator==(const Step&, const Step&) noexcept = default;
};

/// What a visitor answers. proceed: go on; skip: do not enter this node's children (where they come after it);
/// stop: end the walk.
enum class Walk : std::uint8_t { proceed, skip, stop };

/// A callable for the walks of this header.
template <class V>
concept TreeVisitor = std::invocable<V&, Branch> || std::invocable<V&, Branch, std::span<const Step>>;

namespace detail {

template <class Visitor>
Walk call_visitor(Visitor& visitor, Branch b, std::span<const Step> path) {
    if constexpr (std::invocable<Visitor&, Branch, std::span<const Step>>) {
        if constexpr (std::is_void_v<std::invoke_result_t<Visitor&, Branch, std::span<const Step>>>) {
            std::invoke(visitor, b, path);
            return Walk::proceed;
        } else {
            return std::invoke(visitor, b, path);
        }
    } else {
        if constexpr (std::is_void_v<std::invoke_result_t<Visitor&, Branch>>) {
            std::invoke(visitor, b);
            return Walk::proceed;
        } else {
            return std::invoke(visitor, b);
        }
    }
}

/// Moments of a tour around the tree: a leaf; a node before, between and after its children.
enum class TourMoment : std::uint8_t { leaf, before, between, after };

/// The tour under all walks. `first(node)` is the side to enter first; `event(moment, branch, path)` steers by `Walk`.
/// Returns: whether the tour was completed.
template <class Tree, class First, class Event>
bool tour_tree(const Tree& tree, Branch start, First&& first, Event&& event) {
    std::vector<Step> path;
    std::vector<std::uint8_t> turned;  // beside path: whether the second child of that node is being visited
    Branch at = start;
    for (;;) {
        if (at.is_node()) {
            const Walk walk = event(TourMoment::before, at, std::span<const Step>(path));
            if (walk == Walk::stop) return false;
            if (walk == Walk::proceed) {
                path.push_back(Step{at, first(at)});
                turned.push_back(0);
                at = tree.child(at, path.back().side);
                continue;
            }
        } else if (event(TourMoment::leaf, at, std::span<const Step>(path)) == Walk::stop) {
            return false;
        }
        // `at` is done: climb to the nearest node that still has a child to visit.
        for (;;) {
            if (path.empty()) return true;
            const Branch parent = path.back().node;
            const std::span<const Step> above(path.data(), path.size() - 1);
            if (turned.back() == 0) {
                const Walk walk = event(TourMoment::between, parent, above);
                if (walk == Walk::stop) return false;
                if (walk == Walk::proceed) {
                    turned.back() = 1;
                    path.back().side = ~path.back().side;
                    at = tree.child(parent, path.back().side);
                    break;
                }
            }
            if (event(TourMoment::after, parent, above) == Walk::stop) return false;
            path.pop_back();
            turned.pop_back();
        }
    }
}

}  // namespace detail

/// Visits each branch before its children, minus before plus. `skip` at a node leaves out its subtree.
/// Returns: whether the walk was completed, that is, never stopped.
/// Cost: O(nodes) calls, O(depth) memory.
template <class Plane, class Label, TreeVisitor Visitor>
bool visit_preorder(const PlaneTree<Plane, Label>& tree, Visitor&& visitor) {
    return detail::tour_tree(
        tree, tree.root(), [](Branch) { return ChildSide::minus; },
        [&](detail::TourMoment moment, Branch b, std::span<const Step> path) {
            const bool now = moment == detail::TourMoment::leaf || moment == detail::TourMoment::before;
            return now ? detail::call_visitor(visitor, b, path) : Walk::proceed;
        });
}

/// Visits each branch after its children, minus before plus. (`skip` is `proceed`.)
/// Returns: whether the walk was completed.
template <class Plane, class Label, TreeVisitor Visitor>
bool visit_postorder(const PlaneTree<Plane, Label>& tree, Visitor&& visitor) {
    return detail::tour_tree(
        tree, tree.root(), [](Branch) { return ChildSide::minus; },
        [&](detail::TourMoment moment, Branch b, std::span<const Step> path) {
            const bool now = moment == detail::TourMoment::leaf || moment == detail::TourMoment::after;
            return now ? detail::call_visitor(visitor, b, path) : Walk::proceed;
        });
}

/// Visits the cells across space: at each node the subtree on the side `first(node)`, then the node, then the other
/// subtree. With `first` the side of a viewpoint the order is from near to far: nothing visited later can hide
/// anything visited earlier [Fuchs-Kedem-Naylor-1980]; with the opposite side it is the painter's order.
/// `skip` at a node leaves out its second subtree (what lies behind its cut).
/// Returns: whether the walk was completed.
template <class Plane, class Label, std::invocable<Branch> First, TreeVisitor Visitor>
bool visit_across(const PlaneTree<Plane, Label>& tree, First&& first, Visitor&& visitor) {
    return detail::tour_tree(tree, tree.root(), std::forward<First>(first),
                             [&](detail::TourMoment moment, Branch b, std::span<const Step> path) {
                                 const bool now =
                                     moment == detail::TourMoment::leaf || moment == detail::TourMoment::between;
                                 return now ? detail::call_visitor(visitor, b, path) : Walk::proceed;
                             });
}

CLEAVE_END_NAMESPACE

#endif
