// SPDX-License-Identifier: Apache-2.0
/// Set operations by merging trees, in every dimension: each operand's facets make a tree, the trees are merged one
/// after the other, and the boundary is read off the result.
#ifndef CLEAVE_SETOP_TREE_EVALUATION_HPP
#define CLEAVE_SETOP_TREE_EVALUATION_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/bsp/build.hpp>
#include <cleave/bsp/collapse.hpp>
#include <cleave/bsp/complement.hpp>
#include <cleave/bsp/merge.hpp>
#include <cleave/bsp/tree_boundary.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/region/facets.hpp>
#include <cleave/region/far_point.hpp>
#include <cleave/region/polytope_faces.hpp>
#include <cleave/setop/options.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The tree of a boundary, in a kernel.
template <int D>
[[nodiscard]] PlaneTree<PlaneId> tree_of_boundary(const Boundary<D>& boundary, Kernel<D>& kernel) {
    if constexpr (D <= 3) {
        KernelClip<D> clip(kernel);
        PointInterner<D> points(kernel);
        LoadedFacets<D> loaded = make_facets(boundary, load(boundary, kernel), clip, points);
        return build(clip, std::move(loaded.facets), Structural<>{}, boundary.value_at_infinity);
    } else {
        PolytopeClip<D> clip(kernel);
        LoadedPolytopes<D> loaded = load_polytopes(boundary, clip);
        return build(clip, std::move(loaded.facets), Structural<>{}, boundary.value_at_infinity);
    }
}

/// One evaluation by merging.
template <int D>
class TreeEvaluation {
public:
    using Bits = BooleanFunction::Bits;

    TreeEvaluation(std::span<const Boundary<D>* const> operands, const BooleanFunction& function,
                   const OperationOptions& options)
        : clip_(kernel_), points_(kernel_), options_(&options) {
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
        assemble();
        if (options.progress != nullptr) options.progress->finish();
    }

    /// The merged tree, its planes those of `kernel()`.
    [[nodiscard]] const PlaneTree<PlaneId>& tree() const noexcept { return tree_; }
    [[nodiscard]] Kernel<D>& kernel() noexcept { return kernel_; }

    Boundary<D> finish() {
        Boundary<D> result = freeze(kernel_, out_, value_at_far_point(kernel_.planes, tree_), points_);
        if (options_->counts != nullptr) options_->counts->kernel = kernel_.counts();
        return result;
    }

private:
    PlaneTree<PlaneId> merge_all(const std::vector<PlaneTree<PlaneId>>& trees, const BooleanFunction& function) {
        if (options_->progress != nullptr) {
            std::size_t total = 0;
            for (const auto& t : trees) total += t.node_count();
            options_->progress->begin("merge", total);
        }
        if (trees.size() == 1) return relabel(trees[0], [&](bool a) { return function(a ? 1 : 0); });
        if (trees.size() == 2) {
            // The larger one goes first: what the other does not touch of it is copied.
            const bool swapped = trees[0].node_count() < trees[1].node_count();
            const BooleanRule rule([&](bool a, bool b) {
                return function((a ? (swapped ? 2U : 1U) : 0U) | (b ? (swapped ? 1U : 2U) : 0U));
            });
            return counted(merge(clip_, trees[swapped ? 1 : 0], trees[swapped ? 0 : 1], rule, options_->progress));
        }
        PlaneTree<PlaneId, Bits> sum(Bits(0));
        for (std::size_t i = 0; i < trees.size(); ++i)
            sum = collapse(merge(
                clip_, sum, trees[i], [i](Bits bits, bool b) { return bits | Bits(b ? 1 : 0) << i; },
                options_->progress));
        return counted(relabel(std::move(sum), [&](Bits bits) { return function(bits); }));
    }

    PlaneTree<PlaneId> counted(PlaneTree<PlaneId> tree) {
        if (options_->counts != nullptr) options_->counts->merged_nodes = tree.node_count();
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

    void assemble() {
        std::vector<PolytopeFacet<D>> facets = boundary(clip_, tree_);
        const auto key = [&](const PolytopeFacet<D>& f) {
            const Source s = sources_[unoriented(f.plane)];
            return std::array<std::uint32_t, 3>{s.operand, s.face, f.plane};
        };
        std::stable_sort(facets.begin(), facets.end(),
                         [&](const PolytopeFacet<D>& a, const PolytopeFacet<D>& b) { return key(a) < key(b); });
        std::vector<Corner> loop;
        for (std::size_t i = 0; i < facets.size();) {
            const PlaneId plane = facets[i].plane;
            const Source source = sources_[unoriented(plane)];
            FaceMerger<D> merger(kernel_, points_);
            merger.begin(plane);
            for (; i < facets.size() && facets[i].plane == plane; ++i) {
                loop.clear();
                append_loop(kernel_, plane, clip_.body(facets[i]), loop);
                merger.add(loop);
            }
            merger.finish(out_, source);
        }
    }

    Kernel<D> kernel_;
    PolytopeClip<D> clip_;
    PointInterner<D> points_;
    const OperationOptions* options_;
    std::vector<Source> sources_;
    PlaneTree<PlaneId> tree_;
    FaceList out_;
};

CLEAVE_END_NAMESPACE

#endif
