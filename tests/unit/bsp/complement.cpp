// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/complement.hpp>

#include "support/catch.hpp"
#include "support/toy_generators.hpp"
#include "support/toy_space.hpp"
#include "support/toy_trees.hpp"

#include <cleave/bsp/build.hpp>
#include <cleave/bsp/invariant.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

using support::property;

TEST_CASE("complement: nothing and all of space change places") {
    CHECK(cleave::complement(toy::Tree<>(false)) == toy::Tree<>(true));
    CHECK(cleave::complement(toy::Tree<>(true)) == toy::Tree<>(false));
}

TEST_CASE("complement: inside and outside change places, the boundary stays, and twice is the identity") {
    property("in the plane", [](const toy::Grid<2>& grid) {
        toy::Space<2> space;
        const toy::Tree<> t = cleave::build(space, grid.boundary(), cleave::Balanced{}, grid.around());
        const toy::Tree<> c = cleave::complement(t);
        RC_ASSERT(toy::agrees(c, grid.complement()));
        RC_ASSERT(cleave::complement(c) == t);
        RC_ASSERT(c.node_count() == t.node_count());
    });
}

TEST_CASE("complement: with its facets it is the tree of the flipped boundary") {
    property("in the plane", [](const toy::Grid<2>& grid) {
        toy::Space<2> space;
        const auto t = cleave::build_with_facets(space, grid.boundary(), cleave::Structural<>{3, {}}, grid.around());
        const auto c = cleave::complement(space, t);
        RC_ASSERT(toy::agrees(c.tree, grid.complement()));
        RC_ASSERT(cleave::check_facets(space, c).empty());
        RC_ASSERT(c.facets.all().size() == t.facets.all().size());
        const auto back = cleave::complement(space, c);
        RC_ASSERT(back.tree == t.tree);
        RC_ASSERT(cleave::check_facets(space, back).empty());
    });
}

TEST_CASE("relabel: labels may change their type") {
    const toy::Plane h{0, 1, cleave::Sign::plus};
    const toy::Tree<int> t(h, toy::Tree<int>(7), toy::Tree<int>(-2));
    const toy::Tree<std::string> named = cleave::relabel(t, [](int x) { return std::to_string(x); });
    CHECK(named == toy::Tree<std::string>(h, toy::Tree<std::string>("7"), toy::Tree<std::string>("-2")));
    CHECK(cleave::relabel(named, &std::string::size) ==
          toy::Tree<std::size_t>(h, toy::Tree<std::size_t>(1), toy::Tree<std::size_t>(2)));
}

TEST_CASE("relabel: a Boolean function of bit sets is the operation on the sets") {
    property("for two sets of cells", [](const toy::Grid<2>& a, const toy::Grid<2>& b) {
        using Cell = std::array<toy::Integer, 2>;
        // One tree for both: bit 0 says inside a, bit 1 inside b.
        const toy::Tree<unsigned> both =
            toy::grid_tree<2>(a.size(), [&](const Cell& c) { return (a.cell(c) ? 1U : 0U) | (b.cell(c) ? 2U : 0U); });
        const auto expected = [&](auto&& of) {
            toy::Grid<2> grid(a.size(), of(a.around(), b.around()));
            for (toy::Integer x = 0; x < a.size(); ++x) {
                for (toy::Integer y = 0; y < a.size(); ++y) {
                    grid.fill({x, y}, {x + 1, y + 1}, of(a.cell({x, y}), b.cell({x, y})));
                }
            }
            return grid;
        };
        const auto evaluated = [&](auto&& of) {
            return cleave::relabel(both, [&](unsigned bits) { return bool(of((bits & 1U) != 0, (bits & 2U) != 0)); });
        };
        const auto difference = [](bool x, bool y) { return x && !y; };
        RC_ASSERT(toy::agrees(evaluated(std::logical_or<>{}), expected(std::logical_or<>{})));
        RC_ASSERT(toy::agrees(evaluated(std::logical_and<>{}), expected(std::logical_and<>{})));
        RC_ASSERT(toy::agrees(evaluated(difference), expected(difference)));
        RC_ASSERT(toy::agrees(evaluated(std::not_equal_to<>{}), expected(std::not_equal_to<>{})));
    });
}

TEST_CASE("complement: depth 100,000 is no obstacle") {
    const toy::Tree<> t = toy::chain(100'000, true);
    const toy::Tree<> c = cleave::complement(t);
    CHECK(c != t);
    CHECK(cleave::complement(c) == t);
}
