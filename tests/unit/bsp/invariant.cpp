// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/invariant.hpp>

#include "support/catch.hpp"
#include "support/toy_space.hpp"
#include "support/toy_trees.hpp"

#include <cleave/bsp/build.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

using cleave::Branch;
using cleave::FacetDefect;
using cleave::FacetDefectKind;
using cleave::Sign;
using cleave::TreeDefect;
using cleave::TreeDefectKind;
using Parts = cleave::TreeParts<int>;
using Tree = cleave::PlaneTree<int>;
using Defects = std::vector<TreeDefect>;

/// Node 0 with node 1 (leaves 0, 1) below it and leaf 2 above.
Parts sound() {
    Parts parts;
    parts.root = parts.add_node(10);
    const Branch below = parts.add_node(20);
    parts.nodes[0].minus = below;
    parts.nodes[1].minus = parts.add_leaf(true);
    parts.nodes[1].plus = parts.add_leaf(false);
    parts.nodes[0].plus = parts.add_leaf(false);
    return parts;
}

Defects check(const Parts& parts) {
    return cleave::check_structure(Tree(parts));
}

using Square = cleave::FacetTree<toy::Plane, toy::Facet<2>>;

/// The tree of [1,3]^2 with its four sides, by the cuts x > 1, x < 3, y > 1, y < 3.
Square square() {
    toy::Grid<2> grid(4);
    grid.fill({1, 1}, {3, 3});
    toy::Space<2> space;
    return cleave::build_with_facets(space, grid.boundary());
}

std::vector<FacetDefectKind> kinds(const Square& t) {
    toy::Space<2> space;
    std::vector<FacetDefectKind> found;
    for (const FacetDefect& d : cleave::check_facets(space, t)) found.push_back(d.kind);
    return found;
}

bool has(const std::vector<FacetDefectKind>& found, FacetDefectKind kind) {
    return std::find(found.begin(), found.end(), kind) != found.end();
}

/// The same kept facets with those of one node replaced.
cleave::NodeFacets<toy::Facet<2>> replaced(const Square& t, Branch node, const std::vector<toy::Facet<2>>& same,
                                           const std::vector<toy::Facet<2>>& opposite) {
    cleave::NodeFacets<toy::Facet<2>> kept;
    for (std::uint32_t i = 0; i < t.facets.node_count(); ++i) {
        const Branch b = Branch::node(i);
        if (b == node) {
            kept.add_node(same, opposite);
        } else {
            kept.add_node({t.facets.same(b).begin(), t.facets.same(b).end()},
                          {t.facets.opposite(b).begin(), t.facets.opposite(b).end()});
        }
    }
    return kept;
}

}  // namespace

TEST_CASE("invariant: sound trees have no defects") {
    CHECK(check(sound()).empty());
    CHECK(cleave::check_structure(Tree(true)).empty());
    CHECK(cleave::check_structure(Tree()).empty());
    CHECK(cleave::check_structure(toy::chain(100'000, true)).empty());
    CHECK(cleave::check_structure(toy::chain(100'000, false)).empty());
}

TEST_CASE("invariant: a missing root or child is reported") {
    Parts parts = sound();
    parts.nodes[1].plus = Branch();
    CHECK(check(parts) == Defects{{TreeDefectKind::missing, Branch::node(1), Branch()},
                                  {TreeDefectKind::orphan, Branch(), Branch::leaf(1)}});
    parts = Parts();
    CHECK(check(parts) == Defects{{TreeDefectKind::missing, Branch(), Branch()}});
}

TEST_CASE("invariant: an index beyond the arrays is reported") {
    Parts parts = sound();
    parts.nodes[0].plus = Branch::leaf(3);
    CHECK(check(parts) == Defects{{TreeDefectKind::out_of_range, Branch::node(0), Branch::leaf(3)},
                                  {TreeDefectKind::orphan, Branch(), Branch::leaf(2)}});
    parts = sound();
    parts.nodes[0].minus = Branch::node(2);
    CHECK(check(parts) == Defects{{TreeDefectKind::out_of_range, Branch::node(0), Branch::node(2)},
                                  {TreeDefectKind::orphan, Branch(), Branch::node(1)},
                                  {TreeDefectKind::orphan, Branch(), Branch::leaf(0)},
                                  {TreeDefectKind::orphan, Branch(), Branch::leaf(1)}});
    parts = sound();
    parts.root = Branch::leaf(77);
    CHECK(check(parts).front() == TreeDefect{TreeDefectKind::out_of_range, Branch(), Branch::leaf(77)});
}

TEST_CASE("invariant: a cycle is reported and does not trap the checker") {
    Parts parts = sound();
    parts.nodes[1].plus = Branch::node(0);
    CHECK(check(parts) == Defects{{TreeDefectKind::cycle, Branch::node(1), Branch::node(0)},
                                  {TreeDefectKind::orphan, Branch(), Branch::leaf(1)}});
    parts = sound();
    parts.nodes[1].plus = Branch::node(1);
    CHECK(check(parts).front() == TreeDefect{TreeDefectKind::cycle, Branch::node(1), Branch::node(1)});
}

TEST_CASE("invariant: a child of two parents is reported") {
    Parts parts = sound();
    parts.nodes[0].plus = parts.nodes[1].plus;
    CHECK(check(parts) == Defects{{TreeDefectKind::shared, Branch::node(0), Branch::leaf(1)},
                                  {TreeDefectKind::orphan, Branch(), Branch::leaf(2)}});
    parts = sound();
    parts.nodes[0].plus = Branch::node(1);
    CHECK(check(parts) == Defects{{TreeDefectKind::shared, Branch::node(0), Branch::node(1)},
                                  {TreeDefectKind::orphan, Branch(), Branch::leaf(2)}});
}

TEST_CASE("invariant: what the root does not reach is an orphan, even if it is a cycle of its own") {
    Parts parts = sound();
    (void)parts.add_leaf(true);
    CHECK(check(parts) == Defects{{TreeDefectKind::orphan, Branch(), Branch::leaf(3)}});
    parts = sound();
    const Branch lost = parts.add_node(30);
    parts.nodes[lost.index()].minus = lost;
    parts.nodes[lost.index()].plus = lost;
    CHECK(check(parts) == Defects{{TreeDefectKind::orphan, Branch(), lost}});
    parts = sound();
    parts.root = parts.nodes[0].minus;
    CHECK(check(parts) == Defects{{TreeDefectKind::orphan, Branch(), Branch::node(0)},
                                  {TreeDefectKind::orphan, Branch(), Branch::leaf(2)}});
}

TEST_CASE("invariant: a square with its sides has no defects") {
    CHECK(kinds(square()).empty());
}

TEST_CASE("invariant: a facet that is not in its node's cut is reported with its place") {
    Square t = square();
    const Branch node = Branch::node(2);
    toy::Facet<2> moved = t.facets.same(node).front();
    moved.plane.at = moved.low[1] = moved.high[1] = 2;
    t.facets = replaced(t, node, {moved}, {});
    toy::Space<2> space;
    const std::vector<FacetDefect> defects = cleave::check_facets(space, t);
    REQUIRE_FALSE(defects.empty());
    CHECK(defects.front() == FacetDefect{FacetDefectKind::not_in_cut, node, 2});
}

TEST_CASE("invariant: a facet in the wrong list is reported") {
    Square t = square();
    const Branch node = Branch::node(1);
    t.facets = replaced(t, node, {}, {t.facets.same(node).front()});
    CHECK(has(kinds(t), FacetDefectKind::misfiled));
}

TEST_CASE("invariant: a facet that faces inward is misfiled, or its labels are wrong") {
    Square t = square();
    toy::Space<2> space;
    const Branch node = Branch::node(3);
    const toy::Facet<2> inward = space.flip(t.facets.same(node).front());
    t.facets = replaced(t, node, {inward}, {});
    CHECK(kinds(t) == std::vector{FacetDefectKind::misfiled});
    t.facets = replaced(t, node, {}, {inward});
    CHECK(kinds(t) == std::vector{FacetDefectKind::label_inside, FacetDefectKind::label_outside});
}

TEST_CASE("invariant: a facet that leaves its node's cell is reported") {
    Square t = square();
    const Branch node = Branch::node(2);  // below x > 1 and x < 3
    toy::Facet<2> longer = t.facets.same(node).front();
    longer.high[0] = 4;
    t.facets = replaced(t, node, {longer}, {});
    CHECK(kinds(t) == std::vector{FacetDefectKind::outside_cell});
}

TEST_CASE("invariant: a cut that is repeated below its facet is reported") {
    const toy::Plane h{0, 1, Sign::plus};
    const toy::Facet<2> side{h, {1, 0}, {1, 5}};
    Square t;
    t.tree = toy::Tree<>(h, toy::Tree<>(true), toy::Tree<>(h, toy::Tree<>(false), toy::Tree<>(false)));
    for (std::uint32_t i = 0; i < 2; ++i) {
        if (Branch::node(i) == t.tree.root()) {
            t.facets.add_node({side}, {});
        } else {
            t.facets.add_node({}, {});
        }
    }
    CHECK(kinds(t) == std::vector{FacetDefectKind::cut_again});
}

TEST_CASE("invariant: a wrong label beside a facet is reported") {
    Square t = square();
    for (std::uint32_t i = 0; i < t.tree.leaf_count(); ++i) {
        const Branch leaf = Branch::leaf(i);
        const bool right = t.tree.label(leaf);
        t.tree.set_label(leaf, !right);
        // The inside leaf borders on all four sides, each outside leaf on one.
        const std::size_t wrong = right ? 4 : 1;
        CHECK(kinds(t) == std::vector(wrong, right ? FacetDefectKind::label_inside : FacetDefectKind::label_outside));
        t.tree.set_label(leaf, right);
    }
    CHECK(kinds(t).empty());
}

TEST_CASE("invariant: a facet that borders on several leaves is checked beside each of them") {
    // The side x = 2 of [0,2]x[0,2], cut at y = 1 on its inner side only; the upper inner leaf is wrong.
    const toy::Plane h{0, 2, Sign::plus};
    Square t;
    t.tree = toy::Tree<>(h, toy::Tree<>({1, 1, Sign::plus}, toy::Tree<>(true), toy::Tree<>(false)), toy::Tree<>(false));
    const toy::Facet<2> side{h, {2, 0}, {2, 2}};
    t.facets.add_node({}, {});
    t.facets.add_node({}, {});
    t.facets = replaced(t, t.tree.root(), {side}, {});
    CHECK(kinds(t) == std::vector{FacetDefectKind::label_inside});
    const toy::Facet<2> lower{h, {2, 0}, {2, 1}};
    t.facets = replaced(t, t.tree.root(), {lower}, {});
    CHECK(kinds(t).empty());
}

TEST_CASE("invariant: facets for another number of nodes break the contract") {
#if CLEAVE_CONTRACTS >= 1
    Square t = square();
    t.facets = {};
    toy::Space<2> space;
    CHECK_THROWS_AS(cleave::check_facets(space, t), cleave::ContractViolation);
#else
    CLEAVE_SKIP("contracts are off");
#endif
}
