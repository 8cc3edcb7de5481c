// SPDX-License-Identifier: Apache-2.0
// Set operations by shape and size. Every answer is checked: |A| + |B| = |A or B| + |A and B| modulo 2^61-1, and in 3-D
// the exported mesh is closed. Names without an engine are the default, localised; `_filter` is boundary filtering on
// the same operands. Counters, each per operation: pairs of faces tested, faces crossed;
// nodes, splits and located pieces of the trees; filter failures and exact points of the kernel.
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/region/make.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "solids.hpp"

namespace {

using namespace cleave;

template <int D>
struct Pair {
    Region<D> a, b;
};

template <int D>
bool right(const Pair<D>& p, Engine engine) {
    const Region<D> any = apply(engine, Operation::union_, p.a, p.b);
    const Region<D> both = apply(engine, Operation::intersection, p.a, p.b);
    if (!(*measure_modulo(p.a) + *measure_modulo(p.b) == *measure_modulo(any) + *measure_modulo(both))) return false;
    if constexpr (D == 3) return validate(to_mesh(any)).is_closed();
    return true;
}

template <int D>
void operate(benchmark::State& state, const Pair<D>& pair, Operation operation, Engine engine = Engine::automatic) {
    if (!right(pair, engine)) {
        state.SkipWithError("the measures do not add up or the result is not closed");
        return;
    }
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    std::size_t faces = 0;
    for (auto _ : state) {
        const Region<D> r = apply(engine, operation, pair.a, pair.b, options);
        faces = r.face_count();
        benchmark::DoNotOptimize(faces);
    }
    state.counters["faces"] = double(faces);
    state.counters["pairs"] = double(counts.face_pairs);
    state.counters["crossed"] = double(counts.faces_crossed);
    state.counters["nodes"] = double(counts.trees.nodes);
    state.counters["splits"] = double(counts.trees.facet_splits + counts.trees.piece_splits);
    state.counters["located"] = double(counts.trees.located);
    state.counters["sides"] = double(counts.kernel.sides);
    state.counters["failures"] = double(counts.kernel.filter_failures);
    state.counters["exact_points"] = double(counts.kernel.exact_points);
}

void cubes(benchmark::State& state, Engine engine) {
    operate<3>(state, {to_region(solids::cube(0, 0, 0, 1)), to_region(solids::cube(0.3, 0.4, 0.5, 1))},
               Operation::union_, engine);
}

void cubes_identical(benchmark::State& state) {
    const Region<3> cube = to_region(solids::cube(0, 0, 0, 1));
    operate<3>(state, {cube, cube}, Operation::union_);
}

void spheres(benchmark::State& state, Engine engine) {
    const auto rings = static_cast<unsigned>(state.range(0));
    operate<3>(state, {to_region(solids::sphere(rings, 0)), to_region(solids::sphere(rings, 0.5))}, Operation::union_,
               engine);
}

void spheres_rotated(benchmark::State& state, Engine engine) {
    const Mesh sphere = solids::sphere(static_cast<unsigned>(state.range(0)), 0);
    operate<3>(state, {to_region(sphere), to_region(solids::rotated(sphere))}, Operation::union_, engine);
}

/// n spheres of 1,224 triangles with centres in a box of side 8.
std::vector<Region<3>> cloud(long n) {
    std::mt19937 random(1);
    const Mesh sphere = solids::sphere(18, 0);
    std::vector<Region<3>> all;
    for (long i = 0; i < n; ++i) {
        Mesh moved = sphere;
        std::array<double, 3> centre{};
        for (double& x : centre) x = 8 * double(random()) / 4294967296.0;
        for (auto& p : moved.points)
            for (std::size_t x = 0; x < 3; ++x) p[x] += centre[x];
        all.push_back(to_region(moved));
    }
    return all;
}

Region<3> united_at_once(const std::vector<Region<3>>& parts) {
    Expression<3> all(parts.front());
    for (std::size_t i = 1; i < parts.size(); ++i) all |= parts[i];
    return evaluate(all);
}

Region<3> united_one_by_one(const std::vector<Region<3>>& parts) {
    Region<3> all = parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) all = all | parts[i];
    return all;
}

/// A union of many spheres in one evaluation, or each with the union of those before it.
void spheres_union(benchmark::State& state, Region<3> (*unite)(const std::vector<Region<3>>&)) {
    const std::vector<Region<3>> parts = cloud(state.range(0));
    const Region<3> a = united_at_once(parts);
    const Region<3> b = united_one_by_one(parts);
    if (!(*measure_modulo(a) == *measure_modulo(b)) || !validate(to_mesh(a)).is_closed()) {
        state.SkipWithError("the two unions differ or are not closed");
        return;
    }
    for (auto _ : state) benchmark::DoNotOptimize(unite(parts).face_count());
    state.counters["faces"] = double(a.face_count());
}

void model_rotated(benchmark::State& state, const char* name, Engine engine) {
    const std::optional<Mesh> mesh = solids::model(name);
    if (!mesh) {
        state.SkipWithError("CLEAVE_MODELS_DIR has no such model");
        return;
    }
    operate<3>(state, {to_region(*mesh), to_region(solids::rotated(*mesh))}, Operation::union_, engine);
}

/// A polygon of n corners at two distances in turn from a centre, rounded to doubles.
Region<2> star(long n, double x, double inner, double turned) {
    const double pi = 3.14159265358979323846;
    std::vector<std::array<double, 2>> loop;
    for (long i = 0; i < n; ++i) {
        const double angle = 2 * pi * (double(i) + turned) / double(n);
        const double r = i % 2 == 0 ? 1 : inner;
        loop.push_back({x + r * std::cos(angle), r * std::sin(angle)});
    }
    return Region<2>(polygon<double>(loop));
}

void squares(benchmark::State& state, Engine engine) {
    operate<2>(state, {box<2>({0, 0}, {2, 2}), box<2>({1, 1}, {3, 3})}, Operation::union_, engine);
}

/// Two circles that cross in two points.
void circles(benchmark::State& state, Engine engine) {
    const long n = state.range(0);
    operate<2>(state, {star(n, 0, 1, 0), star(n, 0.5, 1, 0.3)}, Operation::union_, engine);
}

/// Two stars with one centre: every spike crosses two, and the boxes of nearly all in one quarter meet.
void stars(benchmark::State& state, Engine engine) {
    const long n = state.range(0);
    operate<2>(state, {star(n, 0, 0.5, 0), star(n, 0, 0.5, 0.6)}, Operation::union_, engine);
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
BENCHMARK_CAPTURE(spheres_union, at_once, united_at_once)->Arg(smoke ? 8 : 200)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spheres_union, one_by_one, united_one_by_one)->Arg(smoke ? 8 : 200)->Unit(benchmark::kMillisecond);
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
        add("squares", squares)->Unit(benchmark::kMicrosecond);
        add("circles", circles)->Arg(1000)->Arg(smoke ? 1000 : 10'000)->Unit(benchmark::kMillisecond);
        add("stars", stars)->Arg(1000)->Arg(smoke ? 1000 : 10'000)->Unit(benchmark::kMillisecond);
        if (smoke) continue;
        add("spot_6k_rotated", model_rotated, "spot_6k")->Unit(benchmark::kMillisecond);
        add("rocker_arm_20k_rotated", model_rotated, "rocker_arm_20k")->Unit(benchmark::kMillisecond);
    }
    return true;
}();

}  // namespace
