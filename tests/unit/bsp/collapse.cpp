// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/collapse.hpp>

#include "support/catch.hpp"
#include "support/toy_generators.hpp"
#include "support/toy_space.hpp"
#include "support/toy_trees.hpp"

#include <cleave/bsp/build.hpp>
#include <cleave/bsp/complement.hpp>
#include <cleave/bsp/invariant.hpp>
#include <cleave/bsp/statistics.hpp>

#include <array>
#include <cstddef>
#include <utility>

using support::property;

namespace {

using cleave::Sign;

const toy::Plane at_x0{0, 0, Sign::plus};
const toy::Plane at_x1{0, 1, Sign::plus};
const toy::Plane at_y0{1, 0, Sign::plus};
const toy::Plane at_y1{1, 1, Sign::plus};
const toy::Tree<> in(true);
const toy::Tree<> out(false);

/// Planes are different as soon as they are different objects.
struct NeverSame {
    bool operator()(const toy::Plane&, const toy::Plane&) const { return false; }
};

}  // namespace

TEST_CASE("collapse: two leaves with equal labels become one") {
    CHECK(cleave::collapse(toy::Tree<>(at_x0, in, in)) == in);
    CHECK(cleave::collapse(toy::Tree<>(at_x0, out, out)) == out);
    CHECK(cleave::collapse(toy::Tree<>(at_x0, in, out)) == toy::Tree<>(at_x0, in, out));
    CHECK(cleave::collapse(in) == in);
}

TEST_CASE("collapse: joined leaves can make the cut above superfluous") {
    const toy::Tree<> t(at_x0, toy::Tree<>(at_y0, toy::Tree<>(at_y1, in, in), in),
                        toy::Tree<>(at_x1, in, toy::Tree<>(at_y1, in, in)));
    CHECK(cleave::collapse(t) == in);
    CHECK(cleave::collapse(toy::Tree<>(at_x0, toy::Tree<>(at_y0, in, in), out)) == toy::Tree<>(at_x0, in, out));
}

TEST_CASE("collapse: two equal subtrees become one") {
    const toy::Tree<> slab(at_y0, out, toy::Tree<>(at_y1, in, out));
    CHECK(cleave::collapse(toy::Tree<>(at_x0, slab, slab)) == slab);
    // Equal only after each has been collapsed itself.
    const toy::Tree<> longer(at_y0, toy::Tree<>(at_x1, out, out), toy::Tree<>(at_y1, toy::Tree<>(at_x1, in, in), out));
    CHECK(cleave::collapse(toy::Tree<>(at_x0, slab, longer)) == slab);
    // Twice over.
    const toy::Tree<> doubled(at_x0, slab, slab);
    CHECK(cleave::collapse(toy::Tree<>(at_x1, doubled, longer)) == slab);
}

TEST_CASE("collapse: subtrees that differ in a cut, a label or their shape are kept") {
    const toy::Tree<> a(at_y0, in, out);
    const toy::Tree<> other_cut(at_y1, in, out);
    const toy::Tree<> other_label(at_y0, in, in);
    const toy::Tree<> mirrored(at_y0, out, in);
    const toy::Tree<> left_heavy(at_y0, toy::Tree<>(at_y1, in, out), in);
    const toy::Tree<> right_heavy(at_y0, in, toy::Tree<>(at_y1, out, in));
    CHECK(cleave::collapse(toy::Tree<>(at_x0, a, other_cut)) == toy::Tree<>(at_x0, a, other_cut));
    CHECK(cleave::collapse(toy::Tree<>(at_x0, a, other_label)) == toy::Tree<>(at_x0, a, in));
    CHECK(cleave::collapse(toy::Tree<>(at_x0, a, mirrored)) == toy::Tree<>(at_x0, a, mirrored));
    CHECK(cleave::collapse(toy::Tree<>(at_x0, left_heavy, right_heavy)) == toy::Tree<>(at_x0, left_heavy, right_heavy));
}

TEST_CASE("collapse: the caller decides which planes are the same") {
    const toy::Tree<> slab(at_y0, in, out);
    const toy::Tree<> t(at_x0, slab, slab);
    CHECK(cleave::collapse(t, NeverSame{}) == t);
    CHECK(cleave::collapse(toy::Tree<>(at_x0, in, in), NeverSame{}) == in);
    toy::Space<2> space;
    CHECK(cleave::collapse(t, [&](const toy::Plane& g, const toy::Plane& h) {
              return space.relation(g, h) == cleave::PlaneRelation::same;
          }) == slab);
}

TEST_CASE("collapse: it is no normal form, a cut that the trees below it need stays") {
    // [1,2] and [2,3]: the cut at 2 is not boundary, but its two sides are different trees.
    const toy::Plane at_least_1{0, 1, Sign::minus};
    const toy::Plane at_most_2{0, 2, Sign::plus};
    const toy::Plane at_most_3{0, 3, Sign::plus};
    const toy::Tree<> t(at_most_2, toy::Tree<>(at_least_1, in, out), toy::Tree<>(at_most_3, in, out));
    CHECK(cleave::collapse(t) == t);
}

TEST_CASE("collapse: a half-plane cut everywhere is one cut") {
    const auto below = [](const std::array<toy::Integer, 2>& c) { return c[1] < 3; };
    const toy::Tree<> t = toy::grid_tree<2>(6, below);
    CHECK(t.leaf_count() == 64);
    CHECK(cleave::collapse(t) == toy::Tree<>({1, 3, Sign::plus}, in, out));
    // With equal leaves alone the columns stay apart, each with its own cut.
    CHECK(cleave::collapse(t, NeverSame{}).leaf_count() == 4);
}

TEST_CASE("collapse: a set with its complement is all of space, one leaf") {
    property("in space", [](const toy::Grid<3>& grid) {
        const toy::Tree<> t = toy::grid_tree(grid);
        const toy::Tree<int> both = cleave::relabel(t, [](bool inside) { return inside ? 1 : 2; });
        RC_ASSERT(cleave::collapse(cleave::relabel(both, [](int bits) { return bits != 0; })) == in);
        RC_ASSERT(cleave::collapse(cleave::relabel(both, [](int bits) { return bits == 3; })) == out);
    });
}

TEST_CASE("collapse: the set stays, nothing is left to collapse, and the tree is sound") {
    const auto check = [](const auto& grid, const toy::Tree<>& t) {
        const toy::Tree<> c = cleave::collapse(t);
        RC_ASSERT(cleave::check_structure(c).empty());
        RC_ASSERT(c.leaf_count() <= t.leaf_count());
        RC_ASSERT(c.leaf_count() == c.node_count() + 1);
        RC_ASSERT(toy::agrees(c, grid));
        RC_ASSERT(cleave::collapse(c) == c);
        RC_ASSERT(c.is_single_leaf() == grid.boundary().empty());
    };
    property("on a line", [&](const toy::Grid<1>& grid) { check(grid, toy::grid_tree(grid)); });
    property("in the plane", [&](const toy::Grid<2>& grid) { check(grid, toy::grid_tree(grid)); });
    property("in space", [&](const toy::Grid<3>& grid) { check(grid, toy::grid_tree(grid)); });
    property("after building", [&](const toy::Grid<3>& grid) {
        toy::Space<3> space;
        check(grid, cleave::build(space, grid.boundary(), cleave::Structural<>{1, {}}, grid.around()));
    });
}

TEST_CASE("collapse: depth 100,000 is collapsed without recursion") {
    constexpr std::size_t depth = 100'000;
    const bool on_minus = GENERATE(true, false);
    const toy::Tree<> t = toy::chain(depth, on_minus);
    CHECK(cleave::collapse(t) == t);
    CHECK(cleave::collapse(cleave::relabel(t, [](bool) { return true; })) == in);
}

TEST_CASE("collapse: a complete tree of equal halves shrinks to one cut in n log n comparisons") {
    // Level k is cut by x_k everywhere, but only the last level matters.
    constexpr std::size_t levels = 12;
    cleave::TreeParts<int> parts;
    std::vector<cleave::Branch> row;
    for (std::size_t i = 0; i < std::size_t{1} << levels; ++i) row.push_back(parts.add_leaf(i % 2 == 0));
    for (std::size_t level = levels; level-- > 0;) {
        std::vector<cleave::Branch> above;
        for (std::size_t i = 0; i < row.size(); i += 2) {
            above.push_back(parts.add_node(static_cast<int>(level)));
            parts.nodes.back().minus = row[i];
            parts.nodes.back().plus = row[i + 1];
        }
        row = above;
    }
    parts.root = row.front();
    std::size_t comparisons = 0;
    const cleave::PlaneTree<int> c = cleave::collapse(cleave::PlaneTree<int>(std::move(parts)), [&](int a, int b) {
        ++comparisons;
        return a == b;
    });
    CHECK(c == cleave::PlaneTree<int>(static_cast<int>(levels) - 1, cleave::PlaneTree<int>(true),
                                      cleave::PlaneTree<int>(false)));
    CHECK(comparisons <= (std::size_t{1} << levels) * levels);
}
