// SPDX-License-Identifier: Apache-2.0
/// Extrusion: a set of one dimension less, swept along the last axis.
#ifndef CLEAVE_SHAPE_EXTRUDE_HPP
#define CLEAVE_SHAPE_EXTRUDE_HPP

#include <cleave/region/tree.hpp>
#include <cleave/shape/prism.hpp>
#include <cleave/shape/rational_point.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// The tree of all (x, z) with x in the base, under the cuts that `parts` has already.
template <int D, class N>
void append_lifted(const Region<D, N>& base, TreeParts<Plane<D + 1, Integer>>& parts, Branch parent) {
    const BspTree<D, Integer> tree = to_tree(Region<D, Integer>(base));
    const auto nodes = static_cast<std::uint32_t>(parts.nodes.size());
    const auto leaves = static_cast<std::uint32_t>(parts.leaves.size());
    const auto moved = [&](Branch b) {
        return b.is_leaf() ? Branch::leaf(leaves + b.index()) : Branch::node(nodes + b.index());
    };
    for (const TreeNode<Plane<D, Integer>>& node : tree.nodes()) {
        typename Plane<D + 1, Integer>::Coefficients c;
        for (std::size_t i = 0; i < std::size_t(D); ++i) c[i] = node.cut.coefficients()[i];
        c[std::size_t(D)] = Integer(0);
        c[std::size_t(D) + 1] = node.cut.coefficients()[std::size_t(D)];
        parts.nodes.push_back({Plane<D + 1, Integer>(std::move(c)), moved(node.minus), moved(node.plus)});
    }
    parts.leaves.insert(parts.leaves.end(), tree.leaves().begin(), tree.leaves().end());
    parts.hang(parent, ChildSide::minus, moved(tree.root()));
}

/// sign * x_last <= at.
template <int D>
[[nodiscard]] Plane<D, Integer> level_plane(int sign, const Fraction& at) {
    typename Plane<D, Integer>::Coefficients c;
    c[std::size_t(D) - 1] = sign > 0 ? at.den : -at.den;
    c[std::size_t(D)] = sign > 0 ? -at.num : at.num;
    return Plane<D, Integer>(std::move(c));
}

}  // namespace detail

/// All (x, z) with x in `base` and z between the two bounds, which may come in either order; with z0 = z1, or an empty
/// base, the empty set. The base may be unbounded and of any dimension: `extrude(extrude(segment, 0, 1), 0, 1)` is a
/// box. For bounded polygon sets this is `prism`.
/// Throws: NumberError for a bound that is infinite or NaN.
/// Cost: for other bases than bounded polygon sets, that of `to_tree` and `to_region`.
template <int D, class N>
[[nodiscard]] Region<D + 1, N> extrude(const Region<D, N>& base, const std::type_identity_t<N>& z0,
                                       const std::type_identity_t<N>& z1) {
    Fraction bottom = exact_fraction(z0);
    Fraction top = exact_fraction(z1);
    const Sign order = Integer(bottom.num * top.den - top.num * bottom.den).sign();
    if (order == Sign::zero || base.is_empty()) return Region<D + 1, N>::empty();
    if (order == Sign::plus) std::swap(bottom, top);
    if constexpr (D == 2) {
        if (base.is_bounded()) return prism<N>(base, z0, z1);
    }
    TreeParts<Plane<D + 1, Integer>> parts;
    parts.root = parts.add_node(detail::level_plane<D + 1>(1, top));
    const Branch above = parts.add_node(detail::level_plane<D + 1>(-1, bottom));
    const Branch outside = parts.add_leaf(false);
    parts.hang(parts.root, ChildSide::minus, above);
    parts.hang(parts.root, ChildSide::plus, outside);
    parts.hang(above, ChildSide::plus, parts.add_leaf(false));
    detail::append_lifted(base, parts, above);
    return Region<D + 1, N>(to_region(BspTree<D + 1, Integer>(std::move(parts))));
}

/// All (x, z) with x in `base`, z any number: the base swept both ways without end.
template <int D, class N>
[[nodiscard]] Region<D + 1, N> extrude(const Region<D, N>& base) {
    TreeParts<Plane<D + 1, Integer>> parts;
    detail::append_lifted(base, parts, Branch{});
    return Region<D + 1, N>(to_region(BspTree<D + 1, Integer>(std::move(parts))));
}

CLEAVE_END_NAMESPACE

#endif
