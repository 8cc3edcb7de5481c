// SPDX-License-Identifier: Apache-2.0
/// Set operations with a choice of engine.
#ifndef CLEAVE_SETOP_ENGINES_HPP
#define CLEAVE_SETOP_ENGINES_HPP

#include <cleave/setop/apply.hpp>
#include <cleave/setop/expression.hpp>
#include <cleave/setop/tree_evaluation.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// How an operation is evaluated. All engines give the same set.
enum class Engine : std::uint8_t {
    automatic,        ///< the fastest that can
    boundary_filter,  ///< facets through the others' lazily built trees
    tree_merge,       ///< trees of all operands, merged; slower, and independent of the other
    localised,        ///< only where operands meet; for bounded boundaries in 2-D and 3-D, `boundary_filter` elsewhere
};

/// All engines but `automatic`.
inline constexpr std::array<Engine, 3> all_engines = {Engine::boundary_filter, Engine::tree_merge, Engine::localised};

/// The value of a Boolean function of regions (see `evaluate` without an engine) by the engine that is named.
/// Sources: tree merging names for each face of the result the first operand's face on its plane.
template <int D, class N>
[[nodiscard]] Region<D, N> evaluate(Engine engine, const BooleanFunction& function,
                                    std::span<const Region<D, N>> operands, const OperationOptions& options = {}) {
    if (engine == Engine::automatic || engine == Engine::localised) return evaluate<D, N>(function, operands, options);
    CLEAVE_REQUIRES(operands.size() == function.arity());
    std::vector<const Boundary<D>*> boundaries;
    for (const Region<D, N>& r : operands) boundaries.push_back(&r.boundary());
    if (options.counts != nullptr) *options.counts = {};
    if (engine == Engine::tree_merge) return Region<D, N>(TreeEvaluation<D>(boundaries, function, options).finish());
    return Region<D, N>(FilterEvaluation<D>(boundaries, function, options).finish());
}

/// The value of an expression by the engine that is named.
template <int D, class N>
[[nodiscard]] Region<D, N> evaluate(Engine engine, const Expression<D, N>& expression,
                                    const OperationOptions& options = {}) {
    return expression.value([&](const BooleanFunction& function, std::span<const Region<D, N>> operands) {
        return evaluate<D, N>(engine, function, operands, options);
    });
}

/// `op` of two regions by the engine that is named.
template <int D, class N>
[[nodiscard]] Region<D, N> apply(Engine engine, Operation op, const Region<D, N>& a, const Region<D, N>& b,
                                 const OperationOptions& options = {}) {
    const std::array<Region<D, N>, 2> operands{a, b};
    return evaluate<D, N>(engine, BooleanFunction::from(op, 2), operands, options);
}

CLEAVE_END_NAMESPACE

#endif
