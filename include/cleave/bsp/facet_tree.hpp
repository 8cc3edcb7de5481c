// SPDX-License-Identifier: Apache-2.0
/// A tree together with the facets that lie in its cuts: a boundary and the space that it bounds, in one value.
#ifndef CLEAVE_BSP_FACET_TREE_HPP
#define CLEAVE_BSP_FACET_TREE_HPP

#include <cleave/base/contract.hpp>
#include <cleave/bsp/tree.hpp>

#include <cstddef>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// For each node of a tree the facets in its cut: those that face as the cut does, and those that face against it.
/// All of them lie in one array, node by node.
template <class Facet>
class NodeFacets {
public:
    /// For how many nodes facets are kept; zero if none were asked for.
    [[nodiscard]] std::size_t node_count() const noexcept { return ends_.size() / 2; }
    /// All facets, co- and anti-oriented ones, in the order of the nodes.
    [[nodiscard]] std::span<const Facet> all() const noexcept { return facets_; }

    /// Requires (both): `node.index() < node_count()`.
    [[nodiscard]] std::span<const Facet> same(Branch node) const { return slice(2 * std::size_t{node.index()}); }
    [[nodiscard]] std::span<const Facet> opposite(Branch node) const {
        return slice(2 * std::size_t{node.index()} + 1);
    }

    /// Adds the facets of the next node, whose number is the current `node_count()`.
    void add_node(std::vector<Facet> same, std::vector<Facet> opposite) {
        take(same);
        take(opposite);
    }

private:
    void take(std::vector<Facet>& list) {
        facets_.insert(facets_.end(), std::make_move_iterator(list.begin()), std::make_move_iterator(list.end()));
        ends_.push_back(facets_.size());
    }
    [[nodiscard]] std::span<const Facet> slice(std::size_t i) const {
        CLEAVE_REQUIRES(i < ends_.size());
        const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
        return std::span<const Facet>(facets_).subspan(begin, ends_[i] - begin);
    }

    std::vector<Facet> facets_;
    std::vector<std::size_t> ends_;  // of node i's co-oriented facets at 2i, of its anti-oriented ones at 2i + 1
};

/// What `build_with_facets` returns. The facets are those of the input, split by the cuts above their node: together
/// they are the input's boundary.
template <class Plane, class Facet>
struct FacetTree {
    PlaneTree<Plane> tree;
    NodeFacets<Facet> facets;
};

CLEAVE_END_NAMESPACE

#endif
