// SPDX-License-Identifier: Apache-2.0
/// From the boundary of a set to its tree: facets choose the cuts, cuts sort the facets.
///
/// A cell is cut by the plane that the pivot chooses. Facets on one side go to that child, facets that cross the cut
/// are split, facets in the cut stay at the node. A child that receives no facet is a leaf, and the facets in the cut
/// say which label it has, because they lie in the closure of its cell and face outward:
///
/// | in the cut lie                   | an empty minus child is | an empty plus child is |
/// |----------------------------------|-------------------------|------------------------|
/// | facets that face as the cut does | inside                  | outside                |
/// | facets that face against it      | outside                 | inside                 |
/// | none (a structural cut)          | cannot happen: such a cut must send facets to both sides          ||
///
/// No cell of such a tree is empty: a facet in the cut, or facets on both sides of it, show that the cut meets the open
/// cell. After [Thibault-Naylor-1987, section 4], which labels leaves the same way but knows no cuts without facets.
#ifndef CLEAVE_BSP_BUILD_HPP
#define CLEAVE_BSP_BUILD_HPP

#include <cleave/base/contract.hpp>
#include <cleave/bsp/facet_tree.hpp>
#include <cleave/bsp/pivot.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/clip/concepts.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// One run of `build`. Lists of facets are divided in place: the child that receives more keeps the memory, and a facet
/// that is already where it belongs is not moved, so a chain of cuts that each take one facet away moves nothing.
template <Clip M, class Pivot>
class TreeBuilder {
public:
    using Plane = typename M::plane_type;
    using Facet = typename M::facet_type;

    TreeBuilder(M& model, Pivot& pivot, NodeFacets<Facet>* kept) : model_(model), pivot_(pivot), kept_(kept) {}

    PlaneTree<Plane> run(std::vector<Facet> facets, bool space) {
        if (facets.empty()) return PlaneTree<Plane>(space);
        open_.push_back(Cell{std::move(facets), 0, Branch{}, ChildSide::minus});
        while (!open_.empty()) {
            Cell cell = std::move(open_.back());
            open_.pop_back();
            cut_cell(std::move(cell));
        }
        return PlaneTree<Plane>(std::move(parts_));
    }

private:
    /// A cell still to be cut: its facets (those of the store from `first` on) and where its node will hang.
    struct Cell {
        std::vector<Facet> store;
        std::size_t first = 0;
        Branch parent;
        ChildSide side = ChildSide::minus;

        [[nodiscard]] std::span<const Facet> facets() const { return std::span<const Facet>(store).subspan(first); }
    };

    void cut_cell(Cell cell) {
        Plane h = choose_cut(cell.facets());
        const Branch node = parts_.add_node(h);
        parts_.hang(cell.parent, cell.side, node);

        const bool minus_label = sides_.counts[FacetSide::on_same] != 0;
        const bool keep_minus = sides_.counts.to_minus() >= sides_.counts.to_plus();
        std::vector<Facet> moved = divide(h, cell, keep_minus);
        cell.parent = node;
        cell.side = keep_minus ? ChildSide::minus : ChildSide::plus;
        Cell other{std::move(moved), 0, node, ~cell.side};

        // Plus below minus on the stack: nodes are numbered minus first.
        if (!keep_minus) std::swap(cell, other);
        finish(std::move(other), !minus_label);
        finish(std::move(cell), minus_label);
    }

    /// The pivot's plane, or the first facet's if the pivot's would get nowhere; `sides_` belongs to it.
    Plane choose_cut(std::span<const Facet> facets) {
        sides_.clear();
        Plane h = pivot_(model_, facets, sides_);
        if (sides_.list.size() != facets.size()) find_sides(model_, h, facets, sides_);
        const std::size_t n = facets.size();
        const SideCounts& counts = sides_.counts;
        if (counts.on() != 0 || (counts.to_minus() < n && counts.to_plus() < n)) return h;
        h = model_.plane_of(facets.front());
        find_sides(model_, h, facets, sides_);
        // At every contract level: a facet that is not in its own plane would be cut for ever.
        CLEAVE_CHECK_CONTRACT("requirement", counts.on() != 0);
        return h;
    }

    /// Divides the cell's facets by h: leaves in it those of the child that keeps the store, returns those of the
    /// other, both in their old order.
    std::vector<Facet> divide(const Plane& h, Cell& cell, bool keep_minus) {
        const FacetSide keep = keep_minus ? FacetSide::minus : FacetSide::plus;
        std::vector<Facet>& store = cell.store;
        std::vector<Facet> moved;
        moved.reserve(keep_minus ? sides_.counts.to_plus() : sides_.counts.to_minus());
        std::vector<Facet> same;
        std::vector<Facet> opposite;
        // From the back, so that what is kept gathers there and [to, end) never overtakes the facet being read. What is
        // kept at the very end stays where it is.
        const FacetSide* const first_side = sides_.list.data();
        const FacetSide* side = first_side + sides_.list.size();
        while (side != first_side && side[-1] == keep) --side;
        std::size_t from = cell.first + static_cast<std::size_t>(side - first_side);
        std::size_t to = from;
        while (from-- > cell.first) {
            Facet& f = store[from];
            --side;
            if (*side == keep) {
                if (--to != from) store[to] = std::move(f);
            } else if (*side == FacetSide::crossing) {
                Split<Facet> s = model_.split(h, f);
                CLEAVE_ASSERT(s.minus && s.plus);
                moved.push_back(*std::move(keep_minus ? s.plus : s.minus));
                store[--to] = *std::move(keep_minus ? s.minus : s.plus);
            } else if (*side == FacetSide::on_same) {
                if (kept_) same.push_back(std::move(f));
            } else if (*side == FacetSide::on_opposite) {
                if (kept_) opposite.push_back(std::move(f));
            } else {
                moved.push_back(std::move(f));
            }
        }
        cell.first = to;
        std::reverse(moved.begin(), moved.end());
        if (kept_) {
            std::reverse(same.begin(), same.end());
            std::reverse(opposite.begin(), opposite.end());
            kept_->add_node(std::move(same), std::move(opposite));
        }
        return moved;
    }

    /// A child without facets is a leaf; another is cut later.
    void finish(Cell cell, bool label) {
        if (cell.first == cell.store.size()) {
            parts_.hang(cell.parent, cell.side, parts_.add_leaf(label));
        } else {
            open_.push_back(std::move(cell));
        }
    }

    M& model_;
    Pivot& pivot_;
    NodeFacets<Facet>* kept_;
    TreeParts<Plane> parts_;
    std::vector<Cell> open_;
    FacetSides sides_;
};

}  // namespace detail

/// The tree of the set that `facets` bound; `space` is the answer if there are none (false: empty, true: full).
///
/// Requires: the facets face outward and are together the boundary of a regular set, each part of it once. They may be
///   split, coplanar, and in any order. Otherwise the result is still a tree, of an unspecified set.
/// Returns: a tree without empty cells, the same for the same facets, pivot and order; nodes are numbered parents
///   first, minus before plus.
/// Cost: for each facet (piece) one side test at each node that it reaches, more for pivots that compare candidates;
///   one split for each facet that crosses a cut. The depth is up to the number of facets.
template <Clip M, class Pivot = FirstFacet>
requires PivotFor<Pivot, M>
[[nodiscard]] PlaneTree<typename M::plane_type> build(M& model, std::vector<typename M::facet_type> facets,
                                                      Pivot pivot = {}, bool space = false) {
    return detail::TreeBuilder<M, Pivot>(model, pivot, nullptr).run(std::move(facets), space);
}

/// As `build`, and keeps at each node the pieces of the facets that lie in its cut.
template <Clip M, class Pivot = FirstFacet>
requires PivotFor<Pivot, M>
[[nodiscard]] FacetTree<typename M::plane_type, typename M::facet_type> build_with_facets(
    M& model, std::vector<typename M::facet_type> facets, Pivot pivot = {}, bool space = false) {
    FacetTree<typename M::plane_type, typename M::facet_type> result;
    result.tree = detail::TreeBuilder<M, Pivot>(model, pivot, &result.facets).run(std::move(facets), space);
    return result;
}

CLEAVE_END_NAMESPACE

#endif
