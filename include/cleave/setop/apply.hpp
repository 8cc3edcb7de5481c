// SPDX-License-Identifier: Apache-2.0
/// Set operations on regions: any Boolean function of up to 64 operands, and the four binary operations, by the engine
/// that is best for most. setop/engines.hpp has the same with a choice of engine, at the price of compiling all of
/// them.
#ifndef CLEAVE_SETOP_APPLY_HPP
#define CLEAVE_SETOP_APPLY_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/region/conforming.hpp>
#include <cleave/region/region.hpp>
#include <cleave/setop/filter_evaluation.hpp>
#include <cleave/setop/options.hpp>
#include <cleave/setop/planar_evaluation.hpp>
#include <cleave/setop/surface_evaluation.hpp>

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The localised engine's result, or nullopt where it is not made for the operands: where one is unbounded, or
/// intersects itself.
template <class N>
[[nodiscard]] std::optional<Boundary<3>> evaluate_on_surfaces(const BooleanFunction& function,
                                                              std::span<const Region<3, N>> operands,
                                                              const OperationOptions& options) {
    std::vector<const Boundary<3>*> boundaries;
    std::vector<Boundary<3>> conforming;
    conforming.reserve(operands.size());
    for (const Region<3, N>& r : operands) {
        const Boundary<3>* b = &r.surface();
        if (!b->is_finite) return std::nullopt;
        if (!b->is_conforming) b = &conforming.emplace_back(make_conforming(r.boundary()));
        boundaries.push_back(b);
    }
    if (!SurfaceEvaluation::is_for(boundaries)) return std::nullopt;
    SurfaceEvaluation evaluation(boundaries, function, options);
    if (!evaluation.is_sound()) return std::nullopt;
    return evaluation.finish();
}

/// The value of a Boolean function of regions: the regular set whose interior points are those at which `function`
/// is 1. Requires: as many operands as the function's arity (1 to 64). Each output face's source names its operand and
/// face. Throws: Cancelled where progress was asked to stop; operands are untouched. Cost: for bounded boundaries in
/// 2-D and 3-D linear in their sizes and n log n in what meets, see docs/explanation/localised.md; else see
/// docs/explanation/boundary_filtering.md.
template <int D, class N>
[[nodiscard]] Region<D, N> evaluate(const BooleanFunction& function, std::span<const Region<D, N>> operands,
                                    const OperationOptions& options = {}) {
    CLEAVE_REQUIRES(operands.size() == function.arity());
    std::vector<const Boundary<D>*> boundaries;
    if (options.counts != nullptr) *options.counts = {};
    if constexpr (D == 3) {
        if (std::optional<Boundary<3>> r = evaluate_on_surfaces<N>(function, operands, options))
            return Region<D, N>(std::move(*r));
    }
    for (const Region<D, N>& r : operands) boundaries.push_back(&r.boundary());
    if constexpr (D == 2) {
        if (PlanarEvaluation::is_for(boundaries)) {
            PlanarEvaluation evaluation(boundaries, function, options);
            if (evaluation.is_sound()) return Region<D, N>(evaluation.finish());
        }
    }
    return Region<D, N>(FilterEvaluation<D>(boundaries, function, options).finish());
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
