// SPDX-License-Identifier: Apache-2.0
// Set operations by shape and size. Every answer is checked: |A| + |B| = |A or B| + |A and B| modulo 2^61-1, and the
// exported mesh is closed. Names without an engine are the default, localised; `_filter` is boundary filtering on the
// same operands. Counters, each per operation: pairs of faces tested, faces crossed and faces left to filtering; nodes,
// splits and located pieces of the trees; filter failures and exact points of the kernel.
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "solids.hpp"

namespace {

using namespace cleave;

struct Pair {
    Region<3> a, b;
};

bool right(const Pair& p) {
    const Region<3> any = p.a | p.b;
    const bool volumes =
        *measure_modulo(p.a) + *measure_modulo(p.b) == *measure_modulo(any) + *measure_modulo(p.a & p.b);
    return volumes && validate(to_mesh(any)).is_closed();
}

void operate(benchmark::State& state, const Pair& pair, Operation operation, Engine engine = Engine::automatic) {
    if (!right(pair)) {
        state.SkipWithError("the volumes do not add up or the result is not closed");
        return;
    }
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    std::size_t faces = 0;
    for (auto _ : state) {
        const Region<3> r = apply(engine, operation, pair.a, pair.b, options);
        faces = r.face_count();
        benchmark::DoNotOptimize(faces);
    }
    state.counters["faces"] = double(faces);
    state.counters["pairs"] = double(counts.face_pairs);
    state.counters["crossed"] = double(counts.faces_crossed);
    state.counters["filtered"] = double(counts.faces_filtered);
    state.counters["nodes"] = double(counts.trees.nodes);
    state.counters["splits"] = double(counts.trees.facet_splits + counts.trees.piece_splits);
    state.counters["located"] = double(counts.trees.located);
    state.counters["sides"] = double(counts.kernel.sides);
    state.counters["failures"] = double(counts.kernel.filter_failures);
    state.counters["exact_points"] = double(counts.kernel.exact_points);
}

void cubes(benchmark::State& state, Engine engine) {
    operate(state, {to_region(solids::cube(0, 0, 0, 1)), to_region(solids::cube(0.3, 0.4, 0.5, 1))}, Operation::union_,
            engine);
}

void cubes_identical(benchmark::State& state) {
    const Region<3> cube = to_region(solids::cube(0, 0, 0, 1));
    operate(state, {cube, cube}, Operation::union_);
}

void spheres(benchmark::State& state, Engine engine) {
    const auto rings = static_cast<unsigned>(state.range(0));
    operate(state, {to_region(solids::sphere(rings, 0)), to_region(solids::sphere(rings, 0.5))}, Operation::union_,
            engine);
}

void spheres_rotated(benchmark::State& state, Engine engine) {
    const Mesh sphere = solids::sphere(static_cast<unsigned>(state.range(0)), 0);
    operate(state, {to_region(sphere), to_region(solids::rotated(sphere))}, Operation::union_, engine);
}

void model_rotated(benchmark::State& state, const char* name, Engine engine) {
    const std::optional<Mesh> mesh = solids::model(name);
    if (!mesh) {
        state.SkipWithError("CLEAVE_MODELS_DIR has no such model");
        return;
    }
    operate(state, {to_region(*mesh), to_region(solids::rotated(*mesh))}, Operation::union_, engine);
}

void prepare(benchmark::State& state) {
    const Mesh mesh = solids::sphere(static_cast<unsigned>(state.range(0)), 0);
    for (auto _ : state) {
        const Region<3> r = to_region(mesh);
        if (r.face_count() != mesh.face_count()) state.SkipWithError("faces were lost");
    }
    state.counters["faces"] = double(mesh.face_count());
}

const bool smoke = std::getenv("CLEAVE_SMOKE") != nullptr;
const long largest = smoke ? 8 : 71;

BENCHMARK(cubes_identical)->Unit(benchmark::kMicrosecond);
BENCHMARK(prepare)->Arg(8)->Arg(largest)->Unit(benchmark::kMillisecond);

const bool registered = [] {
    for (const Engine engine : {Engine::automatic, Engine::boundary_filter}) {
        const std::string suffix = engine == Engine::automatic ? "" : "_filter";
        const auto add = [&](const std::string& name, auto&&... arguments) {
            return benchmark::RegisterBenchmark((name + suffix).c_str(), arguments..., engine);
        };
        add("cubes", cubes)->Unit(benchmark::kMicrosecond);
        add("spheres", spheres)->Arg(8)->Arg(largest)->Unit(benchmark::kMillisecond);
        add("spheres_rotated", spheres_rotated)->Arg(8)->Arg(smoke ? 8 : 18)->Unit(benchmark::kMillisecond);
        if (smoke) continue;
        add("spot_6k_rotated", model_rotated, "spot_6k")->Unit(benchmark::kMillisecond);
        add("rocker_arm_20k_rotated", model_rotated, "rocker_arm_20k")->Unit(benchmark::kMillisecond);
    }
    return true;
}();

}  // namespace
