// SPDX-License-Identifier: Apache-2.0
// Cutting facets and faces, by number type and size, and the box hierarchy. Every timed result is checked once: parts
// are valid and their exact areas add up, pairs agree with a count of all pairs.
#include <cleave/clip/clip_model.hpp>
#include <cleave/clip/face.hpp>
#include <cleave/clip/make_facet.hpp>
#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/number/builtin.hpp>
#include <cleave/number/fixed_int.hpp>
#if defined(CLEAVE_HAS_GMP)
#include <cleave/number/gmp.hpp>
#endif

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace {

using namespace cleave;

/// Twice the area of a loop in the plane z = 0.
template <ExactRing N>
Rational area(const std::vector<FacetCorner<N>>& corners) {
    Rational sum(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point<3, N>& p = corners[i].point;
        const Point<3, N>& q = corners[i + 1 == corners.size() ? 0 : i + 1].point;
        sum +=
            determinant_of_two<Rational, Rational>(p.coordinate(0), p.coordinate(1), q.coordinate(0), q.coordinate(1));
    }
    return sum;
}

/// A convex polygon with 4 k corners in the plane z = 0.
template <ExactRing N>
std::vector<Point<3, N>> round_polygon(int k) {
    std::vector<Point<3, N>> points;
    int x = 0;
    int y = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
        for (int i = 0; i < k; ++i) {
            points.push_back(make_point<N>(x, y, 0));
            x += quarter == 0 ? k - i : quarter == 1 ? -i : quarter == 2 ? i - k : i;
            y += quarter == 0 ? i : quarter == 1 ? k - i : quarter == 2 ? -i : i - k;
        }
    }
    return points;
}

template <ExactRing N>
void split_polygon(benchmark::State& state) {
    const int k = static_cast<int>(state.range(0)) / 4;
    const Facet<3, N> f = *make_facet(round_polygon<N>(k));
    // All through the middle (k / 2, k^2 / 2).
    const std::vector<Plane<3, N>> cuts{make_plane<N>(2, 0, 0, -k), make_plane<N>(6, 10, 2, -k * (3 + 5 * k)),
                                        make_plane<N>(-2, 4, 14, k * (1 - 2 * k)), make_plane<N>(0, 2, 1, -k * k)};
    for (const Plane<3, N>& h : cuts) {
        const Split<Facet<3, N>> s = split(h, f);
        if (s.side != FacetSide::crossing || !is_valid(*s.minus) || !is_valid(*s.plus) ||
            Rational(area(s.minus->corners) + area(s.plus->corners)) != area(f.corners)) {
            state.SkipWithError("the parts are not the facet");
            return;
        }
    }
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(split(cuts[i], f));
        i = (i + 1) % cuts.size();
    }
}

/// The side test of a facet that is not crossed: most of what a tree asks for.
template <ExactRing N>
void side_of_polygon(benchmark::State& state) {
    const int k = static_cast<int>(state.range(0)) / 4;
    const Facet<3, N> f = *make_facet(round_polygon<N>(k));
    const Plane<3, N> h = make_plane<N>(1, 2, 3, -10 * k * k);
    if (side(h, f) != FacetSide::minus) {
        state.SkipWithError("the facet is inside");
        return;
    }
    for (auto _ : state) benchmark::DoNotOptimize(side(h, f));
}

using Loops = std::vector<std::vector<Point<3, Integer>>>;

void cut(benchmark::State& state, const Loops& loops) {
    const Face<3, Integer> face =
        make_face(make_plane<Integer>(0, 0, 1, 0), std::span<const std::vector<Point<3, Integer>>>(loops));
    Rational whole(0);
    std::size_t corners = 0;
    for (const auto& loop : face.loops) {
        whole += area(loop);
        corners += loop.size();
    }
    const std::vector<Facet<3, Integer>> facets = to_facets(face);
    Rational sum(0);
    for (const auto& f : facets) sum += area(f.corners);
    if (sum != whole) {
        state.SkipWithError("the facets are not the face");
        return;
    }
    for (auto _ : state) benchmark::DoNotOptimize(to_facets(face));
    state.counters["corners"] = static_cast<double>(corners);
    state.counters["facets"] = static_cast<double>(facets.size());
}

void cut_convex_face(benchmark::State& state) {
    cut(state, {round_polygon<Integer>(static_cast<int>(state.range(0)) / 4)});
}

/// A square with n by n square holes.
void cut_face_with_holes(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const auto rectangle = [](int x, int y, int size, bool hole) {
        std::vector<Point<3, Integer>> p{make_point<Integer>(x, y, 0), make_point<Integer>(x + size, y, 0),
                                         make_point<Integer>(x + size, y + size, 0),
                                         make_point<Integer>(x, y + size, 0)};
        if (hole) std::swap(p[1], p[3]);
        return p;
    };
    Loops loops{rectangle(0, 0, 3 * n + 1, false)};
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) loops.push_back(rectangle(3 * i + 1, 3 * j + 1, 2, true));
    }
    cut(state, loops);
}

/// A star with n points: every second corner is reflex, and no two edges are parallel.
void cut_star(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const std::vector<Point<3, Integer>> outline = round_polygon<Integer>(n / 2);  // 2 n corners
    const Integer cx(n / 2);                                                       // twice the centre
    const Integer cy(n / 2 * (n / 2));
    std::vector<Point<3, Integer>> star;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        // Every second corner moves half the way to the centre.
        const Point<3, Integer>& p = outline[i];
        star.push_back(i % 2 == 0 ? make_point<Integer>(p[0] * Integer(2), p[1] * Integer(2), 0)
                                  : make_point<Integer>(p[0] + cx, p[1] + cy, 0));
    }
    cut(state, {star});
}

/// Pairs of n + n random boxes, about one partner each.
void meeting_pairs(benchmark::State& state) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::mt19937_64 engine(1);
    const double size = std::cbrt(1.0 / static_cast<double>(n)) / 2;
    const auto unit = [&engine] { return static_cast<double>(engine() >> 11U) * 0x1p-53; };
    std::array<std::vector<Box<3>>, 2> boxes;
    for (auto& some : boxes) {
        for (std::size_t i = 0; i < n; ++i) {
            const std::array<double, 3> lo{unit(), unit(), unit()};
            some.emplace_back(lo, std::array<double, 3>{lo[0] + size, lo[1] + size, lo[2] + size});
        }
    }
    const auto count_pairs = [&boxes] {
        std::size_t count = 0;
        BoxHierarchy<3>::for_each_meeting_pair(BoxHierarchy<3>(boxes[0]), BoxHierarchy<3>(boxes[1]),
                                               [&count](std::size_t, std::size_t) { ++count; });
        return count;
    };
    if (n <= 1000) {
        std::size_t expected = 0;
        for (const Box<3>& a : boxes[0]) {
            for (const Box<3>& b : boxes[1]) expected += disjoint(a, b) ? 0U : 1U;
        }
        if (count_pairs() != expected) {
            state.SkipWithError("pairs are missing or double");
            return;
        }
    }
    std::size_t pairs = 0;
    for (auto _ : state) pairs = count_pairs();
    state.counters["pairs"] = static_cast<double>(pairs);
}

}  // namespace

#define CLEAVE_BENCH_NUMBER(N)                      \
    BENCHMARK(side_of_polygon<N>)->Arg(4)->Arg(64); \
    BENCHMARK(split_polygon<N>)->Arg(4)->Arg(16)->Arg(64)

CLEAVE_BENCH_NUMBER(Integer);
CLEAVE_BENCH_NUMBER(FixedInt<384>);
#if defined(CLEAVE_HAS_GMP)
CLEAVE_BENCH_NUMBER(mpz_class);
CLEAVE_BENCH_NUMBER(mpq_class);
#endif
BENCHMARK(cut_convex_face)->Arg(16)->Arg(1024);
BENCHMARK(cut_face_with_holes)->Arg(1)->Arg(4)->Arg(16);
BENCHMARK(cut_star)->Arg(8)->Arg(64)->Arg(512)->Unit(benchmark::kMicrosecond);
BENCHMARK(meeting_pairs)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);
