// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/lazy_tree.hpp>
//
#include "support/catch.hpp"
#include "support/toy_space.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

using namespace cleave;

namespace {

template <std::size_t D>
toy::Grid<D> random_grid(std::mt19937& random, bool around) {
    constexpr int size = D == 2 ? 6 : 4;
    toy::Grid<D> grid(size, around);
    std::uniform_int_distribution<int> position(0, size);
    std::uniform_int_distribution<int> boxes(0, 3);
    for (int n = boxes(random); n > 0; --n) {
        std::array<toy::Integer, D> low{};
        std::array<toy::Integer, D> high{};
        for (std::size_t i = 0; i < D; ++i) {
            const int a = position(random);
            const int b = position(random);
            low[i] = static_cast<toy::Integer>(a < b ? a : b);
            high[i] = static_cast<toy::Integer>(a < b ? b : a);
        }
        grid.fill(low, high, n % 2 == 1);
    }
    return grid;
}

/// What a unit square of the facet's plane is for `grid`: the labels of the cells above and below it.
template <std::size_t D>
Coverage expected(const toy::Grid<D>& grid, const toy::Facet<D>& f, std::array<toy::Integer, D> c) {
    std::array<toy::Integer, D> high = c;
    std::array<toy::Integer, D> low = c;
    high[f.plane.axis] = f.plane.at;
    low[f.plane.axis] = f.plane.at - 1;
    const bool up = f.plane.outside == Sign::plus;
    const bool above = grid.cell(up ? high : low);
    const bool below = grid.cell(up ? low : high);
    if (above == below) return above ? Coverage::inside : Coverage::outside;
    return below ? Coverage::same : Coverage::opposite;
}

/// Calls `look(unit cell of the facet)` for each of its unit squares.
template <std::size_t D, class Look>
void for_each_unit(const toy::Facet<D>& f, Look&& look) {
    std::array<toy::Integer, D> c = f.low;
    for (;;) {
        look(c);
        std::size_t i = 0;
        for (; i < D; ++i) {
            if (i == f.plane.axis) continue;
            if (++c[i] < f.high[i]) break;
            c[i] = f.low[i];
        }
        if (i == D) return;
    }
}

template <std::size_t D>
void check_against_grid(std::size_t rounds) {
    std::mt19937 random(11);
    std::array<std::size_t, 4> seen{};
    for (std::size_t round = 0; round < rounds; ++round) {
        const toy::Grid<D> a = random_grid<D>(random, false);
        const toy::Grid<D> b = random_grid<D>(random, round % 3 == 0);
        toy::Space<D> space;
        LazyTree<toy::Space<D>> tree(space, b.boundary(), b.around());
        PieceTree<toy::Facet<D>> pieces;
        for (const toy::Facet<D>& f : a.boundary()) {
            pieces.reset(f);
            tree.classify(pieces);
            std::size_t units = 0;
            for (const auto& piece : pieces.pieces) {
                if (piece.children != 0) continue;
                for_each_unit(piece.facet, [&](const std::array<toy::Integer, D>& c) {
                    ++units;
                    REQUIRE(piece.coverage == expected(b, f, c));
                    ++seen[std::size_t(piece.coverage)];
                });
            }
            std::size_t all = 0;
            for_each_unit(f, [&](const std::array<toy::Integer, D>&) { ++all; });
            REQUIRE(units == all);
        }
    }
    for (const std::size_t n : seen) CHECK(n >= scaled(20));  // every class occurs
}

}  // namespace

TEST_CASE("lazy tree: every piece of a facet has the coverage that the grid says, in the plane") {
    check_against_grid<2>(scaled(600));
}

TEST_CASE("lazy tree: every piece of a facet has the coverage that the grid says, in space") {
    check_against_grid<3>(scaled(300));
}

TEST_CASE("lazy tree: without facets it is empty or full") {
    toy::Space<2> space;
    LazyTree<toy::Space<2>> nothing(space, {}, false);
    LazyTree<toy::Space<2>> everything(space, {}, true);
    CHECK_FALSE(nothing.contains(toy::Point<2>{1, 1}));
    CHECK(everything.contains(toy::Point<2>{1, 1}));
}

TEST_CASE("lazy tree: only what is reached is built") {
    toy::Space<1> space;
    LazyTree<toy::Space<1>> tree(space, toy::comb(500), false);
    CHECK(tree.counts().nodes == 0);
    CHECK(tree.contains(toy::Point<1>{1}));  // the middle of [0, 1]
    const auto built = tree.counts().nodes;
    CHECK(built > 0);
    CHECK(built < 100);
}
