// SPDX-License-Identifier: Apache-2.0
/// Set operations by merging trees, in every dimension: each operand's facets make a tree, the trees are merged one
/// after the other, and the boundary is read off the result.
#ifndef CLEAVE_SETOP_TREE_EVALUATION_HPP
#define CLEAVE_SETOP_TREE_EVALUATION_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/bsp/collapse.hpp>
#include <cleave/bsp/complement.hpp>
#include <cleave/bsp/merge.hpp>
#include <cleave/region/tree.hpp>
#include <cleave/setop/options.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// One evaluation by merging.
template <int D>
class TreeEvaluation {
public:
    using Bits = BooleanFunction::Bits;

    TreeEvaluation(std::span<const Boundary<D>* const> operands, const BooleanFunction& function,
                   const OperationOptions& options)
        : clip_(kernel_), points_(kernel_), operands_(operands), options_(options) {
        std::vector<PlaneTree<PlaneId>> trees;
        if (options.progress != nullptr) options.progress->begin("trees", operands.size());
        for (const Boundary<D>* b : operands) {
            trees.push_back(tree_of_boundary(*b, kernel_));
            note_sources(*b, trees.size() - 1);
            if (options.counts != nullptr) options.counts->tree_nodes += trees.back().node_count();
            if (options.progress != nullptr) options.progress->advance();
        }
        tree_ = collapse(merge_all(trees, function));
        if (options.counts != nullptr) options.counts->result_nodes = tree_.node_count();
        if (options.progress != nullptr) options.progress->begin("boundary", tree_.node_count());
        out_ = faces_of_tree(clip_, points_, tree_, [&](std::uint32_t k) {
            return k < sources_.size() ? sources_[k] : Source{no_id, no_id};
        });
        if (options.progress != nullptr) options.progress->finish();
    }

    /// The merged tree, its planes those of `kernel()`.
    [[nodiscard]] const PlaneTree<PlaneId>& tree() const noexcept { return tree_; }
    [[nodiscard]] Kernel<D>& kernel() noexcept { return kernel_; }

    Boundary<D> finish() {
        Boundary<D> result = freeze(kernel_, out_, value_at_far_point(kernel_.planes, tree_), points_);
        if (options_.counts != nullptr) options_.counts->kernel = kernel_.counts();
        return result;
    }

private:
    PlaneTree<PlaneId> merge_all(const std::vector<PlaneTree<PlaneId>>& trees, const BooleanFunction& function) {
        if (options_.progress != nullptr) {
            std::size_t total = 0;
            for (const auto& t : trees) total += t.node_count();
            options_.progress->begin("merge", total);
        }
        if (trees.size() == 1) return relabel(trees[0], [&](bool a) { return function(a ? 1 : 0); });
        if (trees.size() == 2) {
            const BooleanRule in_order([&](bool a, bool b) { return function((a ? 1U : 0U) | (b ? 2U : 0U)); });
            if (const PlaneId h = separating_plane(); h != no_id) return counted(side_by_side(h, trees, in_order));
            // The larger one goes first: what the other does not touch of it is copied.
            const bool swapped = trees[0].node_count() < trees[1].node_count();
            const BooleanRule rule([&](bool a, bool b) {
                return function((a ? (swapped ? 2U : 1U) : 0U) | (b ? (swapped ? 1U : 2U) : 0U));
            });
            return counted(merge(clip_, trees[swapped ? 1 : 0], trees[swapped ? 0 : 1], rule, options_.progress));
        }
        PlaneTree<PlaneId, Bits> sum(Bits(0));
        for (std::size_t i = 0; i < trees.size(); ++i)
            sum = collapse(merge(
                clip_, sum, trees[i], [i](Bits bits, bool b) { return bits | Bits(b ? 1 : 0) << i; },
                options_.progress));
        return counted(relabel(std::move(sum), [&](Bits bits) { return function(bits); }));
    }

    /// A plane between the boxes of two operands, its minus side that of the first; `no_id` where they are not apart.
    PlaneId separating_plane() {
        const Bounds<D>& a = operands_[0]->bounds;
        const Bounds<D>& b = operands_[1]->bounds;
        for (const Boundary<D>* o : operands_) {
            if (o->faces.faces.empty()) return no_id;
            // A half-line's end is finite, but far from it the set is not the same on both sides.
            if (D == 1 && o->faces.faces.size() % 2 != 0) return no_id;
        }
        for (std::size_t i = 0; i < std::size_t(D); ++i)
            for (const bool a_first : {true, false}) {
                const double lo = a_first ? a.hi[i] : b.hi[i];
                const double hi = a_first ? b.lo[i] : a.lo[i];
                // Strictly between, so that it is no cut of either. Finite: boxes of unbounded sets are not apart.
                const double middle = lo + (hi - lo) / 2;
                if (!(lo < middle && middle < hi)) continue;
                const PlaneId h = kernel_.planes.intern_axis_plane(int(i), middle);
                return a_first ? h : flipped(h);
            }
        return no_id;
    }

    /// Operands on the two sides of a plane need no merging: on each side one of them is constant, and every cut of the
    /// other one's tree runs between or through facets on that side, so no cell becomes empty.
    PlaneTree<PlaneId> side_by_side(PlaneId h, const std::vector<PlaneTree<PlaneId>>& trees, const BooleanRule& rule) {
        const bool a = operands_[0]->value_at_infinity;
        const bool b = operands_[1]->value_at_infinity;
        return PlaneTree<PlaneId>(h, relabel(trees[0], [&](bool x) { return rule(x, b); }),
                                  relabel(trees[1], [&](bool x) { return rule(a, x); }));
    }

    PlaneTree<PlaneId> counted(PlaneTree<PlaneId> tree) {
        if (options_.counts != nullptr) options_.counts->merged_nodes = tree.node_count();
        return tree;
    }

    /// Each plane's first face among the operands: the source of a result's face on it.
    void note_sources(const Boundary<D>& b, std::size_t operand) {
        sources_.resize(kernel_.planes.size(), Source{no_id, no_id});
        for (std::size_t f = 0; f < b.faces.faces.size(); ++f) {
            const std::uint32_t k = kernel_.planes.intern_from(b.planes, unoriented(b.faces.faces[f].plane));
            if (sources_[k].operand == no_id)
                sources_[k] = {static_cast<std::uint32_t>(operand), static_cast<std::uint32_t>(f)};
        }
    }

    Kernel<D> kernel_;
    PolytopeClip<D> clip_;
    PointInterner<D> points_;
    std::span<const Boundary<D>* const> operands_;
    OperationOptions options_;
    std::vector<Source> sources_;
    PlaneTree<PlaneId> tree_;
    FaceList out_;
};

CLEAVE_END_NAMESPACE

#endif
