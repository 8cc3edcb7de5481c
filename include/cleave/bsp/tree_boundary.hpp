// SPDX-License-Identifier: Apache-2.0
/// The boundary of the set, or of the map, that a tree stands for.
///
/// Every point of the boundary lies in the cut of exactly one node, inside the node's cell. So each node's
/// sub-hyperplane is pushed into the two subtrees beside it; its pieces whose labels differ on the two sides are
/// boundary, each once, and outward by construction [Naylor-Amanatides-Thibault-1990, section 3]. Splits that turn out
/// needless are undone.
#ifndef CLEAVE_BSP_TREE_BOUNDARY_HPP
#define CLEAVE_BSP_TREE_BOUNDARY_HPP

#include <cleave/bsp/cells.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/clip/concepts.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// Sorts the pieces of one sub-hyperplane by the labels on their two sides.
template <CellClip M, class Label>
class LidClassifier {
public:
    using Plane = typename M::plane_type;
    using Facet = typename M::facet_type;
    using Tree = PlaneTree<Plane, Label>;

    LidClassifier(M& model, const Tree& tree) : model_(model), tree_(tree) {}

    /// Calls `emit(piece, label below, label above)` for maximal pieces on which the two differ.
    template <class Emit>
    void run(const Facet& lid, Branch minus, Branch plus, Emit&& emit) {
        pieces_.clear();
        pieces_.push_back(Piece{lid, 0, minus, plus});
        // Children follow their parents, so this loop reaches every piece.
        for (std::size_t i = 0; i < pieces_.size(); ++i) descend(i);
        merge_back();
        open_.assign(1, 0);
        while (!open_.empty()) {
            const std::size_t i = open_.back();
            open_.pop_back();
            if (const std::size_t c = pieces_[i].children; c != 0) {
                open_.push_back(c + 1);
                open_.push_back(c);
                continue;
            }
            const Label& below = tree_.label(pieces_[i].below);
            const Label& above = tree_.label(pieces_[i].above);
            if (!(below == above)) emit(pieces_[i].facet, below, above);
        }
    }

private:
    /// A part of the sub-hyperplane, and the branches of the two subtrees in whose closed cells it lies.
    struct Piece {
        Facet facet;
        std::size_t children;
        Branch below;
        Branch above;
    };

    void descend(std::size_t i) {
        for (;;) {
            const bool low = pieces_[i].below.is_node();
            const Branch at = low ? pieces_[i].below : pieces_[i].above;
            if (at.is_leaf()) return;
            Split<Facet> s = model_.split(tree_.cut(at), pieces_[i].facet);
            // The cut runs through the open cell on one side of the piece's plane: it is not that plane.
            CLEAVE_CHECK_CONTRACT("requirement", s.side != FacetSide::on_same && s.side != FacetSide::on_opposite);
            if (s.side != FacetSide::crossing) {
                const ChildSide side = s.side == FacetSide::minus ? ChildSide::minus : ChildSide::plus;
                (low ? pieces_[i].below : pieces_[i].above) = tree_.child(at, side);
                continue;
            }
            Piece minus{*std::move(s.minus), 0, pieces_[i].below, pieces_[i].above};
            Piece plus{*std::move(s.plus), 0, pieces_[i].below, pieces_[i].above};
            (low ? minus.below : minus.above) = tree_.minus(at);
            (low ? plus.below : plus.above) = tree_.plus(at);
            pieces_[i].children = pieces_.size();
            pieces_.push_back(std::move(minus));
            pieces_.push_back(std::move(plus));
            return;
        }
    }

    void merge_back() {
        for (std::size_t i = pieces_.size(); i-- > 0;) {
            const std::size_t c = pieces_[i].children;
            if (c == 0) continue;
            const Piece& a = pieces_[c];
            const Piece& b = pieces_[c + 1];
            if (a.children != 0 || b.children != 0) continue;
            if (!(tree_.label(a.below) == tree_.label(b.below)) || !(tree_.label(a.above) == tree_.label(b.above)))
                continue;
            pieces_[i].below = a.below;
            pieces_[i].above = a.above;
            pieces_[i].children = 0;
        }
    }

    M& model_;
    const Tree& tree_;
    std::vector<Piece> pieces_;
    std::vector<std::size_t> open_;
};

}  // namespace detail

/// Calls `emit(facet, label below, label above)` for the pieces of cuts that separate different labels. A facet faces
/// as its node's cut does; below is its minus side. Pieces do not overlap, and together are the boundary between
/// labels. Requires: no cell is empty. Cost: each sub-hyperplane is split by the cuts of both subtrees that meet it.
template <CellClip M, std::equality_comparable Label, class Emit>
void for_each_boundary_piece(M& model, const PlaneTree<typename M::plane_type, Label>& tree, Emit&& emit) {
    detail::LidClassifier<M, Label> classifier(model, tree);
    for_each_cell(model, tree, [&](Branch b, const auto&, const auto& split) {
        if (b.is_node()) classifier.run(*split.lid, tree.minus(b), tree.plus(b), emit);
    });
}

/// The boundary of a set as outward facets.
template <CellClip M>
[[nodiscard]] std::vector<typename M::facet_type> boundary(M& model, const PlaneTree<typename M::plane_type>& tree) {
    std::vector<typename M::facet_type> facets;
    for_each_boundary_piece(model, tree, [&](const typename M::facet_type& f, bool below, bool) {
        facets.push_back(below ? f : model.flip(f));
    });
    return facets;
}

CLEAVE_END_NAMESPACE

#endif
