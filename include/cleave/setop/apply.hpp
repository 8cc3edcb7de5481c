// SPDX-License-Identifier: Apache-2.0
/// Set operations on regions: any Boolean function of up to 64 operands, and the four binary operations.
#ifndef CLEAVE_SETOP_APPLY_HPP
#define CLEAVE_SETOP_APPLY_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/region/facets.hpp>
#include <cleave/region/region.hpp>
#include <cleave/setop/boundary_filter.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// How an operation is evaluated. All engines give the same set.
enum class Engine : std::uint8_t {
    automatic,        ///< the fastest that can
    boundary_filter,  ///< facets through the others' lazily built trees
};

/// What an operation had to do, for benchmarks and tests.
struct OperationCounts {
    KernelCounts kernel;
    LazyTreeCounts trees;
    std::size_t facets = 0;        ///< convex facets of all operands
    std::size_t faces_whole = 0;   ///< faces of the result that came back as they went in
    std::size_t faces_merged = 0;  ///< faces of the result put together from pieces
};

/// Options of an operation; the default is right for nearly everyone.
struct OperationOptions {
    Engine engine = Engine::automatic;
    ProgressReporter* progress = nullptr;  ///< told about stages; may cancel, which throws Cancelled
    OperationCounts* counts = nullptr;     ///< filled in if given
};

/// One evaluation by boundary filtering: loads the operands into a kernel, filters, and assembles faces.
template <int D>
class FilterEvaluation {
public:
    FilterEvaluation(std::span<const Boundary<D>* const> operands, const BooleanFunction& function,
                     const OperationOptions& options)
        : clip_(kernel_), points_(kernel_), merger_(kernel_, points_), options_(&options) {
        operands_.resize(operands.size());
        loads_.resize(operands.size());
        for (std::size_t i = 0; i < operands.size(); ++i) {
            loads_[i].boundary = operands[i];
            loads_[i].loaded = load(*operands[i], kernel_);
        }
        for (std::size_t i = 0; i < operands.size(); ++i) {
            LoadedFacets<D> facets = make_facets(*operands[i], loads_[i].loaded, clip_, points_);
            loads_[i].face = std::move(facets.face);
            operands_[i] = {std::move(facets.facets), operands[i]->value_at_infinity};
        }
        BoundaryFilter<KernelClip<D>> filter(clip_, operands_, function);
        filter.run([&](std::size_t operand, std::size_t facet, Action action, const KernelFacet<D>& piece,
                       bool whole) { collect(operand, facet, action, piece, whole); },
                   options.progress);
        flush();
        value_at_infinity_ = filter.value_at_infinity();
        if (options.counts != nullptr) {
            options.counts->trees = filter.counts();
            for (const auto& o : operands_) options.counts->facets += o.facets.size();
        }
    }

    Boundary<D> finish() {
        Boundary<D> result = freeze(kernel_, out_, value_at_infinity_, points_);
        if (options_->counts != nullptr) options_->counts->kernel = kernel_.counts();
        return result;
    }

private:
    struct Load {
        const Boundary<D>* boundary = nullptr;
        LoadedBoundary<D> loaded;
        std::vector<std::uint32_t> face;  // of each facet
    };

    struct Piece {
        KernelFacet<D> facet;
        Action action;
    };

    /// Pieces come in order of operand and facet; those of one face are gathered before they are assembled.
    void collect(std::size_t operand, std::size_t facet, Action action, const KernelFacet<D>& piece, bool whole) {
        const std::uint32_t face = loads_[operand].face[facet];
        if (operand != operand_ || face != face_) {
            flush();
            operand_ = operand;
            face_ = face;
        }
        pieces_.push_back({piece, action});
        kept_whole_ += whole && action == Action::keep ? 1U : 0U;
        flipped_whole_ += whole && action == Action::flip ? 1U : 0U;
    }

    void flush() {
        if (pieces_.empty()) return;
        const FaceList::Face& face = loads_[operand_].boundary->faces.faces[face_];
        const Source source{static_cast<std::uint32_t>(operand_), face_};
        const std::size_t all = facets_of_face();
        if (kept_whole_ == all || flipped_whole_ == all) {
            copy_face(face, flipped_whole_ == all, source);
        } else {
            merge(face, Action::keep, source);
            merge(face, Action::flip, source);
        }
        pieces_.clear();
        kept_whole_ = 0;
        flipped_whole_ = 0;
    }

    [[nodiscard]] std::size_t facets_of_face() const {
        const auto& faces = loads_[operand_].face;
        const auto range = std::equal_range(faces.begin(), faces.end(), face_);
        return std::size_t(range.second - range.first);
    }

    void copy_face(const FaceList::Face& face, bool flip, Source source) {
        if (options_->counts != nullptr) ++options_->counts->faces_whole;
        const Load& load = loads_[operand_];
        const PlaneId plane = load.loaded.plane(face.plane);
        out_.begin_face(flip ? flipped(plane) : plane, source);
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            loop_.clear();
            for (const Corner& c : load.boundary->faces.loop(l)) loop_.push_back(load.loaded.corner(c));
            if (flip) KernelClip<D>::reverse_corners(loop_);
            out_.add_loop(loop_);
        }
    }

    void merge(const FaceList::Face& face, Action action, Source source) {
        const PlaneId plane = loads_[operand_].loaded.plane(face.plane);
        merger_.begin(action == Action::flip ? flipped(plane) : plane);
        bool any = false;
        for (const Piece& p : pieces_) {
            if (p.action != action) continue;
            any = true;
            const auto corners = clip_.corners(p.facet);
            loop_.assign(corners.begin(), corners.end());
            if (action == Action::flip) KernelClip<D>::reverse_corners(loop_);
            merger_.add(loop_);
        }
        if (!any) return;
        merger_.finish(out_, source);
        if (options_->counts != nullptr) ++options_->counts->faces_merged;
    }

    Kernel<D> kernel_;
    KernelClip<D> clip_;
    PointInterner<D> points_;
    FaceMerger<D> merger_;
    const OperationOptions* options_;
    std::vector<Load> loads_;
    std::vector<FilterOperand<KernelFacet<D>>> operands_;
    bool value_at_infinity_ = false;
    FaceList out_;
    std::size_t operand_ = 0;
    std::uint32_t face_ = no_id;
    std::vector<Piece> pieces_;
    std::size_t kept_whole_ = 0;
    std::size_t flipped_whole_ = 0;
    std::vector<Corner> loop_;
};

/// The value of a Boolean function of regions: the regular set whose interior points are those at which `function`
/// is 1. Requires: as many operands as the function's arity (1 to 64). Each output face's source names its operand and
/// face. Throws: Cancelled where progress was asked to stop; operands are untouched. Cost: see
/// docs/explanation/boundary_filtering.md.
template <int D, class N>
[[nodiscard]] Region<D, N> evaluate(const BooleanFunction& function, std::span<const Region<D, N>> operands,
                                    const OperationOptions& options = {}) {
    CLEAVE_REQUIRES(operands.size() == function.arity());
    std::vector<const Boundary<D>*> boundaries;
    for (const Region<D, N>& r : operands) boundaries.push_back(&r.boundary());
    if (options.counts != nullptr) *options.counts = {};
    FilterEvaluation<D> evaluation(boundaries, function, options);
    return Region<D, N>(evaluation.finish());
}

/// `op` of two regions.
template <int D, class N>
[[nodiscard]] Region<D, N> apply(Operation op, const Region<D, N>& a, const Region<D, N>& b,
                                 const OperationOptions& options = {}) {
    const std::array<Region<D, N>, 2> operands{a, b};
    return evaluate<D, N>(BooleanFunction::from(op, 2), operands, options);
}

CLEAVE_END_NAMESPACE

#endif
