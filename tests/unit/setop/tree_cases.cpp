// SPDX-License-Identifier: Apache-2.0
// Known trees and sets: operations on half-planes and boxes with the numbers of nodes that remain, structural cuts,
// partitions, and solids with known sizes and centroids, each by its number in the list that they come from.
#include <cleave/bsp/classify.hpp>
#include <cleave/query/centroid.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/region/tree.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>
#include <cleave/shape/sphere.hpp>

#include "support/catch.hpp"
#include "support/exact_region.hpp"
#include "support/tree_set.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

Region<2> half_plane(int a, int b, int c) {
    return half_space(make_plane<Integer>(a, b, c));
}

constexpr Operation union_of = Operation::union_;
constexpr Operation both_of = Operation::intersection;
constexpr Operation minus = Operation::difference;
constexpr Operation odd = Operation::symmetric_difference;

}  // namespace

TEST_CASE("tree cases: D29, two half-planes in every operation") {
    const Region<2> x = half_plane(0, -1, 0);  // y > 0
    const Region<2> y = half_plane(1, 0, 0);   // x < 0
    CHECK(TreeSet<2>(union_of, x, Region<2>::empty()).size() == 3);
    CHECK(TreeSet<2>(union_of, x, Region<2>::full()).size() == 1);
    TreeSet<2> any(union_of, x, y);
    CHECK(any.size() == 5);
    CHECK((any.inside({1, 1}) && any.inside({-1, 1}) && any.inside({-1, -1})));
    CHECK((any.outside({1, -1}) && any.on({0, 0})));
    TreeSet<2> both(both_of, x, y);
    CHECK(both.size() == 5);
    CHECK((both.inside({-1, 1}) && both.outside({1, 1}) && both.outside({-1, -1})));
    TreeSet<2> x_only(minus, x, y);
    CHECK(x_only.size() == 5);
    CHECK((x_only.inside({1, 1}) && x_only.outside({-1, 1}) && x_only.outside({1, -1})));
    TreeSet<2> one(odd, x, y);
    CHECK(one.size() == 7);
    CHECK((one.inside({1, 1}) && one.inside({-1, -1}) && one.outside({-1, 1}) && one.outside({1, -1})));
    for (const Operation operation : all_operations) {
        const std::size_t with_itself = TreeSet<2>(operation, x, x).size();
        CHECK(with_itself == (operation == union_of || operation == both_of ? 3 : 1));
        CHECK(TreeSet<2>(operation, x, ~x).size() == (operation == minus ? 3 : 1));
    }
}

TEST_CASE("tree cases: D30, a half-plane and a box") {
    const Region<2> h = half_plane(0, 1, 2);  // y < -2
    const Region<2> b = box<2>({0, -4}, {2, 0});
    TreeSet<2> both(both_of, h, b);
    CHECK(both.size() == 9);
    CHECK(both.inside({1, -3}));
    CHECK((both.outside({1, -1}) && both.outside({-1, -3}) && both.outside({1, -5}) && both.outside({3, -3})));
    TreeSet<2> h_only(minus, h, b);
    CHECK(h_only.size() == 9);
    for (const auto& p : {std::array<Rational, 2>{-1, -3}, {-1, -5}, {1, -5}, {3, -5}, {4, -3}})
        CHECK(h_only.inside(p));
    for (const auto& p : {std::array<Rational, 2>{1, -1}, {3, -1}, {1, -3}}) CHECK(h_only.outside(p));
    TreeSet<2> one(odd, h, b);
    CHECK(one.inside({1, -1}));
    for (const auto& p : {std::array<Rational, 2>{3, -1}, {1, -3}, {1, 1}, {5, -1}}) CHECK(one.outside(p));
    CHECK((one.on({0, 0}) && one.on({2, 0})));
    TreeSet<2> swallowed(union_of, half_plane(0, 1, -2), b);  // y < 2
    CHECK(swallowed.size() == 3);
    CHECK((swallowed.inside({0, 0}) && swallowed.inside({1, 1}) && swallowed.inside({1, -1})));
    CHECK((swallowed.outside({0, 3}) && swallowed.outside({3, 3}) && swallowed.on({-1, 2}) && swallowed.on({3, 2})));
}

TEST_CASE("tree cases: D31, a skewed bow tie with its complement and its copy") {
    const Region<2> tie = simplex<2>({{-1, 0}, {4, 0}, {4, 5}}) | simplex<2>({{1, 0}, {-4, 0}, {-4, -5}});
    CHECK(measure(tie) == 25);
    TreeSet<2> t(tie);
    CHECK((t.inside({3, 1}) && t.inside({-3, -1}) && t.inside({0, 0})));
    CHECK((t.outside({-3, 1}) && t.outside({3, -1}) && t.outside({5, 0}) && t.outside({-5, 0})));
    for (const auto& p : {std::array<Rational, 2>{4, 5}, {-4, -5}, {4, 0}, {1, 0}, {2, 0}, {-1, 0}, {-4, 0}, {-2, 0}})
        CHECK(t.on(p));
    TreeSet<2> out(~tie);
    CHECK((out.outside({3, 1}) && out.outside({0, 0}) && out.inside({-3, 1}) && out.on({4, 5})));
    CHECK((tie | ~tie).is_full());
    CHECK((tie & ~tie).is_empty());
    CHECK((tie - tie).is_empty());
    CHECK((tie ^ ~tie).is_full());
    for (const Operation operation : {minus, odd}) CHECK(TreeSet<2>(operation, tie, tie).size() == 1);
    for (const Operation operation : {union_of, both_of, odd}) CHECK(TreeSet<2>(operation, tie, ~tie).size() == 1);
}

TEST_CASE("tree cases: D32, a cut inserted in a box and its boundary") {
    const Region<2> whole = box<2>({2, 1}, {4, 2});
    CHECK(ExactRegion<2>(whole).boundary_measure() == 6);
    CHECK(ExactRegion<2>(~whole).boundary_measure() == 6);
    // The segment from (3, 1) to (3, 2) goes all the way through the box, which is one leaf: what is on its right, its
    // plus side, becomes outside.
    const BspTree<2, Rational> tree = to_tree(whole);
    TreeParts<Plane<2, Rational>> parts;
    parts.root = tree.root();
    parts.nodes.assign(tree.nodes().begin(), tree.nodes().end());
    parts.leaves.assign(tree.leaves().begin(), tree.leaves().end());
    const Branch cut = parts.add_node(make_plane<Rational>(1, 0, -3));
    for (const ChildSide side : {ChildSide::minus, ChildSide::plus})
        parts.hang(cut, side, parts.add_leaf(side == ChildSide::minus));
    for (TreeNode<Plane<2, Rational>>& node : parts.nodes)
        for (Branch* child : {&node.minus, &node.plus})
            if (child->is_leaf() && child->index() < tree.leaf_count() && tree.label(*child)) *child = cut;
    const Region<2> half = to_region(BspTree<2, Rational>(std::move(parts)));
    CHECK(ExactRegion<2>(half).boundary_measure() == 4);
    CHECK(canonical(half) == canonical(box<2>({2, 1}, {3, 2})));
}

TEST_CASE("tree cases: D33, structural cuts change no set") {
    const Region<2> square = box<2>({-1, -1}, {1, 1});
    std::vector<Plane<2, Integer>> sides;
    for (const int a : {-1, 1})
        for (const int b : {-1, 1}) sides.push_back(make_plane<Integer>(a, b, -1));
    const Region<2> diamond = half_spaces<2, Integer>(sides);
    const Region<2> horseshoe = polygon<Rational>({{1, 0}, {1, 1}, {3, 1}, {3, 2}, {-1, 2}, {-1, -1}, {3, -1}, {3, 0}});
    for (const Region<2>& shape : {square, diamond, horseshoe}) {
        const BspTree<2, Rational> plain = to_tree(shape);
        BspTree<2, Rational> tree = plain;
        // Halve the grid [-2, 2]^2 again and again: the old tree hangs below both sides of every cut.
        for (int level = 0; level < 5; ++level) {
            const std::size_t axis = std::size_t(level % 2);
            const Rational at = level < 2 ? Rational(0) : Rational(level % 2 == 0 ? 1 : -1);
            Plane<2, Rational>::Coefficients c{Rational(0), Rational(0), Rational(-at)};
            c[axis] = 1;
            tree = BspTree<2, Rational>(Plane<2, Rational>(c), tree, tree);
            CHECK(canonical(to_region(tree)) == canonical(shape));
        }
    }
    TreeSet<2> h(horseshoe);
    for (const auto& p : {std::array<Rational, 2>{0, 0},
                          {0, Rational(3, 2)},
                          {2, Rational(3, 2)},
                          {0, Rational(-1, 2)},
                          {2, Rational(-1, 2)}})
        CHECK(h.inside(p));
    for (const auto& p : {std::array<Rational, 2>{2, Rational(1, 2)}, {4, Rational(1, 2)}, {1, 4}}) CHECK(h.outside(p));
}

TEST_CASE("tree cases: D34, a square divided by a line") {
    const Region<2> square = box<2>({0, 0}, {1, 1});
    Kernel<2> kernel;
    PolytopeClip<2> model(kernel);
    const PlaneTree<PlaneId> tree = tree_of_boundary(square.boundary(), kernel);
    CHECK(tree.node_count() == 4);
    CHECK(tree.leaf_count() == 5);
    const PlaneId half = kernel.planes.intern({Integer(0), Integer(2), Integer(-1)});
    const auto parts = partition(model, tree, half);
    CHECK(parts.minus.node_count() == 3);
    CHECK(parts.plus.node_count() == 3);
    PointInterner<2> points(kernel);
    const FaceList faces =
        faces_of_tree(model, points, PlaneTree<PlaneId>(half, parts.minus, parts.plus), [](std::uint32_t) {
            return Source{0, 0};
        });
    CHECK(faces.faces.size() == 4);
    for (std::size_t l = 0; l + 1 < faces.loop_first.size(); ++l) CHECK(faces.loop(l).size() == 2);
    CHECK(faces.loop_first.size() == 5);  // no T-vertices: one segment a side
}

TEST_CASE("tree cases: D45, a gap of 1e-7 is a gap") {
    const Rational h(1, 2);
    const Rational gap(1, 10000000);
    const Region<3> two = box<3>({-h, -h, -h}, {h, h, h}) | box<3>({h + gap, -h, -h}, {Rational(h + gap + 1), h, h});
    CHECK(measure(two) == 2);
    CHECK(two.face_count() == 12);
    CHECK(*centroid(two) == std::array<Rational, 3>{h + Rational(1, 20000000), 0, 0});
    CHECK(TreeSet<3>(two).outside({h + gap / 2, 0, 0}));
}

TEST_CASE("tree cases: D46, a regular tetrahedron") {
    const Region<3> t = simplex<3>({{1, 2, 3}, {2, 2, 4}, {2, 3, 3}, {1, 3, 4}});
    CHECK(measure(t) == Rational(1, 3));
    CHECK(*centroid(t) == std::array<Rational, 3>{Rational(3, 2), Rational(5, 2), Rational(7, 2)});
    TreeSet<3> set(t);
    for (const auto& p : {std::array<Rational, 3>{1, 2, 3},
                          {2, 2, 4},
                          {2, 3, 3},
                          {1, 3, 4},
                          {Rational(5, 3), Rational(7, 3), Rational(10, 3)}})
        CHECK(set.on(p));
    for (const auto& p : {std::array<Rational, 3>{1, 2, 4}, {2, 2, 3}, {2, 3, 4}, {1, 3, 3}}) CHECK(set.outside(p));
}

TEST_CASE("tree cases: D48, the symmetric difference of two overlapping cubes") {
    const Rational h(1, 2);
    const Region<3> one =
        box<3>({0, 0, 0}, {1, 1, 1}) ^ box<3>({h, h, h}, {Rational(3, 2), Rational(3, 2), Rational(3, 2)});
    CHECK(measure(one) == Rational(7, 4));
    CHECK(*centroid(one) == std::array<Rational, 3>{Rational(3, 4), Rational(3, 4), Rational(3, 4)});
    TreeSet<3> set(one);
    for (const Rational& x : {Rational(0), h, Rational(1), Rational(3, 2)}) CHECK(set.on({x, x, x}));
    for (const Rational& x : {Rational(1, 10), Rational(2, 5), Rational(11, 10), Rational(7, 5)})
        CHECK(set.inside({x, x, x}));
    CHECK(set.outside({Rational(3, 4), Rational(3, 4), Rational(3, 4)}));
}

TEST_CASE("tree cases: D49, a solid with its copy") {
    const Region<3> ball = sphere({0, 0, 0}, 1);
    const Region<3> copy = ball;
    for (const Engine engine : all_engines) {
        CHECK(canonical(apply(engine, union_of, ball, copy)) == canonical(ball));
        CHECK(canonical(apply(engine, both_of, ball, copy)) == canonical(ball));
        for (const Operation operation : {minus, odd}) {
            const Region<3> nothing = apply(engine, operation, ball, copy);
            CHECK(nothing.is_empty());
            CHECK(measure(nothing) == 0);
            CHECK_FALSE(centroid(nothing));
        }
    }
}

TEST_CASE("tree cases: D50, a box cut in two") {
    const Rational h(1, 2);
    const Region<3> cube = box<3>({-h, -h, -h}, {h, h, h});
    const Region<3> below = cube & half_space(make_plane<Integer>(1, 0, 0, 0));
    const Region<3> above = cube - half_space(make_plane<Integer>(1, 0, 0, 0));
    CHECK((measure(below) == h && measure(above) == h));
    CHECK(*centroid(below) == std::array<Rational, 3>{Rational(-1, 4), 0, 0});
    CHECK(*centroid(above) == std::array<Rational, 3>{Rational(1, 4), 0, 0});
    CHECK(*centroid(box<3>({1, 2, 3}, {2, 3, 4})) ==
          std::array<Rational, 3>{Rational(3, 2), Rational(5, 2), Rational(7, 2)});
}

TEST_CASE("tree cases: D53, a cross of three beams") {
    const Rational l(1);
    const Rational w(1, 10);
    Region<3> cross = Region<3>::empty();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<Rational, 3> lo{1 - w, 2 - w, 3 - w};
        std::array<Rational, 3> hi{1 + w, 2 + w, 3 + w};
        lo[axis] -= l - w;
        hi[axis] += l - w;
        cross |= box<3>(lo, hi);
    }
    CHECK(measure(cross) == 8 * w * w * (3 * l - 2 * w));
    CHECK(*centroid(cross) == std::array<Rational, 3>{1, 2, 3});
}

TEST_CASE("tree cases: a region and its tree are the same set, in every dimension and at infinity") {
    const Region<1> line = intervals({{0, 1}, {2, 3}}) | half_space(make_plane<Integer>(1, 5));
    CHECK(canonical(to_region(to_tree(line))) == canonical(line));
    const Region<3> solid = box<3>({0, 0, 0}, {2, 2, 2}) - sphere({1, 1, 1}, 1);
    CHECK(canonical(to_region(to_tree(solid))) == canonical(solid));
    const Region<3> outside = half_space(make_plane<Integer>(1, 1, 0, 0)) - solid;
    CHECK(canonical(to_region(to_tree(outside))) == canonical(outside));
    const Region<4> four = box<4>({0, 0, 0, 0}, {1, 1, 1, 1}) ^
                           simplex<4>({{0, 0, 0, 0}, {2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 2}});
    CHECK(canonical(to_region(to_tree(four))) == canonical(four));
    CHECK(to_region(to_tree(Region<2>::full())).is_full());
    CHECK(to_region(to_tree(Region<2>::empty())).is_empty());
    // A tree with an empty cell is a set like any other.
    const Plane<1, Rational> zero = make_plane<Rational>(1, 0);
    const BspTree<1, Rational> twice(
        zero, BspTree<1, Rational>(true),
        BspTree<1, Rational>(zero, BspTree<1, Rational>(true), BspTree<1, Rational>(false)));
    CHECK(canonical(to_region(twice)) == canonical(half_space(zero)));
}

TEST_CASE("tree cases: a 4-D union's sections at rational heights, and its measure, two ways") {
    const Region<4> a = simplex<4>({{0, 0, 0, 0}, {4, 0, 0, 0}, {0, 4, 0, 0}, {0, 0, 4, 0}, {0, 0, 0, 4}});
    const Region<4> b = simplex<4>({{1, 1, 1, -1}, {5, 1, 1, -1}, {1, 5, 1, -1}, {1, 1, 5, -1}, {1, 1, 1, 3}});
    const Region<4> sum = a | b;
    // One way: |A| + |B| - |A and B|, the last as a simplex of its own.
    const Rational direct = *measure(sum);
    CHECK(direct == *measure(a) + *measure(b) - *measure(a & b));
    // The other: the section at height w is a union of two tetrahedra; its volume is a cubic on each interval between
    // the heights at which one begins or ends, so Simpson's rule with the breaks as nodes integrates it exactly.
    const auto section = [](const Rational& w) {
        Region<3> s = Region<3>::empty();
        if (w >= 0 && w < 4) {
            const Rational e = 4 - w;
            s |= simplex<3>({{0, 0, 0}, {e, 0, 0}, {0, e, 0}, {0, 0, e}});
        }
        if (w >= -1 && w < 3) {
            const Rational e = 3 - w;
            s |= simplex<3>({{1, 1, 1}, {Rational(1 + e), 1, 1}, {1, Rational(1 + e), 1}, {1, 1, Rational(1 + e)}});
        }
        return s;
    };
    Rational integral = 0;
    const std::vector<Rational> breaks{-1, 0, 1, 3, 4};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const Rational lo = breaks[i];
        const Rational hi = breaks[i + 1];
        // Just inside the ends the section is that of the interval: a cubic through four inner points.
        const Rational step = (hi - lo) / 5;
        std::array<Rational, 4> v;
        for (int k = 0; k < 4; ++k) v[std::size_t(k)] = *measure(section(lo + (k + 1) * step));
        // The open four-point rule 5h/24 (11, 1, 1, 11) is exact for cubics.
        integral += 5 * step / 24 * (11 * v[0] + v[1] + v[2] + 11 * v[3]);
    }
    CHECK(direct == integral);
    // And the sections themselves: those of the union are the unions of the sections.
    const Rational height(1, 3);
    Kernel<4> kernel;
    PolytopeClip<4> model(kernel);
    const PlaneTree<PlaneId> tree = tree_of_boundary(sum.boundary(), kernel);
    TreeSet<3> flat(section(height));
    for (int x = -1; x < 6; ++x)
        for (int y = -1; y < 6; ++y)
            for (int z = -1; z < 6; ++z) {
                const Rational px = x + Rational(1, 7);
                const Rational py = y + Rational(1, 11);
                const Rational pz = z + Rational(1, 13);
                CHECK(classify(model, tree, add_point<Rational, 4>(kernel, {px, py, pz, height})) ==
                      flat.at({px, py, pz}));
            }
}
