// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/trim.hpp>
//
#include <cleave/bsp/collapse.hpp>
#include <cleave/bsp/merge.hpp>
#include <cleave/bsp/tree_boundary.hpp>

#include "support/catch.hpp"
#include "support/convex_sets.hpp"

#include <array>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

using Tree = PlaneTree<PlaneId>;

PlaneId axis_plane(Kernel<2>& kernel, int axis, int at) {
    return intern<2>(kernel, {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, -at});
}

}  // namespace

TEST_CASE("trim: a structural cut that carries no boundary goes, at the root and below") {
    Kernel<2> kernel;
    PolytopeClip<2> model(kernel);
    // The half-plane x <= 2 in two halves, each with its own node; collapse cannot see it if one half has a cut more.
    const PlaneId half = axis_plane(kernel, 0, 2);
    const PlaneId structural = axis_plane(kernel, 1, 0);
    const PlaneId extra = axis_plane(kernel, 0, 5);
    const Tree simple(half, Tree(true), Tree(false));
    const Tree longer(extra, simple, Tree(false));
    const Tree tree(structural, simple, longer);
    CHECK(collapse(tree).node_count() == 4);
    CHECK(trim(model, tree) == simple);
    const PlaneId outer = axis_plane(kernel, 1, 9);
    CHECK(trim(model, Tree(outer, tree, Tree(false))).node_count() == 2);
}

TEST_CASE("trim: a cut whose one side is uniform stays if the other side's cuts would say something else there") {
    Kernel<2> kernel;
    PolytopeClip<2> model(kernel);
    // Inside is the quarter x <= 0, y <= 0.
    const Tree quarter(axis_plane(kernel, 0, 0), Tree(axis_plane(kernel, 1, 0), Tree(true), Tree(false)), Tree(false));
    CHECK(trim(model, quarter) == quarter);
    // And x >= 0, y <= 0, whose cut in y hangs on the plus side.
    const Tree mirrored(axis_plane(kernel, 0, 0), Tree(false), Tree(axis_plane(kernel, 1, 0), Tree(true), Tree(false)));
    CHECK(trim(model, mirrored) == mirrored);
}

TEST_CASE("trim: [0, 2] from [0, 1] and [1, 2] loses the cut in the middle, which collapse keeps") {
    Kernel<1> kernel;
    PolytopeClip<1> model(kernel);
    const Tree a = tree_of<1>(model, integer_box<1>({0}, {1}));
    const Tree b = tree_of<1>(model, integer_box<1>({1}, {2}));
    const Tree sum = collapse(merge(model, a, b, BooleanRule(Operation::union_)));
    CHECK(sum.node_count() == 3);
    const Tree trimmed = trim(model, sum);
    CHECK(trimmed.node_count() == 2);
    CHECK(boundary(model, trimmed).size() == 2);
    CHECK(has_no_empty_cell(model, trimmed));
}

TEST_CASE("trim: any labels") {
    Kernel<2> kernel;
    PolytopeClip<2> model(kernel);
    using Map = PlaneTree<PlaneId, int>;
    const PlaneId x = axis_plane(kernel, 0, 0);
    const PlaneId y = axis_plane(kernel, 1, 0);
    const Map halves(x, Map(7), Map(8));
    CHECK(trim(model, Map(y, halves, Map(axis_plane(kernel, 0, 3), halves, Map(8)))) == halves);
    CHECK(trim(model, Map(5)) == Map(5));
}
