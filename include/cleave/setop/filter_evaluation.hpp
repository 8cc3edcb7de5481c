// SPDX-License-Identifier: Apache-2.0
/// Boundary filtering from boundaries to a boundary, in D = 1, 2, 3 on the unrolled facets, above on polytopes.
#ifndef CLEAVE_SETOP_FILTER_EVALUATION_HPP
#define CLEAVE_SETOP_FILTER_EVALUATION_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/region/facets.hpp>
#include <cleave/region/polytope_faces.hpp>
#include <cleave/setop/boundary_filter.hpp>
#include <cleave/setop/options.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// One evaluation by boundary filtering: loads the operands into a kernel, filters, and assembles faces.
template <int D>
class FilterEvaluation {
public:
    FilterEvaluation(std::span<const Boundary<D>* const> operands, const BooleanFunction& function,
                     const OperationOptions& options)
        : clip_(kernel_), points_(kernel_), merger_(kernel_, points_), options_(options) {
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
        if (options_.counts != nullptr) options_.counts->kernel = kernel_.counts();
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
        if (options_.counts != nullptr) ++options_.counts->faces_whole;
        const Load& load = loads_[operand_];
        const PlaneId plane = load.loaded.plane(face.plane);
        out_.begin_face(flip ? flipped(plane) : plane, source);
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            loop_.clear();
            for (const Corner& c : load.boundary->faces.loop(l)) loop_.push_back(load.loaded.corner(c));
            if (flip) reverse_loop<D>(loop_);
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
            if (action == Action::flip) reverse_loop<D>(loop_);
            merger_.add(loop_);
        }
        if (!any) return;
        merger_.finish(out_, source);
        if (options_.counts != nullptr) ++options_.counts->faces_merged;
    }

    Kernel<D> kernel_;
    KernelClip<D> clip_;
    PointInterner<D> points_;
    FaceMerger<D> merger_;
    OperationOptions options_;
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

/// The same above D = 3: facets are convex polytopes, and a face of the result is the list of its pieces.
template <int D>
requires(D >= 4) class FilterEvaluation<D> {
public:
    FilterEvaluation(std::span<const Boundary<D>* const> operands, const BooleanFunction& function,
                     const OperationOptions& options)
        : clip_(kernel_), points_(kernel_), options_(options) {
        std::vector<FilterOperand<PolytopeFacet<D>>> facets;
        std::vector<std::vector<std::uint32_t>> face(operands.size());
        for (std::size_t i = 0; i < operands.size(); ++i) {
            LoadedPolytopes<D> loaded = load_polytopes(*operands[i], clip_);
            face[i] = std::move(loaded.face);
            facets.push_back({std::move(loaded.facets), operands[i]->value_at_infinity});
        }
        BoundaryFilter<PolytopeClip<D>> filter(clip_, facets, function);
        std::vector<Corner> loop;
        std::size_t operand = 0;
        std::uint32_t last = no_id;
        PlaneId plane = no_id;
        filter.run(
            [&](std::size_t i, std::size_t f, Action action, const PolytopeFacet<D>& piece, bool whole) {
                const PlaneId h = action == Action::flip ? flipped(piece.plane) : piece.plane;
                if (i != operand || face[i][f] != last || h != plane)
                    out_.begin_face(h, {static_cast<std::uint32_t>(i), face[i][f]});
                operand = i;
                last = face[i][f];
                plane = h;
                loop.clear();
                append_loop(kernel_, h, clip_.body(piece), loop);
                out_.add_loop(loop);
                if (options.counts != nullptr) ++(whole ? options.counts->faces_whole : options.counts->faces_merged);
            },
            options.progress);
        value_at_infinity_ = filter.value_at_infinity();
        if (options.counts != nullptr) {
            options.counts->trees = filter.counts();
            for (const auto& o : facets) options.counts->facets += o.facets.size();
        }
    }

    Boundary<D> finish() {
        Boundary<D> result = freeze(kernel_, out_, value_at_infinity_, points_);
        if (options_.counts != nullptr) options_.counts->kernel = kernel_.counts();
        return result;
    }

private:
    Kernel<D> kernel_;
    PolytopeClip<D> clip_;
    PointInterner<D> points_;
    OperationOptions options_;
    FaceList out_;
    bool value_at_infinity_ = false;
};

CLEAVE_END_NAMESPACE

#endif
