// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/classify.hpp>

#include "support/catch.hpp"
#include "support/toy_generators.hpp"
#include "support/toy_space.hpp"
#include "support/toy_trees.hpp"

#include <cleave/bsp/build.hpp>
#include <cleave/bsp/pivot.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using support::property;

namespace {

using cleave::Branch;
using cleave::Location;
using cleave::Sign;
using cleave::Walk;

toy::Plane at_most(std::size_t axis, toy::Integer x) {
    return {axis, x, Sign::plus};
}
toy::Plane at_least(std::size_t axis, toy::Integer x) {
    return {axis, x, Sign::minus};
}
const toy::Tree<> in(true);
const toy::Tree<> out(false);

/// A point by its coordinates; halves are given by `twice`.
toy::Point<1> at(toy::Integer x) {
    return {2 * x};
}
toy::Point<2> at(toy::Integer x, toy::Integer y) {
    return {2 * x, 2 * y};
}

}  // namespace

TEST_CASE("classify: all of space and nothing have no boundary") {
    toy::Space<2> space;
    CHECK(cleave::classify(space, in, at(3, 4)) == Location::inside);
    CHECK(cleave::classify(space, out, at(3, 4)) == Location::outside);
}

TEST_CASE("classify: a half-line cut again") {
    // {x > -1} cut by {x < 9}.
    toy::Space<1> space;
    const toy::Tree<> t(at_least(0, -1), toy::Tree<>(at_most(0, 9), in, out), out);
    CHECK(cleave::classify(space, t, at(-2)) == Location::outside);
    CHECK(cleave::classify(space, t, at(-1)) == Location::boundary);
    CHECK(cleave::classify(space, t, at(0)) == Location::inside);
    CHECK(cleave::classify(space, t, at(9)) == Location::boundary);
    CHECK(cleave::classify(space, t, at(10)) == Location::outside);
}

TEST_CASE("classify: a point on a cut between two inside cells is inside") {
    // [1,2] and [2,3] share the point 2.
    toy::Space<1> space;
    const toy::Tree<> t(at_most(0, 2), toy::Tree<>(at_least(0, 1), in, out), toy::Tree<>(at_most(0, 3), in, out));
    CHECK(cleave::classify(space, t, at(2)) == Location::inside);
    CHECK(cleave::classify(space, t, at(1)) == Location::boundary);
    CHECK(cleave::classify(space, t, at(3)) == Location::boundary);
    CHECK(cleave::classify(space, t, {1}) == Location::outside);
    CHECK(cleave::classify(space, t, {7}) == Location::outside);
}

TEST_CASE("classify: cuts through the inside of a union are not its boundary") {
    // [0,2]^2 and [1,3]^2: the planes of their sides run through (1,1) and (2,2), which lie inside.
    toy::Grid<2> grid(4);
    grid.fill({0, 0}, {2, 2}).fill({1, 1}, {3, 3});
    toy::Space<2> space;
    const toy::Tree<> t = cleave::build(space, grid.boundary());
    CHECK(cleave::classify(space, t, at(1, 1)) == Location::inside);
    CHECK(cleave::classify(space, t, {3, 3}) == Location::inside);
    CHECK(cleave::classify(space, t, at(2, 2)) == Location::inside);
    CHECK(cleave::classify(space, t, at(1, 2)) == Location::boundary);
    CHECK(cleave::classify(space, t, at(2, 1)) == Location::boundary);
    CHECK(cleave::classify(space, t, at(0, 1)) == Location::boundary);
    CHECK(cleave::classify(space, t, at(0, 3)) == Location::outside);
}

TEST_CASE("classify: a square hole") {
    toy::Grid<2> grid(3);
    grid.fill({0, 0}, {3, 3}).fill({1, 1}, {2, 2}, false);
    toy::Space<2> space;
    const toy::Tree<> t = cleave::build(space, grid.boundary(), cleave::Balanced{});
    for (const toy::Point<2>& p :
         {at(1, 1), toy::Point<2>{3, 0}, toy::Point<2>{3, 2}, toy::Point<2>{3, 4}, toy::Point<2>{3, 6}, at(3, 3)}) {
        CHECK(cleave::classify(space, t, p) == Location::boundary);
    }
    CHECK(cleave::classify(space, t, {3, 3}) == Location::outside);
    CHECK(cleave::classify(space, t, {1, 1}) == Location::inside);
}

TEST_CASE("classify: every leaf that touches the point is reached, once and in order") {
    const toy::Tree<std::string> quadrants(
        at_most(0, 0),
        toy::Tree<std::string>(at_most(1, 0), toy::Tree<std::string>("sw"), toy::Tree<std::string>("nw")),
        toy::Tree<std::string>(at_most(1, 0), toy::Tree<std::string>("se"), toy::Tree<std::string>("ne")));
    toy::Space<2> space;
    const auto reached = [&](const toy::Point<2>& p) {
        std::string text;
        cleave::visit_leaves_at(space, quadrants, p, [&](Branch leaf) { text += quadrants.label(leaf) + " "; });
        return text;
    };
    CHECK(reached(at(0, 0)) == "sw nw se ne ");
    CHECK(reached(at(0, -1)) == "sw se ");
    CHECK(reached(at(1, 0)) == "se ne ");
    CHECK(reached(at(-1, 1)) == "nw ");
    std::size_t calls = 0;
    CHECK_FALSE(cleave::visit_leaves_at(space, quadrants, at(0, 0),
                                        [&](Branch) { return ++calls == 2 ? Walk::stop : Walk::proceed; }));
    CHECK(calls == 2);
}

TEST_CASE("classify: an empty cell misleads it, which is why trees must have none") {
    // Beyond x = 0, once more x < 0: the leaf `in` has an empty cell, and yet the point 0 reaches it.
    toy::Space<1> space;
    const toy::Tree<> t(at_most(0, 0), out, toy::Tree<>(at_most(0, 0), in, out));
    CHECK(cleave::classify(space, t, {-1}) == Location::outside);
    CHECK(cleave::classify(space, t, {1}) == Location::outside);
    CHECK(cleave::classify(space, t, {0}) == Location::boundary);  // of the empty set
}

TEST_CASE("classify: the flip of a cut with its children exchanged changes nothing") {
    property("on a grid", [](const toy::Grid<2>& grid) {
        toy::Space<2> space;
        const toy::Tree<> t = cleave::build(space, grid.boundary(), cleave::FewestSplits{}, grid.around());
        cleave::TreeParts<toy::Plane> parts = t.parts();
        for (cleave::TreeNode<toy::Plane>& n : parts.nodes) {
            n.cut = space.flip_plane(n.cut);
            std::swap(n.minus, n.plus);
        }
        RC_ASSERT(toy::agrees(toy::Tree<>(std::move(parts)), grid));
    });
}

TEST_CASE("classify: superfluous cuts everywhere change nothing") {
    property("on a line", [](const toy::Grid<1>& grid) { RC_ASSERT(toy::agrees(toy::grid_tree(grid), grid)); });
    property("in the plane", [](const toy::Grid<2>& grid) { RC_ASSERT(toy::agrees(toy::grid_tree(grid), grid)); });
    property("in space", [](const toy::Grid<3>& grid) { RC_ASSERT(toy::agrees(toy::grid_tree(grid), grid)); });
}

TEST_CASE("classify: depth 100,000 is descended without recursion") {
    constexpr std::size_t depth = 100'000;
    toy::Space<1> space;
    const bool on_minus = GENERATE(true, false);
    const toy::Tree<> t = toy::chain(depth, on_minus);
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, depth / 2, depth - 1}) {
        const auto x = static_cast<toy::Integer>(2 * k);
        CHECK(cleave::classify(space, t, {x - 1}) == (k % 2 == 1 ? Location::inside : Location::outside));
        CHECK(cleave::classify(space, t, {x}) == Location::boundary);
        CHECK(cleave::classify(space, t, {x + 1}) == (k % 2 == 0 ? Location::inside : Location::outside));
    }
}
