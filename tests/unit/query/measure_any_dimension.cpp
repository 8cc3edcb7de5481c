// SPDX-License-Identifier: Apache-2.0
#include <cleave/query/measure.hpp>
//
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>

#include "support/catch.hpp"
#include "support/convex_sets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

template <int D>
using Corner = std::array<int, std::size_t(D)>;

template <int D>
Region<D> box_of(const Corner<D>& lo, const Corner<D>& hi) {
    std::array<Rational, std::size_t(D)> a;
    std::array<Rational, std::size_t(D)> b;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        a[i] = lo[i];
        b[i] = hi[i];
    }
    return box<D>(a, b);
}

/// The standard simplex of size s.
template <int D>
Region<D> corner_simplex(int s) {
    std::array<std::array<Rational, std::size_t(D)>, std::size_t(D) + 1> v;
    for (auto& p : v)
        for (Rational& x : p) x = 0;
    for (std::size_t i = 0; i < std::size_t(D); ++i) v[i + 1][i] = s;
    return simplex<D>(v);
}

template <int D>
void check_known() {
    Corner<D> flat;
    flat.fill(2);
    flat[1] = 0;
    CHECK(box_of<D>({}, flat).is_empty());
    Corner<D> ones;
    ones.fill(1);
    Corner<D> threes;
    threes.fill(3);
    int side = 1;
    int factorial = 1;
    for (int i = 0; i < D; ++i) {
        side *= 2;
        factorial *= i + 1;
    }
    const Region<D> b = box_of<D>(ones, threes);
    CHECK(measure(b) == side);
    CHECK(measure(corner_simplex<D>(1)) == Rational(1, factorial));
    CHECK(measure(corner_simplex<D>(2)) == Rational(side) / factorial);
    // Half of it is beyond x = 2.
    std::array<int, std::size_t(D) + 1> half{};
    half[0] = 1;
    half[std::size_t(D)] = -2;
    const Region<D> h = half_space(make_plane<Integer>(half));
    CHECK(measure(b & h) == side / 2);
    CHECK(measure(b - h) == side / 2);
    CHECK(!measure(h));
    CHECK(!measure(~b));
}

/// Boxes on the grid 0 .. 3: the measure is the number of cells.
template <int D>
void check_boxes(unsigned seed, int count) {
    Dice dice(seed);
    std::vector<std::array<Corner<D>, 2>> boxes;
    Region<D> sum = Region<D>::empty();
    for (int n = 0; n < count; ++n) {
        Corner<D> lo;
        Corner<D> hi;
        for (std::size_t i = 0; i < std::size_t(D); ++i) {
            lo[i] = dice.below(3);
            hi[i] = dice.between(lo[i] + 1, 3);
        }
        boxes.push_back({lo, hi});
        sum =
            apply(n % 2 == 0 ? Engine::boundary_filter : Engine::tree_merge, Operation::union_, sum, box_of<D>(lo, hi));
    }
    int cells = 0;
    Corner<D> at{};
    for (;;) {
        const bool in = std::any_of(boxes.begin(), boxes.end(), [&](const std::array<Corner<D>, 2>& b) {
            for (std::size_t i = 0; i < std::size_t(D); ++i)
                if (at[i] < b[0][i] || at[i] >= b[1][i]) return false;
            return true;
        });
        cells += in ? 1 : 0;
        std::size_t i = 0;
        while (i < std::size_t(D) && ++at[i] == 3) at[i++] = 0;
        if (i == std::size_t(D)) break;
    }
    CHECK(measure(sum) == cells);
}

}  // namespace

TEST_CASE("measure: boxes, simplices and half of them in D = 4, 5, 6") {
    check_known<4>();
    check_known<5>();
    check_known<6>();
}

TEST_CASE("measure: boxes on a grid in D = 4 and 5 have as many cells as can be counted") {
    for (unsigned seed = 0; seed < scaled(8); ++seed) check_boxes<4>(seed, 4);
    for (unsigned seed = 0; seed < scaled(2); ++seed) check_boxes<5>(seed, 3);
}
