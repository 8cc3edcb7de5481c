// SPDX-License-Identifier: Apache-2.0
// Boundary filtering and tree merging on the same operands: meshes, and boxes in D = 2 to 5. Every answer is checked:
// the canonical forms of both engines' results are equal, and measures add up. Counters: nodes of the operands' trees,
// of the merged tree and of what collapsing and trimming leave of it.
#include <cleave/bsp/trim.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/shape/box.hpp>

#include <benchmark/benchmark.h>

#include "boxes.hpp"
#include "solids.hpp"

namespace {

using namespace cleave;

template <int D>
bool right(Operation operation, const Region<D>& a, const Region<D>& b) {
    const Region<D> r = apply(operation, a, b);
    return canonical(r) == canonical(apply(Engine::tree_merge, operation, a, b)) &&
           *measure_modulo(apply(Operation::difference, a, b)) +
                   *measure_modulo(apply(Operation::intersection, a, b)) ==
               *measure_modulo(a);
}

template <int D>
void operate(benchmark::State& state, Engine engine, Operation operation, const Region<D>& a, const Region<D>& b) {
    if (!right(operation, a, b)) {
        state.SkipWithError("the engines differ or the measures do not add up");
        return;
    }
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    for (auto _ : state) {
        const Region<D> r = apply(engine, operation, a, b, options);
        benchmark::DoNotOptimize(r.face_count());
    }
    state.counters["facets"] = double(counts.facets);
    state.counters["sides"] = double(counts.kernel.sides);
    state.counters["failures"] = double(counts.kernel.filter_failures);
    if (engine != Engine::tree_merge) return;
    Kernel<D> kernel;
    PolytopeClip<D> model(kernel);
    const PlaneTree<PlaneId> merged = collapse(merge(model, tree_of_boundary(a.boundary(), kernel),
                                                     tree_of_boundary(b.boundary(), kernel), BooleanRule(operation)));
    state.counters["nodes"] = double(counts.tree_nodes);
    state.counters["merged"] = double(counts.merged_nodes);
    state.counters["collapsed"] = double(counts.result_nodes);
    if (D <= 4 && merged.node_count() < 20000) state.counters["trimmed"] = double(trim(model, merged).node_count());
}

void spheres(benchmark::State& state, Engine engine) {
    const auto n = unsigned(state.range(0));
    const Region<3> a = to_region(solids::sphere(n, 0));
    const Region<3> b = to_region(solids::sphere(n, 0.3));
    operate(state, engine, Operation::union_, a, b);
}

/// Ten boxes minus ten others, corners at small integers.
template <int D, Engine engine>
void ten_boxes(benchmark::State& state) {
    const auto a_boxes = boxes::random<D>(1, 10);
    const auto b_boxes = boxes::random<D>(2, 10);
    const Region<D> a = boxes::sum<D>(a_boxes);
    const Region<D> b = boxes::sum<D>(b_boxes);
    if (*measure(apply(Operation::difference, a, b)) != boxes::cells_of_difference<D>(a_boxes, b_boxes)) {
        state.SkipWithError("the measure is not the number of cells");
        return;
    }
    operate(state, engine, Operation::difference, a, b);
}

BENCHMARK_CAPTURE(spheres, filter, Engine::boundary_filter)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spheres, merge, Engine::tree_merge)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(ten_boxes, 2, Engine::boundary_filter)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(ten_boxes, 2, Engine::tree_merge)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(ten_boxes, 3, Engine::boundary_filter)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(ten_boxes, 3, Engine::tree_merge)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(ten_boxes, 4, Engine::boundary_filter)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(ten_boxes, 4, Engine::tree_merge)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(ten_boxes, 5, Engine::boundary_filter)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(ten_boxes, 5, Engine::tree_merge)->Unit(benchmark::kMillisecond);

}  // namespace
