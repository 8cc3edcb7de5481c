// SPDX-License-Identifier: Apache-2.0
// The Parma Polyhedra Library's powersets of polyhedra beside cleave: the union of ten integer boxes minus that of ten
// others, in D = 2 to 5, both from finished operands. The answers are checked: cleave's measure is the number of unit
// cells counted on the grid, and the two results agree at the centres of a thousand cells. `ratio` is PPL's time over
// cleave's, medians of interleaved runs.
#include <cleave/query/measure.hpp>
#include <cleave/setop/apply.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <vector>

#include "boxes.hpp"

#include <ppl.hh>

namespace {

namespace ppl = Parma_Polyhedra_Library;
using Powerset = ppl::Pointset_Powerset<ppl::C_Polyhedron>;
using Clock = std::chrono::steady_clock;

template <int D>
Powerset powerset(const std::vector<boxes::IntegerBox<D>>& list) {
    constexpr ppl::dimension_type dimension = D;
    Powerset set(dimension, ppl::EMPTY);
    for (const boxes::IntegerBox<D>& b : list) {
        ppl::C_Polyhedron p(dimension, ppl::UNIVERSE);
        for (std::size_t i = 0; i < std::size_t(D); ++i) {
            p.add_constraint(ppl::Variable(i) >= b.lo[i]);
            p.add_constraint(ppl::Variable(i) <= b.hi[i]);
        }
        set.add_disjunct(p);
    }
    return set;
}

template <int D>
bool contains_centre(const Powerset& set, const std::array<int, std::size_t(D)>& cell) {
    ppl::Linear_Expression twice;
    for (std::size_t i = 0; i < std::size_t(D); ++i) twice += (2 * cell[i] + 1) * ppl::Variable(i);
    const ppl::Generator centre = ppl::point(twice, 2);
    return std::any_of(set.begin(), set.end(), [&](const auto& disjunct) {
        return disjunct.pointset().relation_with(centre).implies(ppl::Poly_Gen_Relation::subsumes());
    });
}

double median(std::vector<double> x) {
    std::nth_element(x.begin(), x.begin() + std::ptrdiff_t(x.size() / 2), x.end());
    return x[x.size() / 2];
}

template <int D>
void difference(benchmark::State& state) {
    const auto a_boxes = boxes::random<D>(1, 10);
    const auto b_boxes = boxes::random<D>(2, 10);
    const cleave::Region<D> a = boxes::sum<D>(a_boxes);
    const cleave::Region<D> b = boxes::sum<D>(b_boxes);
    const Powerset p = powerset<D>(a_boxes);
    const Powerset q = powerset<D>(b_boxes);
    std::vector<double> ours;
    std::vector<double> theirs;
    cleave::Region<D> result;
    Powerset other = p;
    for (auto _ : state) {
        auto start = Clock::now();
        result = apply(cleave::Operation::difference, a, b);
        ours.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        start = Clock::now();
        other = p;
        other.difference_assign(q);
        theirs.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        state.SetIterationTime(ours.back());
    }
    if (*measure(result) != boxes::cells_of_difference<D>(a_boxes, b_boxes)) {
        state.SkipWithError("the measure is not the number of cells");
        return;
    }
    std::mt19937 draw(3);
    for (int n = 0; n < 1000; ++n) {
        std::array<int, std::size_t(D)> cell{};
        for (int& x : cell) x = int(draw() % unsigned(boxes::extent));
        const auto in = [&](const auto& list) {
            return std::any_of(list.begin(), list.end(), [&](const auto& box) { return box.contains(cell); });
        };
        if (contains_centre<D>(other, cell) != (in(a_boxes) && !in(b_boxes))) {
            state.SkipWithError("PPL's set is another one");
            return;
        }
    }
    state.counters["ppl_ms"] = 1e3 * median(theirs);
    state.counters["cleave_ms"] = 1e3 * median(ours);
    state.counters["ratio"] = median(theirs) / median(ours);
    state.counters["pieces"] = double(result.boundary().faces.loop_first.size() - 1);
    state.counters["disjuncts"] = double(other.size());
}

BENCHMARK(difference<2>)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(difference<3>)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(difference<4>)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3);

void difference_in_five(benchmark::State& state) {
    difference<5>(state);
}

}  // namespace

int main(int argc, char** argv) {
    // PPL needs seconds in five dimensions: not in an instant's run.
    const char* smoke = std::getenv("CLEAVE_SMOKE");
    if (smoke == nullptr || *smoke == '\0')
        benchmark::RegisterBenchmark("difference<5>", difference_in_five)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(3);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
