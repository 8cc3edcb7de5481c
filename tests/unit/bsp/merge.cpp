// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/merge.hpp>
//
#include <cleave/bsp/classify.hpp>
#include <cleave/bsp/collapse.hpp>
#include <cleave/bsp/tree_boundary.hpp>
#include <cleave/bsp/trim.hpp>

#include "support/catch.hpp"
#include "support/convex_sets.hpp"

#include <cstddef>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

using Tree = PlaneTree<PlaneId>;

/// Unions of convex sets, merged one by one, and the membership of points in each step.
template <int D>
void check_merges(unsigned seed, bool bounded) {
    Dice dice(seed);
    Kernel<D> kernel;
    PolytopeClip<D> model(kernel);
    std::vector<GenericPoint<D>> points;
    for (int i = 0; i < 20; ++i) points.push_back(GenericPoint<D>::random(dice, 4));

    Tree tree(dice.below(2) == 0);
    std::vector<int> expected(points.size(), tree.label(tree.root()) ? 1 : -1);
    for (int step = 0; step < 4; ++step) {
        const HalfSpaces<D> set = random_convex<D>(dice, bounded);
        const Operation operation = all_operations[std::size_t(dice.below(4))];
        const Tree other = tree_of(model, set);
        REQUIRE(has_no_empty_cell(model, other));
        const bool swapped = dice.below(2) == 0;
        const Tree& a = swapped ? other : tree;
        const Tree& b = swapped ? tree : other;
        const Tree merged = merge(model, a, b, BooleanRule(operation));
        REQUIRE(has_no_empty_cell(model, merged));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const int in = points[i].in(set);
            if (in == 0 || expected[i] == 0) {
                expected[i] = 0;
                continue;
            }
            const bool x = swapped ? in > 0 : expected[i] > 0;
            const bool y = swapped ? expected[i] > 0 : in > 0;
            expected[i] = apply(operation, x, y) ? 1 : -1;
            const Location where = classify(model, merged, points[i].add_to(kernel));
            REQUIRE(where == (expected[i] > 0 ? Location::inside : Location::outside));
        }
        const Tree collapsed = collapse(merged);
        const Tree trimmed = trim(model, collapsed);
        CHECK(collapsed.node_count() <= merged.node_count());
        CHECK(trimmed.node_count() <= collapsed.node_count());
        REQUIRE(has_no_empty_cell(model, trimmed));
        // The same set: their symmetric difference has no boundary.
        const Tree nothing = collapse(merge(model, merged, trimmed, BooleanRule(Operation::symmetric_difference)));
        CHECK(nothing.is_single_leaf());
        CHECK(boundary(model, trimmed).empty() == trimmed.is_single_leaf());
        tree = trimmed;
    }
}

}  // namespace

TEST_CASE("merge: membership of points in D = 1") {
    for (unsigned seed = 0; seed < scaled(100); ++seed) check_merges<1>(seed, seed % 2 == 0);
}
TEST_CASE("merge: membership of points in D = 2") {
    for (unsigned seed = 0; seed < scaled(100); ++seed) check_merges<2>(seed, seed % 2 == 0);
}
TEST_CASE("merge: membership of points in D = 3") {
    for (unsigned seed = 0; seed < scaled(40); ++seed) check_merges<3>(seed, seed % 2 == 0);
}
TEST_CASE("merge: membership of points in D = 4") {
    for (unsigned seed = 0; seed < scaled(10); ++seed) check_merges<4>(seed, seed % 2 == 0);
}
TEST_CASE("merge: membership of points in D = 5") {
    for (unsigned seed = 0; seed < scaled(4); ++seed) check_merges<5>(seed, seed % 2 == 0);
}
