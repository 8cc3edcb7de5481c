// SPDX-License-Identifier: Apache-2.0
// The numbered traps that other implementations of boundary filtering fell into, as far as they concern regions.
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/cuboids.hpp"
#include "support/region_checker.hpp"

#include <cleave/query/measure.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/hull.hpp>
#include <cleave/shape/prism.hpp>
#include <cleave/shape/simplex.hpp>

#include <cmath>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

template <int D>
Rational size(const Region<D>& r) {
    return ExactRegion<D>(r).measure();
}

Rational area(const Region<3>& r) {
    return ExactRegion<3>(r).boundary_measure();
}

}  // namespace

TEST_CASE("A-T1: lines x = 1 and y = 2 meet in (1, 2), for constructed corners too") {
    const Region<2> r = checked(Operation::intersection, box<2>({0, 0}, {1, 3}), box<2>({0, 0}, {3, 2}));
    CHECK(equal_sets(r, box<2>({0, 0}, {1, 2})));
    const ExactRegion<2> exact(r);
    CHECK(std::count(exact.points().begin(), exact.points().end(), Coordinates<2>{1, 2}) == 1);
}

TEST_CASE("A-T2: a cut through vertices keeps the leading planes of both parts") {
    // The half of a square below its diagonal, then the half of that: in the plane and as prisms.
    const Region<2> square = box<2>({0, 0}, {2, 2});
    const Region<2> below = polygon<Rational>({{-1, -1}, {3, -1}, {3, 3}});
    const Region<2> west = box<2>({-9, -9}, {1, 9});
    const Region<2> piece = checked(Operation::intersection, checked(Operation::intersection, square, below), west);
    CHECK(equal_sets(piece, polygon<Rational>({{0, 0}, {1, 0}, {1, 1}})));
    const Region<3> solid =
        checked(Operation::intersection, checked(Operation::intersection, prism(square, 0, 1), prism(below, -1, 2)),
                prism(west, -2, 3));
    CHECK(equal_sets(solid, prism(piece, 0, 1)));
    CHECK(size(solid) == Rational(1) / 2);
}

TEST_CASE("A-T3: a polygon with three corners on the cut and the rest below has nothing above") {
    const Region<2> flag = polygon<Rational>({{0, -1}, {2, -1}, {2, 0}, {1, 0}, {0, 0}});
    const Region<2> upper = box<2>({-9, 0}, {9, 9});
    CHECK(checked(Operation::intersection, flag, upper).is_empty());
    CHECK(equal_sets(checked(Operation::difference, flag, upper), flag));
    CHECK(checked(Operation::intersection, prism(flag, 0, 1), prism(upper, 0, 1)).is_empty());
    CHECK(size(checked(Operation::union_, prism(flag, 0, 1), prism(upper, 0, 1))) == 2 + 162);
}

TEST_CASE("A-T4: coincident facets have four classes, not a side") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> slab = box<3>({0, 0, 0}, {1, 2, 2});
    const Region<3> join = checked(Operation::union_, a, slab);
    CHECK(join.face_count() == 6);
    CHECK(equal_sets(join, a));
    // Far points stay outside: the result is not the complement.
    CHECK(ExactRegion<3>(checked(Operation::union_, a, a)).locate({100, 100, 100}) == Where::outside);
    CHECK(checked(Operation::difference, a, a).is_empty());
    const Region<3> pair = checked(Operation::union_, a, box<3>({2, 0, 0}, {4, 2, 2}));
    CHECK(area(pair) == 40);
    CHECK(pair.face_count() == 10);  // both inner walls are gone
    // All four classes in one operation: on one plane x = 2 a face same, one opposite, one inside and one outside.
    const Region<3> comb = checked_evaluate<3, Rational>(
        BooleanFunction::union_(3),
        {box<3>({0, 0, 0}, {2, 1, 1}), box<3>({2, 1, 0}, {4, 2, 1}), box<3>({0, 2, 0}, {4, 3, 1})});
    const Region<3> block = box<3>({0, 0, 0}, {2, 4, 1});
    CHECK(size(checked(Operation::union_, comb, block)) == 8 + 2 + 2);
    CHECK(size(checked(Operation::intersection, comb, block)) == 2 + 2);
    CHECK(size(checked(Operation::difference, comb, block)) == 2 + 2);
    CHECK(size(checked(Operation::symmetric_difference, comb, block)) == 4 + 2 + 2);
}

TEST_CASE("A-T5: coplanar neighbours give no edge plane, and no vertex is lost") {
    const Region<3> cube = cuboid({0, 0, 0}, {2, 2, 2}, {1, true});
    const Region<3> west = box<3>({-1, -1, -1}, {Rational(1) / 2, 3, 3});
    const Region<3> cut = checked(Operation::intersection, cube, west);
    CHECK(size(cut) == 2);
    CHECK(area(cut) == 12);
    const Region<3> rest = checked(Operation::difference, cube, west);
    CHECK(size(rest) == 6);
    CHECK(area(rest) == 20);
    CHECK(size(checked(Operation::intersection, cube, cuboid({1, 1, 1}, {3, 3, 3}, {1, true}))) == 1);
    for (const Region<3>* r : {&cube, &cut, &rest}) {
        const Boundary<3>& b = r->boundary();
        for (const FaceList::Face& f : b.faces.faces)
            for (std::uint32_t l = f.first_loop; l < f.first_loop + f.loop_count; ++l)
                for (const Corner& c : b.faces.loop(l)) CHECK(unoriented(c.edge) != unoriented(f.plane));
    }
}

TEST_CASE("A-T6: flipped faces agree with their planes and keep an edge plane to each edge") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> b = box<3>({1, 1, 1}, {3, 3, 3});
    // The volume by loops; the checkers compare every loop with its plane and every edge with its edge plane.
    CHECK(size(checked(Operation::difference, a, b)) == 7);
    CHECK(size(checked(Operation::symmetric_difference, a, b)) == 14);
    CHECK(size(verified(~verified(~a))) == 8);
    const Region<3> twice = checked(Operation::difference, a, checked(Operation::difference, a, b));
    CHECK(equal_sets(twice, box<3>({1, 1, 1}, {2, 2, 2})));
}

TEST_CASE("A-T7: there is no universe box, coordinates may have any size") {
    for (const double unit : {1.0, 0x1p900, 0x1p-900, 1e300, 1e-300, 0x1p-1074, 0x1p1020}) {
        const Rational u = number_traits<Rational>::from_double(unit);
        const auto cube = [&](int lo, int hi) {
            const Rational a = lo * u;
            const Rational b = hi * u;
            return box<3>({a, a, a}, {b, b, b});
        };
        const Rational volume = u * u * u;
        CHECK(size(checked(Operation::union_, cube(0, 2), cube(1, 3))) == 15 * volume);
        CHECK(size(checked(Operation::intersection, cube(0, 2), cube(1, 3))) == volume);
        const Region<3> slanted =
            simplex<3>({{0, 0, 0}, {Rational(3 * u), 0, 0}, {0, Rational(3 * u), 0}, {0, 0, Rational(3 * u)}});
        CHECK(size(checked(Operation::intersection, slanted, cube(0, 1))) == volume);
        CHECK(size(checked(Operation::intersection, slanted, cube(0, 2))) == 4 * volume);
    }
    // Very large and very small together, and beyond the range of doubles.
    const Rational huge =
        Rational(number_traits<Rational>::from_double(0x1p1000) * number_traits<Rational>::from_double(0x1p1000));
    const Rational tiny = 1 / huge;
    const Region<3> big = box<3>({0, 0, 0}, {huge, huge, huge});
    const Region<3> small = box<3>({0, 0, 0}, {tiny, tiny, tiny});
    CHECK(equal_sets(checked(Operation::intersection, big, small), small));
    CHECK(size(checked(Operation::difference, big, small)) == Rational(huge * huge * huge - tiny * tiny * tiny));
}

TEST_CASE("A-T9: every piece comes once, outward, whatever the order of operands") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> b = box<3>({1, 1, 1}, {3, 3, 3});
    CHECK(area(checked(Operation::union_, a, b)) == 42);
    CHECK(area(checked(Operation::union_, b, a)) == 42);
    CHECK(ExactRegion<3>(checked(Operation::union_, a, b)).total_area_vector() == Coordinates<3>{0, 0, 0});
    const Region<3> one = checked(Operation::union_, a, Region<3>::empty());
    CHECK(dump(one.boundary()) == dump(checked(Operation::intersection, a, Region<3>::full()).boundary()));
    CHECK(size(one) == 8);  // not turned inside out
}

TEST_CASE("A-T11: parallel planes on both sides of the origin, planes through the origin") {
    const Region<3> middle = box<3>({-1, -1, -1}, {1, 1, 1});
    const Region<3> row = checked_evaluate<3, Rational>(
        BooleanFunction::union_(3), {box<3>({-3, -1, -1}, {-1, 1, 1}), middle, box<3>({1, -1, -1}, {3, 1, 1})});
    CHECK(size(row) == 24);
    CHECK(area(row) == 2 * 4 + 4 * 12);
    CHECK(equal_sets(checked(Operation::difference, row, box<3>({-3, -2, -2}, {-1, 2, 2})),
                     box<3>({-1, -1, -1}, {3, 1, 1})));
    // Octants around the origin: all offsets are zero.
    Region<3> octants = Region<3>::empty();
    for (int i = 0; i < 8; ++i) {
        const int x = (i & 1) != 0 ? 1 : -1;
        const int y = (i & 2) != 0 ? 1 : -1;
        const int z = (i & 4) != 0 ? 1 : -1;
        if (x * y * z < 0) octants = checked(Operation::union_, octants, box<3>({0, 0, 0}, {x, y, z}));
    }
    CHECK(size(octants) == 4);
    CHECK(size(checked(Operation::difference, middle, octants)) == 4);
    CHECK(equal_sets(checked(Operation::union_, checked(Operation::difference, middle, octants), octants), middle));
}

TEST_CASE("A-T12: nothing depends on scale") {
    for (const int exponent : {0, -10, -40, -200, 60}) {
        const double unit = std::ldexp(1.0, exponent);
        const auto tetrahedron = [&](const std::array<std::array<int, 3>, 4>& p) {
            std::array<std::array<double, 3>, 4> x{};
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 3; ++j) x[i][j] = p[i][j] * unit;
            return Region<3>(simplex<3>(x));
        };
        const Region<3> a = tetrahedron({{{0, 0, 0}, {4, 0, 1}, {1, 4, 0}, {0, 1, 4}}});
        const Region<3> b = tetrahedron({{{2, 2, 3}, {0, 0, 1}, {4, 0, 0}, {1, 4, 1}}});
        const Rational u = number_traits<Rational>::from_double(unit);
        const Rational common = size(checked(Operation::intersection, a, b)) / (u * u * u);
        CHECK(common == Rational(size(a) + size(b) - size(checked(Operation::union_, a, b))) / (u * u * u));
        CHECK(common ==
              size(checked(Operation::intersection, tetrahedron({{{0, 0, 0}, {4, 0, 1}, {1, 4, 0}, {0, 1, 4}}}),
                           tetrahedron({{{2, 2, 3}, {0, 0, 1}, {4, 0, 0}, {1, 4, 1}}}))) /
                  (u * u * u));
        CHECK(checked(Operation::symmetric_difference, a, a).is_empty());
    }
}

TEST_CASE("A-T13: a result without faces remembers its colour") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> c = ~a;
    const Region<3> all = checked(Operation::union_, a, c);
    CHECK(all.is_full());
    CHECK(!all.is_empty());
    CHECK(!all.is_bounded());
    CHECK(all.face_count() == 0);
    const Region<3> none = checked(Operation::intersection, a, c);
    CHECK(none.is_empty());
    CHECK(none.is_bounded());
    // And it goes on being one.
    CHECK(equal_sets(checked(Operation::intersection, all, a), a));
    CHECK(checked(Operation::difference, none, a).is_empty());
    CHECK(checked(Operation::union_, checked(Operation::difference, all, a), a).is_full());
    CHECK(checked(Operation::symmetric_difference, all, all).is_empty());
}

TEST_CASE("A-T14: operations on no operands and on one") {
    const std::vector<Region<3>> nothing;
    CHECK(checked_evaluate<3, Rational>(BooleanFunction::union_(0), nothing).is_empty());
    CHECK(checked_evaluate<3, Rational>(BooleanFunction::intersection(0), nothing).is_full());
    CHECK(checked_evaluate<3, Rational>(BooleanFunction::symmetric_difference(0), nothing).is_empty());
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    for (const Operation operation : all_operations)
        CHECK(equal_sets(checked_evaluate<3, Rational>(BooleanFunction::from(operation, 1), {a}), a));
    CHECK(equal_sets(checked_evaluate<3, Rational>(~BooleanFunction::operand(0, 1), {a}), Region<3>(~a)));
}

TEST_CASE("A-T15: faces whose first corners are on a line, edges with four faces, coplanar neighbours") {
    // The top is given with three collinear corners first; the side faces keep the extra vertex.
    RationalMesh mesh;
    mesh.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 2}};
    mesh.add_face({3, 2, 1, 0});
    mesh.add_face({4, 8, 5, 6, 7});
    mesh.add_face({0, 1, 5, 8, 4});
    mesh.add_face({1, 2, 6, 5});
    mesh.add_face({2, 3, 7, 6});
    mesh.add_face({3, 0, 4, 7});
    const Region<3> cube = verified(to_region(mesh));
    CHECK(equal_sets(cube, box<3>({0, 0, 0}, {2, 2, 2})));
    CHECK(size(checked(Operation::difference, cube, box<3>({1, -1, 1}, {3, 3, 3}))) == 6);

    // Two cubes that share an edge, as one mesh with four faces at that edge.
    RationalMesh pair = cuboid_mesh({0, 0, 0}, {1, 1, 1}, {});
    const RationalMesh other = cuboid_mesh({1, 1, 0}, {2, 2, 1}, {});
    const auto offset = std::uint32_t(pair.points.size());
    pair.points.insert(pair.points.end(), other.points.begin(), other.points.end());
    for (std::size_t f = 0; f < other.face_count(); ++f) {
        std::vector<std::uint32_t> face;
        for (const std::uint32_t c : other.face(f)) face.push_back(c + offset);
        pair.add_face(face);
    }
    const Region<3> joined = verified(to_region(pair));
    CHECK(size(joined) == 2);
    CHECK(equal_sets(joined, checked(Operation::union_, box<3>({0, 0, 0}, {1, 1, 1}), box<3>({1, 1, 0}, {2, 2, 1}))));
    const Rational h = Rational(1) / 2;
    const Region<3> through = checked(Operation::difference, joined, box<3>({h, h, -1}, {3 * h, 3 * h, 2}));
    CHECK(size(through) == Rational(3) / 2);
}

TEST_CASE("A-T16: an apex with many planes, cut through the apex and along its edges") {
    for (const int sides : {4, 6, 8}) {
        std::vector<Coordinates<3>> corners = {{0, 0, 3}};
        const std::vector<Coordinates<3>> ring = {{3, 0, 0},  {2, 2, 0},   {0, 3, 0},  {-2, 2, 0},
                                                  {-3, 0, 0}, {-2, -2, 0}, {0, -3, 0}, {2, -2, 0}};
        for (int i = 0; i < 8; ++i)
            if (sides == 8 || (sides == 6 && i != 1 && i != 5) || (sides == 4 && i % 2 == 0))
                corners.push_back(ring[std::size_t(i)]);
        const Region<3> pyramid = verified(convex_hull<3>(corners));
        REQUIRE(pyramid.face_count() == std::size_t(sides) + 1);
        const Rational volume = size(pyramid);
        // Halves by symmetry: x <= 0, and the plane through two opposite edges.
        CHECK(size(checked(Operation::intersection, pyramid, box<3>({-9, -9, -9}, {0, 9, 9}))) == volume / 2);
        const Region<3> diagonal = prism<Rational>({{-9, -9}, {9, -9}, {9, 9}}, -9, 9);
        CHECK(size(checked(Operation::difference, pyramid, diagonal)) == volume / 2);
        // A box that touches in the apex only, and one whose corner is the apex.
        const Region<3> above = box<3>({-1, -1, 3}, {1, 1, 5});
        CHECK(checked(Operation::intersection, pyramid, above).is_empty());
        CHECK(size(checked(Operation::union_, pyramid, above)) == volume + 8);
        const Region<3> corner = box<3>({0, 0, 3}, {9, 9, -9});
        if (sides != 6) CHECK(size(checked(Operation::intersection, pyramid, corner)) == volume / 4);
        // Two of them tip to tip, and one into itself upside down.
        std::vector<Coordinates<3>> flipped_corners = corners;
        for (auto& p : flipped_corners) p[2] = 6 - p[2];
        const Region<3> hourglass = checked(Operation::union_, pyramid, convex_hull<3>(flipped_corners));
        CHECK(size(hourglass) == 2 * volume);
        for (auto& p : flipped_corners) p[2] = p[2] - 3;
        const Region<3> star = convex_hull<3>(flipped_corners);
        CHECK(Rational(size(checked(Operation::union_, pyramid, star)) +
                       size(checked(Operation::intersection, pyramid, star))) == 2 * volume);
    }
}

TEST_CASE("A-T18: coplanar faces of one operand do not pile up in its tree") {
    // 2 x 64 coplanar triangles a side: the tree of the cube still needs few cuts for a piece inside.
    const Region<3> cube = cuboid({0, 0, 0}, {8, 8, 8}, {8, true});
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    const Region<3> rest =
        checked_evaluate<3, Rational>(BooleanFunction::difference(2), {cube, box<3>({1, 1, 1}, {2, 2, 2})}, options);
    CHECK(size(rest) == 511);
    CHECK(counts.faces_whole == cube.face_count() + 6);
    CHECK(counts.faces_merged == 0);
    CHECK(counts.trees.piece_splits == 0);
}
