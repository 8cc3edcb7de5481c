// SPDX-License-Identifier: Apache-2.0
/// Boundary filtering: every operand's facets are pushed through the others' trees; the Boolean function keeps, flips
/// or drops each piece.
///
/// A piece of operand i knows, for each other operand j, whether the points just above and just below it belong to j:
/// outside 0/0, inside 1/1, on a boundary facing the same way 0/1, the opposite way 1/0. It belongs to the result's
/// boundary iff the function's value differs between its two sides, facing from value 1 to value 0. Coincident pieces
/// are emitted once, by the lowest operand. A split whose two halves meet the same fate is undone, so that what no
/// other operand touches comes back as it went in.
///
/// Thibault and Naylor 1987 for filtering; the four classes and the n-ary two-sided form replace their side test, which
/// is wrong for coincident faces.
#ifndef CLEAVE_SETOP_BOUNDARY_FILTER_HPP
#define CLEAVE_SETOP_BOUNDARY_FILTER_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/bsp/lazy_tree.hpp>
#include <cleave/execution/progress.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// What becomes of a piece of an operand's boundary.
enum class Action : std::uint8_t { drop, keep, flip };

/// One operand of a boundary filter: its facets, and whether points far away belong to it.
template <class Facet>
struct FilterOperand {
    std::vector<Facet> facets;
    bool value_at_infinity = false;
};

/// Evaluates a Boolean function of up to 64 operands on their boundaries, over any Clip model.
template <Clip M>
class BoundaryFilter {
public:
    using Facet = typename M::facet_type;
    using Bits = BooleanFunction::Bits;

    /// Requires: as many operands as the function's arity; each operand's facets are a closed outward boundary.
    BoundaryFilter(M& model, std::span<const FilterOperand<Facet>> operands, const BooleanFunction& function)
        : operands_(operands), function_(&function) {
        CLEAVE_REQUIRES(operands.size() == function.arity());
        trees_.reserve(operands.size());
        for (const FilterOperand<Facet>& o : operands) trees_.emplace_back(model, o.facets, o.value_at_infinity);
    }

    /// Whether points far away belong to the result.
    [[nodiscard]] bool value_at_infinity() const {
        Bits bits = 0;
        for (std::size_t i = 0; i < operands_.size(); ++i) bits |= Bits(operands_[i].value_at_infinity ? 1 : 0) << i;
        return (*function_)(bits);
    }

    /// Calls `sink(operand, facet index, action, piece, whole)` for every maximal piece that is not dropped, in order
    /// of operand and facet. `whole`: the piece is the facet itself. `flip` pieces are given unflipped.
    template <class Sink>
    void run(Sink&& sink, ProgressReporter* progress = nullptr) {
        std::size_t total = 0;
        for (const FilterOperand<Facet>& o : operands_) total += o.facets.size();
        if (progress != nullptr) progress->begin("filter", total);
        for (std::size_t i = 0; i < operands_.size(); ++i) {
            for (std::size_t f = 0; f < operands_[i].facets.size(); ++f) {
                if (progress != nullptr) progress->advance();
                filter_facet(i, f, sink);
            }
        }
        if (progress != nullptr) progress->finish();
    }

    /// The same for one facet.
    template <class Sink>
    void filter_facet(std::size_t operand, std::size_t facet, Sink&& sink) {
        filter(operand, operands_[operand].facets[facet]);
        emit(operand, facet, sink);
    }

    /// Whether a point on no facet of an operand belongs to it.
    template <class Point>
    [[nodiscard]] bool contains(std::size_t operand, const Point& p) requires LocatingClip<M> {
        return trees_[operand].contains(p);
    }

    /// Sums over all trees.
    [[nodiscard]] LazyTreeCounts counts() const {
        LazyTreeCounts sum;
        for (const LazyTree<M>& t : trees_) {
            sum.nodes += t.counts().nodes;
            sum.facet_splits += t.counts().facet_splits;
            sum.piece_splits += t.counts().piece_splits;
            sum.located += t.counts().located;
        }
        return sum;
    }

private:
    /// A piece with the operands known to hold just above and just below it. `dead`: another operand emits it.
    struct Leaf {
        std::uint32_t piece;
        Bits above;
        Bits below;
        bool dead;
    };

    void filter(std::size_t i, const Facet& facet) {
        pieces_.reset(facet);
        leaves_.assign(1, {0, 0, Bits(1) << i, false});
        for (std::size_t j = 0; j < trees_.size(); ++j) {
            if (j == i) continue;
            next_.clear();
            for (const Leaf& leaf : leaves_) {
                if (leaf.dead) {
                    next_.push_back(leaf);
                    continue;
                }
                trees_[j].classify(pieces_, leaf.piece);
                spread(leaf, j, j < i);
            }
            leaves_.swap(next_);
        }
        actions_.assign(pieces_.pieces.size(), Action::drop);
        for (const Leaf& leaf : leaves_) {
            if (leaf.dead) continue;
            const bool above = (*function_)(leaf.above);
            const bool below = (*function_)(leaf.below);
            if (above != below) actions_[leaf.piece] = below ? Action::keep : Action::flip;
        }
    }

    /// Replaces `leaf` by the leaves below it after classification against operand j.
    void spread(const Leaf& leaf, std::size_t j, bool j_emits_shared) {
        stack_.assign(1, leaf.piece);
        const Bits bit = Bits(1) << j;
        while (!stack_.empty()) {
            const std::uint32_t p = stack_.back();
            stack_.pop_back();
            const auto& piece = pieces_.pieces[p];
            if (piece.children != 0) {
                stack_.push_back(piece.children + 1);
                stack_.push_back(piece.children);
                continue;
            }
            Leaf l = leaf;
            l.piece = p;
            switch (piece.coverage) {
                case Coverage::outside:
                    break;
                case Coverage::inside:
                    l.above |= bit;
                    l.below |= bit;
                    break;
                case Coverage::same:
                    l.below |= bit;
                    l.dead = j_emits_shared;
                    break;
                case Coverage::opposite:
                    l.above |= bit;
                    l.dead = j_emits_shared;
                    break;
            }
            next_.push_back(l);
        }
    }

    template <class Sink>
    void emit(std::size_t i, std::size_t f, Sink&& sink) {
        const auto& pieces = pieces_.pieces;
        // Undo: children follow their parents, so a walk from the back meets them first. A mixed piece is marked drop
        // and its children are emitted; a uniform one takes its children's action.
        mixed_.assign(pieces.size(), false);
        for (std::size_t p = pieces.size(); p-- > 0;) {
            const std::uint32_t c = pieces[p].children;
            if (c == 0) continue;
            mixed_[p] = mixed_[c] || mixed_[c + 1] || actions_[c] != actions_[c + 1];
            actions_[p] = mixed_[p] ? Action::drop : actions_[c];
        }
        stack_.assign(1, 0);
        while (!stack_.empty()) {
            const std::uint32_t p = stack_.back();
            stack_.pop_back();
            if (mixed_[p]) {
                stack_.push_back(pieces[p].children + 1);
                stack_.push_back(pieces[p].children);
            } else if (actions_[p] != Action::drop) {
                sink(i, f, actions_[p], pieces[p].facet, p == 0);
            }
        }
    }

    std::span<const FilterOperand<Facet>> operands_;
    const BooleanFunction* function_;
    std::vector<LazyTree<M>> trees_;
    PieceTree<Facet> pieces_;
    std::vector<Leaf> leaves_, next_;
    std::vector<Action> actions_;
    std::vector<bool> mixed_;
    std::vector<std::uint32_t> stack_;
};

CLEAVE_END_NAMESPACE

#endif
