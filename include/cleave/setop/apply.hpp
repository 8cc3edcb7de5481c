// SPDX-License-Identifier: Apache-2.0
/// Set operations on regions: any Boolean function of up to 64 operands, and the four binary operations, by the engine
/// that is best for most. setop/engines.hpp has the same with a choice of engine, at the price of compiling all of
/// them.
#ifndef CLEAVE_SETOP_APPLY_HPP
#define CLEAVE_SETOP_APPLY_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/region/region.hpp>
#include <cleave/setop/filter_evaluation.hpp>
#include <cleave/setop/localised_evaluation.hpp>
#include <cleave/setop/options.hpp>
#include <cleave/setop/surface_evaluation.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The value of a Boolean function of regions: the regular set whose interior points are those at which `function`
/// is 1. Requires: as many operands as the function's arity (1 to 64). Each output face's source names its operand and
/// face. Throws: Cancelled where progress was asked to stop; operands are untouched. Cost: see
/// docs/explanation/boundary_filtering.md.
template <int D, class N>
[[nodiscard]] Region<D, N> evaluate(const BooleanFunction& function, std::span<const Region<D, N>> operands,
                                    const OperationOptions& options = {}) {
    CLEAVE_REQUIRES(operands.size() == function.arity());
    std::vector<const Boundary<D>*> boundaries;
    if (options.counts != nullptr) *options.counts = {};
    if constexpr (D == 3) {
        for (const Region<D, N>& r : operands) boundaries.push_back(&r.surface());
        bool sound = true;
        if (SurfaceEvaluation::is_for(boundaries)) {
            SurfaceEvaluation evaluation(boundaries, function, options);
            if (evaluation.is_sound()) return Region<D, N>(evaluation.finish());
            sound = false;
        }
        boundaries.clear();
        for (const Region<D, N>& r : operands) boundaries.push_back(&r.boundary());
        // Where an operand intersects itself, trees give some set whatever they are given.
        if (sound &&
            std::all_of(boundaries.begin(), boundaries.end(), [](const Boundary<D>* b) { return b->is_finite; }))
            return Region<D, N>(LocalisedEvaluation<D>(boundaries, function, options).finish());
    } else {
        for (const Region<D, N>& r : operands) boundaries.push_back(&r.boundary());
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
