// SPDX-License-Identifier: Apache-2.0
// The side test and the two constructions, by number type: input points against planes through input points, and meets
// of three such planes against a fourth. Coordinates are random integers of 26 bits, so planes have up to 80 bits and
// the exact value of the second test up to 250. Each program first checks all signs against one reference number.
#include <cleave/geometry/cross_point.hpp>
#include <cleave/geometry/relation.hpp>
#include <cleave/geometry/side.hpp>
#include <cleave/number/builtin.hpp>
#include <cleave/number/fixed_int.hpp>
#if defined(CLEAVE_HAS_GMP)
#include <cleave/number/gmp.hpp>
#endif
#if defined(CLEAVE_HAS_BOOST)
#include <cleave/number/boost_cpp.hpp>
#endif

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using namespace cleave;

constexpr std::size_t count = 256;  // small enough to stay in the cache: the arithmetic is what is timed
constexpr int bits = 26;

template <ExactRing N>
struct Scene {
    std::vector<Point<3, N>> points;
    std::vector<Plane<3, N>> planes;
    std::vector<Point<3, N>> meets;  // meets[i] is on planes i, i + 1, i + 2
};

/// A quarter of the points are on the plane of the same index, as in real scenes: zeros are what filters cannot decide.
template <ExactRing N>
const Scene<N>& scene() {
    static const Scene<N> made = [] {
        std::mt19937_64 engine(1);
        const auto random_point = [&engine] {
            std::array<std::int64_t, 3> x;
            for (std::int64_t& c : x) c = static_cast<std::int64_t>(engine() >> (64 - bits - 1)) - (1 << bits);
            return make_point<N>(x);
        };
        Scene<N> s;
        while (s.planes.size() < count) {
            const Point<3, N> p = random_point();
            const auto h = join(p, random_point(), random_point());
            if (!h) continue;
            s.planes.push_back(*h);
            s.points.push_back(s.points.size() % 4 == 0 ? p : random_point());
        }
        for (std::size_t i = 0; i < count; ++i) {
            s.meets.push_back(*meet(s.planes[i], s.planes[(i + 1) % count], s.planes[(i + 2) % count]));
        }
        return s;
    }();
    return made;
}

template <ExactRing N>
bool agrees_with_reference(benchmark::State& state) {
    const Scene<N>& s = scene<N>();
    const Scene<Integer>& reference = scene<Integer>();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j : {i, (i + 7) % count}) {
            if (side(s.planes[j], s.points[i]) != side(reference.planes[j], reference.points[i]) ||
                side(s.planes[j], s.meets[i]) != side(reference.planes[j], reference.meets[i])) {
                state.SkipWithError("a sign differs from the reference");
                return false;
            }
        }
        if (side(s.planes[(i + 2) % count], s.meets[i]) != Sign::zero) {
            state.SkipWithError("a meet is not on its planes");
            return false;
        }
    }
    return true;
}

template <ExactRing N>
void side_of_input_point(benchmark::State& state) {
    if (!agrees_with_reference<N>(state)) return;
    const Scene<N>& s = scene<N>();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(side(s.planes[i], s.points[i]));
        i = (i + 1) % count;
    }
}

template <ExactRing N>
void side_of_meet(benchmark::State& state) {
    if (!agrees_with_reference<N>(state)) return;
    const Scene<N>& s = scene<N>();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(side(s.planes[(i + 7) % count], s.meets[i]));
        i = (i + 1) % count;
    }
}

template <ExactRing N>
void join_three_points(benchmark::State& state) {
    if (!agrees_with_reference<N>(state)) return;
    const Scene<N>& s = scene<N>();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(join(s.points[i], s.points[(i + 1) % count], s.points[(i + 2) % count]));
        i = (i + 1) % count;
    }
}

template <ExactRing N>
void meet_three_planes(benchmark::State& state) {
    if (!agrees_with_reference<N>(state)) return;
    const Scene<N>& s = scene<N>();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(meet(s.planes[i], s.planes[(i + 1) % count], s.planes[(i + 2) % count]));
        i = (i + 1) % count;
    }
}

template <ExactRing N>
void relation_of_planes(benchmark::State& state) {
    const Scene<N>& s = scene<N>();
    for (std::size_t i = 0; i < count; ++i) {
        if (relation(s.planes[i], flip(s.planes[i])) != PlaneRelation::opposite ||
            relation(s.planes[i], s.planes[(i + 1) % count]) != PlaneRelation::crossing) {
            state.SkipWithError("a relation is wrong");
            return;
        }
    }
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(relation(s.planes[i], s.planes[(i + 1) % count]));
        i = (i + 1) % count;
    }
}

}  // namespace

#define CLEAVE_BENCH_NUMBER(N)         \
    BENCHMARK(side_of_input_point<N>); \
    BENCHMARK(side_of_meet<N>);        \
    BENCHMARK(join_three_points<N>);   \
    BENCHMARK(meet_three_planes<N>);   \
    BENCHMARK(relation_of_planes<N>)

CLEAVE_BENCH_NUMBER(Integer);
CLEAVE_BENCH_NUMBER(FixedInt<384>);
#if defined(CLEAVE_HAS_GMP)
CLEAVE_BENCH_NUMBER(mpz_class);
CLEAVE_BENCH_NUMBER(mpq_class);
#endif
#if defined(CLEAVE_HAS_BOOST)
using boost::multiprecision::cpp_int;
CLEAVE_BENCH_NUMBER(cpp_int);
#endif
