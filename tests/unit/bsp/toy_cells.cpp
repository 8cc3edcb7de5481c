// SPDX-License-Identifier: Apache-2.0
// Merging, walking and restricting trees in the toy space, against the grid cell by cell: what these algorithms know of
// geometry is the concept of a cell, and nothing else.
#include "support/toy_cells.hpp"

#include "support/catch.hpp"
#include "support/toy_generators.hpp"
#include "support/toy_trees.hpp"

#include <cleave/bsp/build.hpp>
#include <cleave/bsp/cells.hpp>
#include <cleave/bsp/collapse.hpp>
#include <cleave/bsp/merge.hpp>
#include <cleave/bsp/tree_boundary.hpp>
#include <cleave/bsp/trim.hpp>

#include <array>
#include <cstddef>
#include <vector>

using namespace cleave;

namespace {

template <std::size_t D>
toy::Tree<> tree_of(const toy::Grid<D>& grid) {
    toy::CellSpace<D> space;
    return build(space, grid.boundary(), Structural<>{}, grid.around());
}

/// Calls f with the lowest corner of each cell of the grid and of a layer around it.
template <std::size_t D, class F>
void for_each_unit(toy::Integer size, F&& f) {
    std::array<toy::Integer, D> c;
    c.fill(-1);
    for (;;) {
        f(c);
        std::size_t i = 0;
        while (i < D && ++c[i] > size) c[i++] = -1;
        if (i == D) return;
    }
}

/// The operation, cell by cell.
template <std::size_t D>
toy::Grid<D> combined(Operation operation, const toy::Grid<D>& a, const toy::Grid<D>& b) {
    toy::Grid<D> out(a.size(), apply(operation, a.around(), b.around()));
    for_each_unit<D>(a.size(), [&](const std::array<toy::Integer, D>& c) {
        std::array<toy::Integer, D> high = c;
        for (toy::Integer& x : high) ++x;
        out.fill(c, high, apply(operation, a.cell(c), b.cell(c)));
    });
    return out;
}

/// The sum of the facets' sizes: the number of unit facets.
template <std::size_t D>
toy::Integer size_of(const std::vector<toy::Facet<D>>& facets) {
    toy::Integer sum = 0;
    for (const auto& f : facets) {
        toy::Integer product = 1;
        for (std::size_t i = 0; i < D; ++i) product *= i == f.plane.axis ? 1 : f.high[i] - f.low[i];
        sum += product;
    }
    return sum;
}

template <std::size_t D>
void check_merge(const toy::Grid<D>& a, const toy::Grid<D>& b, const toy::Tree<>& tree_a, const toy::Tree<>& tree_b) {
    toy::CellSpace<D> space;
    RC_ASSERT(has_no_empty_cell(space, tree_a));
    for (const Operation operation : all_operations) {
        const toy::Grid<D> expected = combined(operation, a, b);
        const toy::Tree<> merged = merge(space, tree_a, tree_b, BooleanRule(operation));
        RC_ASSERT(has_no_empty_cell(space, merged));
        RC_ASSERT(toy::agrees(merged, expected));
        const toy::Tree<> trimmed = trim(space, collapse(merged));
        RC_ASSERT(toy::agrees(trimmed, expected));
        // The boundary that is read off is all of it, once, and faces outward.
        RC_ASSERT(size_of<D>(boundary(space, merged)) == size_of<D>(expected.boundary()));
        RC_ASSERT(toy::agrees(build(space, boundary(space, trimmed), Structural<>{}, expected.around()), expected));
    }
}

template <std::size_t D>
bool is_within(const std::array<toy::Integer, D>& unit, const toy::Cell<D>& cell) {
    for (std::size_t i = 0; i < D; ++i)
        if (unit[i] < cell.low[i] || unit[i] + 1 > cell.high[i]) return false;
    return true;
}

/// The cells of the leaves divide space, and each has the colour of the units in it.
template <std::size_t D>
void check_cells(const toy::Grid<D>& grid, const toy::Tree<>& tree) {
    toy::CellSpace<D> space;
    std::vector<toy::Cell<D>> cells;
    std::vector<bool> labels;
    for_each_cell(space, tree, [&](Branch b, const toy::Cell<D>& cell, const auto& split) {
        if (b.is_leaf()) {
            cells.push_back(cell);
            labels.push_back(tree.label(b));
            return;
        }
        RC_ASSERT(space.side(tree.cut(b), *split.lid) == FacetSide::on_same);
        RC_ASSERT(space.cell_side(tree.cut(b), *split.minus) == FacetSide::minus);
        RC_ASSERT(space.cell_side(tree.cut(b), *split.plus) == FacetSide::plus);
    });
    RC_ASSERT(cells.size() == tree.leaf_count());
    for_each_unit<D>(grid.size(), [&](const std::array<toy::Integer, D>& c) {
        int found = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            if (!is_within<D>(c, cells[k])) continue;
            ++found;
            RC_ASSERT(labels[k] == grid.cell(c));
        }
        RC_ASSERT(found == 1);
    });
}

/// A tree with cells that are empty, and what is left of it in all of space and in each unit.
template <std::size_t D>
void check_restricted(const toy::Grid<D>& grid, const toy::Tree<>& tree) {
    toy::CellSpace<D> space;
    const toy::Plane middle{D - 1, grid.size() / 2, Sign::minus};
    const toy::Tree<> doubled(middle, tree, tree);
    const toy::Tree<> clean = restricted(space, doubled, space.universe());
    RC_ASSERT(has_no_empty_cell(space, clean));
    RC_ASSERT(clean.node_count() <= doubled.node_count());
    RC_ASSERT(toy::agrees(clean, grid));
    const auto parts = partition(space, tree, middle);
    RC_ASSERT(toy::Tree<>(middle, parts.minus, parts.plus) == clean);
    for_each_unit<D>(grid.size(), [&](const std::array<toy::Integer, D>& c) {
        toy::Cell<D> cell{c, c};
        for (toy::Integer& x : cell.high) ++x;
        RC_ASSERT(restricted(space, doubled, cell) == toy::Tree<>(grid.cell(c)));
    });
}

template <std::size_t D>
void check_all(std::size_t cases) {
    support::law("merge", cases, [](const toy::Grid<D>& a, const toy::Grid<D>& b) {
        check_merge(a, b, tree_of(a), tree_of(b));
        check_merge(a, b, toy::grid_tree(a), tree_of(b));
    });
    support::law("for_each_cell", cases, [](const toy::Grid<D>& a) {
        check_cells(a, tree_of(a));
        check_cells(a, toy::grid_tree(a));
    });
    support::law("restricted", cases, [](const toy::Grid<D>& a) {
        check_restricted(a, tree_of(a));
        check_restricted(a, toy::grid_tree(a));
    });
}

}  // namespace

TEST_CASE("toy cells: a cut divides a cell, or touches it, or misses it") {
    const toy::CellSpace<2> space;
    const toy::Cell<2> cell{{0, 0}, {2, 3}};
    const auto s = space.split_cell({0, 1, Sign::minus}, cell);
    REQUIRE(s.side == FacetSide::crossing);
    CHECK(*s.minus == toy::Cell<2>{{1, 0}, {2, 3}});
    CHECK(*s.plus == toy::Cell<2>{{0, 0}, {1, 3}});
    CHECK(*s.lid == toy::Facet<2>{{0, 1, Sign::minus}, {1, 0}, {1, 3}});
    for (const toy::Integer at : {-1, 0}) {
        CHECK(space.cell_side({1, at, Sign::plus}, cell) == FacetSide::plus);
        CHECK(space.cell_side({1, at, Sign::minus}, cell) == FacetSide::minus);
        CHECK_FALSE(space.split_cell({1, at, Sign::plus}, cell).lid);
    }
    CHECK(space.cell_side({1, 3, Sign::plus}, cell) == FacetSide::minus);
    CHECK(space.split_cell({0, 0, Sign::plus}, space.universe()).side == FacetSide::crossing);
}

TEST_CASE("toy cells: merging, walking and restricting trees in D = 1") {
    check_all<1>(100);
}
TEST_CASE("toy cells: merging, walking and restricting trees in D = 2") {
    check_all<2>(40);
}
TEST_CASE("toy cells: merging, walking and restricting trees in D = 3") {
    check_all<3>(20);
}
