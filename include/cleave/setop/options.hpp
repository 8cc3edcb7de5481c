// SPDX-License-Identifier: Apache-2.0
/// Options of set operations, and what an operation tells about its work.
#ifndef CLEAVE_SETOP_OPTIONS_HPP
#define CLEAVE_SETOP_OPTIONS_HPP

#include <cleave/bsp/lazy_tree.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/geometry/kernel.hpp>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// What an operation had to do, for benchmarks and tests.
struct OperationCounts {
    KernelCounts kernel;
    LazyTreeCounts trees;
    std::size_t facets = 0;          ///< convex facets of all operands
    std::size_t faces_whole = 0;     ///< faces of the result that came back as they went in
    std::size_t faces_merged = 0;    ///< faces of the result put together from pieces
    std::size_t tree_nodes = 0;      ///< tree merge: nodes of the operands' trees
    std::size_t merged_nodes = 0;    ///< tree merge: nodes of the merged tree
    std::size_t result_nodes = 0;    ///< tree merge: what collapsing leaves of them
    std::size_t face_pairs = 0;      ///< localised: pairs of faces (2-D: segments) whose boxes meet
    std::size_t faces_crossed = 0;   ///< localised: faces that others touch
    std::size_t points_located = 0;  ///< localised: points whose operands no crossing told
};

/// Options of an operation; the default is right for nearly everyone.
struct OperationOptions {
    ProgressReporter* progress = nullptr;  ///< told about stages; may cancel, which throws Cancelled
    OperationCounts* counts = nullptr;     ///< filled in if given
    ExecutorRef executor{};                ///< where independent work runs; the result is the same for every executor
};

CLEAVE_END_NAMESPACE

#endif
