// SPDX-License-Identifier: Apache-2.0
// Building trees by size and pivot, and sending points down them. Before it is timed each tree is checked: sound links,
// every facet in its cut and cell, the right label on both of its sides.
//
// Counters: facets; nodes; depth and mean_depth of the leaves; splits (facet pieces beyond the input's).
#include <cleave/bsp.hpp>
#include <cleave/clip/clip_model.hpp>
#include <cleave/number/integer.hpp>

#include "../tests/support/convex_body.hpp"
#include "../tests/support/toy_space.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cleave;

/// A grid of side^3 cells, each with its set bit or not: as jagged as a set can be.
struct ToyNoise {
    using Model = toy::Space<3>;
    Model clip;
    std::vector<toy::Facet<3>> facets;

    explicit ToyNoise(std::int64_t side) {
        toy::Grid<3> grid(side);
        std::mt19937_64 engine(1);
        for (std::int64_t x = 0; x < side; ++x) {
            for (std::int64_t y = 0; y < side; ++y) {
                for (std::int64_t z = 0; z < side; ++z) {
                    if ((engine() & 1U) != 0) grid.fill({x, y, z}, {x + 1, y + 1, z + 1});
                }
            }
        }
        facets = grid.boundary();
    }
};

/// n intervals on a line.
struct ToyComb {
    using Model = toy::Space<1>;
    Model clip;
    std::vector<toy::Facet<1>> facets;

    explicit ToyComb(std::int64_t n) : facets(toy::comb(static_cast<std::size_t>(n))) {}
};

/// 8 m^2 facets exactly on a sphere, over the indexed kernel.
struct KernelSphere {
    using Model = TurningKernelClip;
    Kernel<3> kernel;
    Model clip{kernel};
    std::vector<KernelFacet<3>> facets;

    explicit KernelSphere(std::int64_t m) : facets(body_facets(sphere_body(m), clip)) {}
};

/// The same over the value types of a user's number.
struct IntegerSphere {
    using Model = ClipModel<3, Integer>;
    Model clip;
    std::vector<Facet<3, Integer>> facets;

    explicit IntegerSphere(std::int64_t m) : facets(body_facets<Integer>(sphere_body(m))) {}
};

template <class Scene, class Pivot>
void build_tree(benchmark::State& state) {
    {
        Scene scene(state.range(0));
        const std::size_t n = scene.facets.size();
        const auto t = build_with_facets(scene.clip, std::move(scene.facets), Pivot{});
        if (!check_structure(t.tree).empty() || !check_facets(scene.clip, t).empty()) {
            state.SkipWithError("the tree is wrong");
            return;
        }
        const TreeStatistics s = statistics(t.tree);
        state.counters["facets"] = static_cast<double>(n);
        state.counters["nodes"] = static_cast<double>(s.nodes);
        state.counters["depth"] = static_cast<double>(s.depth);
        state.counters["mean_depth"] = s.average_depth();
        state.counters["splits"] = static_cast<double>(t.facets.all().size() - n);
    }
    for (auto _ : state) {
        state.PauseTiming();
        Scene scene(state.range(0));  // a model may keep what it has made, so each tree starts with its own
        state.ResumeTiming();
        benchmark::DoNotOptimize(build(scene.clip, std::move(scene.facets), Pivot{}));
    }
}

/// Points on and about the unit sphere against the tree of 8 m^2 facets.
template <class Pivot>
void locate_points(benchmark::State& state) {
    KernelSphere scene(state.range(0));
    const ConvexBody body = sphere_body(state.range(0));
    const auto tree = build(scene.clip, scene.facets, Pivot{});
    std::vector<PointId> points;
    std::mt19937_64 engine(1);
    const auto at = [&](const std::array<std::int64_t, 4>& v, std::int64_t factor) {
        return scene.kernel.add_point(
            {Integer(factor * v[0]), Integer(factor * v[1]), Integer(factor * v[2]), Integer(1000 * v[3])});
    };
    for (std::size_t i = 0; i < 1024; ++i) {
        const std::array<std::int64_t, 4>& v = body.points[engine() % body.points.size()];
        const Location expected = std::array{Location::inside, Location::boundary, Location::outside}[i % 3];
        points.push_back(at(v, std::array<std::int64_t, 3>{990, 1000, 1001}[i % 3]));
        if (classify(scene.clip, tree, points.back()) != expected) {
            state.SkipWithError("a point is misplaced");
            return;
        }
    }
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(classify(scene.clip, tree, points[i]));
        i = (i + 1) % points.size();
    }
    state.counters["depth"] = static_cast<double>(statistics(tree).depth);
}

/// Sizes up to `limit`, fewer in a smoke test.
template <std::int64_t... Sizes>
void sizes(benchmark::internal::Benchmark* b) {
    const bool smoke = std::getenv("CLEAVE_SMOKE") != nullptr;
    bool first = true;
    for (const std::int64_t size : {Sizes...}) {
        if (first || !smoke) b->Arg(size);
        first = false;
    }
    b->Unit(benchmark::kMillisecond);
}

// Lists: n facet planes above each other, n^2 / 2 side tests.
BENCHMARK(build_tree<KernelSphere, FirstFacet>)->Apply(sizes<5, 11, 16>);
BENCHMARK(build_tree<KernelSphere, FewestSplits>)->Apply(sizes<5, 11, 16>);
BENCHMARK(build_tree<KernelSphere, Balanced>)->Apply(sizes<5, 11, 16>);
// Structural cuts: 200, 968, 2,048, 5,000 and 20,000 facets.
BENCHMARK(build_tree<KernelSphere, Structural<>>)->Apply(sizes<5, 11, 16, 25, 50>);
BENCHMARK(build_tree<IntegerSphere, Structural<>>)->Apply(sizes<5, 11, 16>);

BENCHMARK(build_tree<ToyNoise, FirstFacet>)->Apply(sizes<8, 16>);
BENCHMARK(build_tree<ToyNoise, FewestSplits>)->Apply(sizes<8, 16>);
BENCHMARK(build_tree<ToyNoise, Balanced>)->Apply(sizes<8, 16>);
BENCHMARK(build_tree<ToyNoise, Structural<>>)->Apply(sizes<8, 16, 32>);

BENCHMARK(build_tree<ToyComb, FirstFacet>)->Apply(sizes<1000>);
BENCHMARK(build_tree<ToyComb, Balanced>)->Apply(sizes<1000, 10000, 100000>);
BENCHMARK(build_tree<ToyComb, Structural<>>)->Apply(sizes<1000, 10000, 100000>);

BENCHMARK(locate_points<FirstFacet>)->Apply(sizes<5, 16>)->Unit(benchmark::kMicrosecond);
BENCHMARK(locate_points<Structural<>>)->Apply(sizes<5, 16, 50>)->Unit(benchmark::kMicrosecond);

}  // namespace
