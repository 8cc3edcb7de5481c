// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/cells.hpp>
//
#include <cleave/bsp/tree_boundary.hpp>

#include "support/catch.hpp"
#include "support/convex_sets.hpp"

#include <cstddef>
#include <optional>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

using Tree = PlaneTree<PlaneId>;

}  // namespace

TEST_CASE("cells: every branch has one, and a leaf of a square's tree is the square") {
    Kernel<2> kernel;
    PolytopeClip<2> model(kernel);
    const Tree square = tree_of<2>(model, integer_box<2>({0, 0}, {1, 1}));
    std::size_t nodes = 0;
    std::size_t leaves = 0;
    for_each_cell(model, square, [&](Branch b, const Polytope& cell, const auto& split) {
        b.is_node() ? ++nodes : ++leaves;
        CHECK(split.lid.has_value() == b.is_node());
        CHECK(cell.size() >= 3);
        if (b.is_leaf() && square.label(b)) CHECK(cell.size() == 4);
    });
    CHECK(nodes == 4);
    CHECK(leaves == 5);
    CHECK(has_no_empty_cell(model, square));
}

TEST_CASE("cells: a cut that misses its cell is an empty cell, and restricting to all of space removes it") {
    Kernel<1> kernel;
    PolytopeClip<1> model(kernel);
    const PlaneId zero = intern<1>(kernel, {1, 0});
    const Tree twice(zero, Tree(true), Tree(zero, Tree(true), Tree(false)));
    CHECK_FALSE(has_no_empty_cell(model, twice));
    const Tree once = restricted(model, twice, model.universe());
    CHECK(once == Tree(zero, Tree(true), Tree(false)));
    CHECK(has_no_empty_cell(model, once));
}

TEST_CASE("cells: a partitioned tree is the same set with the plane at the root") {
    Kernel<2> kernel;
    PolytopeClip<2> model(kernel);
    const Tree square = tree_of<2>(model, integer_box<2>({0, 0}, {2, 2}));
    const PlaneId middle = intern<2>(kernel, {1, 0, -1});
    const auto parts = partition(model, square, middle);
    CHECK(parts.minus.node_count() == 3);
    CHECK(parts.plus.node_count() == 3);
    const Tree whole(middle, parts.minus, parts.plus);
    CHECK(has_no_empty_cell(model, whole));
    CHECK(boundary(model, whole).size() == 6);  // two sides are cut by the new root
    const PlaneId beside = intern<2>(kernel, {1, 0, -5});
    CHECK(partition(model, square, beside).minus == square);
    CHECK(partition(model, square, beside).plus == Tree(false));
}

TEST_CASE("cells: sub-hyperplanes lie in their cuts") {
    Kernel<3> kernel;
    PolytopeClip<3> model(kernel);
    const Tree box = tree_of<3>(model, integer_box<3>({0, 0, 0}, {1, 1, 1}));
    const auto lids = sub_hyperplanes(model, box);
    REQUIRE(lids.size() == box.node_count());
    for (std::size_t i = 0; i < lids.size(); ++i) CHECK(lids[i].plane == box.nodes()[i].cut);
    // That of the root is a whole plane; the boundary is six squares.
    const Polytope& whole = model.body(lids[box.root().index()]);
    for (const PointId p : whole.points) CHECK(kernel.is_infinite(p));
    const auto facets = boundary(model, box);
    CHECK(facets.size() == 6);
    for (const auto& f : facets) {
        CHECK(model.body(f).size() == 4);
        CHECK(model.side(f.plane, f) == FacetSide::on_same);
    }
}

TEST_CASE("cells: the boundary of a complement is the same facets flipped") {
    Kernel<2> kernel;
    PolytopeClip<2> model(kernel);
    const PlaneId h = intern<2>(kernel, {1, 1, 0});
    const auto below = boundary(model, Tree(h, Tree(true), Tree(false)));
    const auto above = boundary(model, Tree(h, Tree(false), Tree(true)));
    REQUIRE(below.size() == 1);
    REQUIRE(above.size() == 1);
    CHECK(below[0].plane == h);
    CHECK(above[0].plane == flipped(h));
    CHECK(boundary(model, Tree(h, Tree(true), Tree(true))).empty());
}
