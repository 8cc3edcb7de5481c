// SPDX-License-Identifier: Apache-2.0
/// New labels on the same cuts: any function of a label, and the complement of a set as the simplest one.
///
/// Cuts keep their orientation: complementing swaps what the two sides of a cut mean, not which side is which.
#ifndef CLEAVE_BSP_COMPLEMENT_HPP
#define CLEAVE_BSP_COMPLEMENT_HPP

#include <cleave/bsp/facet_tree.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/clip/concepts.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The tree whose leaves are labelled `f(label)`; the label type may change. With labels that say which of several
/// operands contain a cell, a Boolean function of them evaluates the expression.
/// Cost: O(leaves); cuts are moved if the tree is given up. Equal neighbours are left for `collapse` to join.
template <class Plane, class Label, std::invocable<const Label&> F>
[[nodiscard]] auto relabel(PlaneTree<Plane, Label> tree, F&& f) {
    using Result = std::remove_cvref_t<std::invoke_result_t<F&, const Label&>>;
    TreeParts<Plane, Label> parts = std::move(tree).parts();
    TreeParts<Plane, Result> result;
    result.nodes = std::move(parts.nodes);
    result.root = parts.root;
    result.leaves.reserve(parts.leaves.size());
    for (const TreeLeaf<Label>& leaf : parts.leaves) {
        result.leaves.push_back(TreeLeaf<Result>{std::invoke(f, leaf.label)});
    }
    return PlaneTree<Plane, Result>(std::move(result));
}

/// The tree of the complement: inside and outside change places.
template <class Plane>
[[nodiscard]] PlaneTree<Plane> complement(PlaneTree<Plane> tree) {
    return relabel(std::move(tree), [](bool inside) { return !inside; });
}

/// The complement with its boundary: the kept facets are flipped, so what faced as the cut does now faces against it.
template <Clip M>
[[nodiscard]] FacetTree<typename M::plane_type, typename M::facet_type> complement(
    M& model, FacetTree<typename M::plane_type, typename M::facet_type> t) {
    using Facet = typename M::facet_type;
    const auto flipped = [&model](std::span<const Facet> facets) {
        std::vector<Facet> result;
        result.reserve(facets.size());
        for (const Facet& f : facets) result.push_back(model.flip(f));
        return result;
    };
    FacetTree<typename M::plane_type, Facet> result{complement(std::move(t.tree)), {}};
    for (std::size_t i = 0; i < t.facets.node_count(); ++i) {
        const Branch node = Branch::node(static_cast<std::uint32_t>(i));
        result.facets.add_node(flipped(t.facets.opposite(node)), flipped(t.facets.same(node)));
    }
    return result;
}

CLEAVE_END_NAMESPACE

#endif
