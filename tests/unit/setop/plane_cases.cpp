// SPDX-License-Identifier: Apache-2.0
// Worked cases in the plane: exact areas, loops and points of named polygons.
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/region_checker.hpp"
#include "support/segments.hpp"

#include <cleave/query/measure.hpp>
#include <cleave/region/make.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/hull.hpp>

#include <vector>

using namespace cleave;
using namespace support;

namespace {

using Loop = std::vector<Coordinates<2>>;

Region<2> from_loops(const std::vector<Loop>& loops) {
    return verified(polygons<Rational>(loops));
}

Rational area(const Region<2>& r) {
    const Rational a = ExactRegion<2>(r).measure();
    CHECK(measure(r).value() == a);
    return a;
}

Rational length(const Region<2>& r) {
    return ExactRegion<2>(r).boundary_measure();
}

struct Areas {
    Rational common, join, left, right, odd;
};

void check_areas(const Region<2>& a, const Region<2>& b, const Areas& expected) {
    CHECK(area(checked(Operation::intersection, a, b)) == expected.common);
    CHECK(area(checked(Operation::union_, a, b)) == expected.join);
    CHECK(area(checked(Operation::difference, a, b)) == expected.left);
    CHECK(area(checked(Operation::difference, b, a)) == expected.right);
    CHECK(area(checked(Operation::symmetric_difference, a, b)) == expected.odd);
}

/// Coordinates times `unit`.
Loop times(const Rational& unit, Loop loop) {
    for (Coordinates<2>& p : loop)
        for (Rational& x : p) x *= unit;
    return loop;
}

const Loop square = {{8, 8}, {24, 8}, {24, 24}, {8, 24}};
const Loop s_shape = {{24, 10}, {28, 10}, {28, 16}, {22, 16}, {22, 19}, {24, 19},
                      {24, 22}, {20, 22}, {20, 13}, {26, 13}, {26, 12}, {24, 12}};
const Loop inverted_l = {{4, 4}, {12, 4}, {12, 12}, {8, 12}, {8, 24}, {20, 24}, {20, 20}, {28, 20}, {28, 28}, {4, 28}};
const std::vector<Loop> holed_triangle = {{{4, 4}, {28, 4}, {4, 28}}, {{8, 6}, {12, 12}, {12, 6}}};

}  // namespace

TEST_CASE("plane: square, S, inverted L and triangle with a hole, at size 32 and at size 1") {
    for (const Rational& unit : {Rational(1), Rational(Rational(1) / 32), Rational(Rational(1) / 3)}) {
        const Rational u = unit * unit;
        const auto areas = [&](int common, int join, int left, int right, int odd) {
            return Areas{Rational(common * u), Rational(join * u), Rational(left * u), Rational(right * u),
                         Rational(odd * u)};
        };
        const Region<2> q = from_loops({times(unit, square)});
        const Region<2> s = from_loops({times(unit, s_shape)});
        const Region<2> l = from_loops({times(unit, inverted_l)});
        const Region<2> t = from_loops({times(unit, holed_triangle[0]), times(unit, holed_triangle[1])});
        CHECK(area(q) == 256 * u);
        CHECK(area(s) == 52 * u);
        CHECK(area(l) == 240 * u);
        CHECK(area(t) == 276 * u);
        check_areas(q, s, areas(30, 278, 226, 22, 248));
        check_areas(l, q, areas(32, 464, 208, 224, 432));
        check_areas(l, s, areas(8, 284, 232, 44, 276));
        for (const Region<2>& other : {q, s, l}) {
            const Rational common = area(checked(Operation::intersection, t, other));
            CHECK(area(checked(Operation::union_, t, other)) == Rational(276 * u + area(other) - common));
            CHECK(area(checked(Operation::difference, t, other)) == Rational(276 * u - common));
        }
    }
}

TEST_CASE("plane: two squares that overlap in a corner have the loops of the drawing") {
    const Region<2> a = box<2>({0, 0}, {2, 2});
    const Region<2> b = box<2>({1, 1}, {3, 3});
    const Region<2> join = checked(Operation::union_, a, b);
    const Loop outline = {{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 2}, {0, 2}};
    CHECK(area(join) == 7);
    CHECK(length(join) == 12);
    CHECK(ExactRegion<2>(join).centroid() == Coordinates<2>{Rational(3) / 2, Rational(3) / 2});
    CHECK(boundary_segments(join) == loop_segments({outline}));
    // Points on a cut are not on the boundary unless the two sides differ.
    for (const Coordinates<2>& p :
         {Coordinates<2>{1, 1}, Coordinates<2>{Rational(3) / 2, Rational(3) / 2}, Coordinates<2>{2, 2}})
        CHECK(ExactRegion<2>(join).locate(p) == Where::inside);

    CHECK(boundary_segments(checked(Operation::intersection, a, b)) ==
          loop_segments({{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}));
    const Region<2> left = checked(Operation::difference, a, b);
    CHECK(boundary_segments(left) == loop_segments({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}));
    for (const Coordinates<2>& p : {Coordinates<2>{2, Rational(3) / 2}, Coordinates<2>{2, 2},
                                    Coordinates<2>{Rational(5) / 2, 1}, Coordinates<2>{3, Rational(5) / 2}})
        CHECK(ExactRegion<2>(left).locate(p) == Where::outside);
    CHECK(boundary_segments(checked(Operation::symmetric_difference, a, b)) ==
          loop_segments({outline, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}));
}

TEST_CASE("plane: a square with a square hole, and its complement") {
    const Region<2> ring = checked(Operation::difference, box<2>({0, 0}, {3, 3}), box<2>({1, 1}, {2, 2}));
    CHECK(area(ring) == 8);
    CHECK(length(ring) == 16);
    CHECK(ExactRegion<2>(ring).centroid() == Coordinates<2>{Rational(3) / 2, Rational(3) / 2});
    CHECK(boundary_segments(ring) ==
          loop_segments({{{0, 3}, {0, 0}, {3, 0}, {3, 3}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}));
    const Region<2> outside = verified(~ring);
    CHECK(!measure(outside).has_value());
    CHECK(boundary_segments(outside) ==
          loop_segments({{{0, 0}, {0, 3}, {3, 3}, {3, 0}}, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}}));
    const Rational half = Rational(1) / 2;
    for (const Coordinates<2>& p : {Coordinates<2>{1, 1}, Coordinates<2>{3 * half, 0}, Coordinates<2>{3 * half, 1},
                                    Coordinates<2>{3 * half, 2}, Coordinates<2>{3 * half, 3}, Coordinates<2>{3, 3}})
        CHECK(ExactRegion<2>(ring).locate(p) == Where::boundary);
    CHECK(ExactRegion<2>(ring).locate({3 * half, 3 * half}) == Where::outside);
    CHECK(ExactRegion<2>(outside).locate({3 * half, 3 * half}) == Where::inside);
}

TEST_CASE("plane: a notch cut, filled and cut again, then inverted") {
    const Region<2> hole = ~box<2>({1, 1}, {2, 2});
    const Region<2> first = checked(Operation::intersection, box<2>({0, 0}, {3, 3}), hole);
    const Region<2> wide = checked(Operation::union_, first, box<2>({3, 0}, {6, 3}));
    const Region<2> slot = checked(Operation::difference, wide, box<2>({2, 1}, {5, 2}));
    CHECK(area(slot) == 14);
    CHECK(length(slot) == 28);
    const Region<2> inverted = checked(Operation::symmetric_difference, slot, Region<2>::full());
    CHECK(boundary_segments(inverted) ==
          loop_segments({{{0, 0}, {0, 3}, {6, 3}, {6, 0}}, {{1, 1}, {5, 1}, {5, 2}, {1, 2}}}));
}

TEST_CASE("plane: quadrilateral and triangle with decimal corners") {
    const auto tenth = [](int n) { return Rational(Rational(n) / 10); };
    const Region<2> a = from_loops({{{0, 0}, {4, 0}, {tenth(14), tenth(15)}, {0, tenth(35)}}});
    const Region<2> b = from_loops({{{tenth(14), tenth(2)}, {tenth(28), tenth(-12)}, {tenth(25), tenth(6)}}});
    CHECK(area(a) == Rational(109) / 20);
    CHECK(area(b) == Rational(21) / 20);
    CHECK(area(checked(Operation::intersection, a, b)) == Rational(9) / 20);
    const Region<2> join = checked(Operation::union_, a, b);
    CHECK(area(join) == Rational(121) / 20);
    CHECK(boundary_segments(join) == loop_segments({{{0, 0},
                                                     {tenth(16), 0},
                                                     {tenth(28), tenth(-12)},
                                                     {tenth(26), 0},
                                                     {4, 0},
                                                     {tenth(14), tenth(15)},
                                                     {0, tenth(35)}}}));
}

TEST_CASE("plane: small named polygons") {
    const Region<2> opposite = from_loops({{{1, 0}, {2, 1}, {3, 1}, {2, 2}, {1, 1}, {0, 1}}});
    CHECK(area(opposite) == 2);
    const Region<2> bow = checked(Operation::union_, box<2>({0, 0}, {1, 1}), box<2>({-1, -1}, {0, 0}));
    CHECK(area(bow) == 2);
    CHECK(length(bow) == 8);
    CHECK(ExactRegion<2>(bow).locate({0, 0}) == Where::boundary);
    const Rational half = Rational(1) / 2;
    CHECK(checked(Operation::difference, box<2>({-half, 7 * half}, {half, 9 * half}), box<2>({-1, 2}, {1, 8}))
              .is_empty());

    // Concentric hexagons, h = 7/8 in place of the square root of 3/4.
    const auto hexagon = [](const Rational& r) {
        const Rational x = r / 2;
        const Rational y = r * 7 / 8;
        return polygon<Rational>(
            {{r, 0}, {x, y}, {Rational(-x), y}, {Rational(-r), 0}, {Rational(-x), Rational(-y)}, {x, Rational(-y)}});
    };
    CHECK(checked(Operation::difference, hexagon(half), hexagon(1)).is_empty());
    CHECK(!checked(Operation::difference, hexagon(1), hexagon(half)).is_empty());

    const Region<2> winding = from_loops(
        {{{36, 22}, {39, 32}, {19, 32}, {6, 16}, {31, 10}, {42, 16}, {34, 20}, {29, 19}, {23, 22}, {33, 25}}});
    CHECK(area(winding) == 462);
    const ExactRegion<2> exact(winding);
    for (const auto& p : std::vector<Coordinates<2>>{{30, 15}, {15, 20}, {24, 25}, {35, 30}, {19, 17}})
        CHECK(exact.locate(p) == Where::inside);
    for (const auto& p :
         std::vector<Coordinates<2>>{{50, 30}, {30, 35}, {10, 25}, {10, 10}, {40, 10}, {50, 15}, {30, 22}})
        CHECK(exact.locate(p) == Where::outside);
    for (const auto& p : std::vector<Coordinates<2>>{{30, 32}, {34, 20}}) CHECK(exact.locate(p) == Where::boundary);

    const Region<2> thin = box<2>({0, 0}, {1, Rational(1) / 64});
    CHECK(area(thin) == Rational(1) / 64);
    CHECK(length(thin) == 2 * (1 + Rational(1) / 64));

    // The set that no point satisfies: x < 0 and x > 1, here within a window.
    const Region<2> window = box<2>({-9, -9}, {9, 9});
    CHECK(checked(Operation::intersection, checked(Operation::intersection, window, box<2>({-9, -9}, {0, 9})),
                  box<2>({1, -9}, {9, 9}))
              .is_empty());
}

TEST_CASE("plane: two triangles point at each other") {
    const Region<2> a = from_loops({{{2, 0}, {-4, 3}, {-4, -3}}});
    const Region<2> b = from_loops({{{-2, 0}, {4, -3}, {4, 3}}});
    check_areas(a, b, {4, 32, 14, 14, 28});
}

TEST_CASE("plane: touching squares have no intersection and one outline") {
    const Region<2> a = box<2>({0, 0}, {5, 5});
    const Region<2> b = box<2>({5, 0}, {10, 5});
    CHECK(checked(Operation::intersection, a, b).is_empty());
    const Region<2> join = checked(Operation::union_, a, b);
    CHECK(area(join) == 50);
    CHECK(length(join) == 30);
    CHECK(boundary_segments(join) == loop_segments({{{0, 0}, {10, 0}, {10, 5}, {0, 5}}}));
    CHECK(ExactRegion<2>(join).plane_count() == 4);
    CHECK(area(checked(Operation::symmetric_difference, a, b)) == 50);
    CHECK(equal_sets(checked(Operation::difference, a, b), a));
}

TEST_CASE("plane: C-T7, three boxes with edges on one line that do not touch, in every order") {
    const std::vector<Region<2>> boxes = {box<2>({2, 3}, {3, 4}), box<2>({3, 1}, {4, 2}), box<2>({0, 2}, {4, 4})};
    std::vector<std::size_t> order = {0, 1, 2};
    do {
        const Region<2> join =
            checked(Operation::union_, checked(Operation::union_, boxes[order[0]], boxes[order[1]]), boxes[order[2]]);
        CHECK(area(join) == 9);
        CHECK(boundary_segments(join) == loop_segments({{{0, 2}, {3, 2}, {3, 1}, {4, 1}, {4, 4}, {0, 4}}}));
    } while (std::next_permutation(order.begin(), order.end()));
    CHECK(area(checked_evaluate<2, Rational>(BooleanFunction::union_(3), boxes)) == 9);
}

TEST_CASE("plane: C-T3, the bow-tie as one loop that touches itself") {
    const Region<2> bow = from_loops({{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}});
    CHECK(area(bow) == 2);
    CHECK(area(checked(Operation::intersection, bow, box<2>({0, 0}, {2, 1}))) == 1);
    CHECK(area(checked(Operation::difference, box<2>({0, 0}, {2, 2}), bow)) == 2);
    CHECK(area(checked(Operation::union_, bow, box<2>({0, 0}, {1, 1}))) == Rational(5) / 2);
}

TEST_CASE("plane: skewed bow-tie of two triangles that overlap") {
    const Region<2> right = from_loops({{{-1, 0}, {4, 0}, {4, 5}}});
    const Region<2> left = from_loops({{{1, 0}, {-4, 0}, {-4, -5}}});
    const Region<2> bow = checked(Operation::union_, right, left);
    CHECK(area(bow) == 25);
    const ExactRegion<2> exact(bow);
    for (const auto& p : std::vector<Coordinates<2>>{{3, 1}, {-3, -1}, {0, 0}}) CHECK(exact.locate(p) == Where::inside);
    for (const auto& p : std::vector<Coordinates<2>>{{-3, 1}, {3, -1}, {5, 0}, {-5, 0}})
        CHECK(exact.locate(p) == Where::outside);
    for (const auto& p : std::vector<Coordinates<2>>{{4, 5}, {-4, -5}, {4, 0}, {1, 0}, {-1, 0}, {-4, 0}})
        CHECK(exact.locate(p) == Where::boundary);
    const Region<2> c = ~bow;
    CHECK(checked(Operation::union_, bow, c).is_full());
    CHECK(checked(Operation::intersection, bow, c).is_empty());
    CHECK(checked(Operation::difference, bow, bow).is_empty());
    CHECK(checked(Operation::symmetric_difference, bow, c).is_full());
}

TEST_CASE("plane: unions of convex cells, the exact fractions of the planar arrangement cases 1 to 3") {
    const std::vector<Coordinates<2>> v1 = {{3, 0},  {11, 0}, {13, 10}, {10, 11}, {8, 11}, {6, 11},
                                            {4, 11}, {1, 10}, {4, 3},   {6, 4},   {8, 4},  {10, 3}};
    const std::vector<Coordinates<2>> v2 = {{0, 3}, {14, 2}, {14, 5}, {14, 7}, {14, 11}, {0, 8}, {3, 7}, {3, 5}};
    using Cell = std::vector<std::size_t>;
    const std::vector<Cell> f1 = {{0, 1, 8, 9, 10, 11}, {1, 2, 11}, {3, 10, 11}, {4, 5, 9, 10}, {6, 8, 9}, {0, 7, 8}};
    const std::vector<Cell> f2 = {{0, 5, 6, 7}, {0, 1, 7}, {4, 5, 6}, {2, 3, 6, 7}};
    const auto extended = [](std::vector<Cell> cells, const std::vector<Cell>& more) {
        cells.insert(cells.end(), more.begin(), more.end());
        return cells;
    };
    const auto solid = [](const std::vector<Coordinates<2>>& points, const std::vector<Cell>& cells) {
        Region<2> sum = Region<2>::empty();
        for (const Cell& cell : cells) {
            std::vector<Coordinates<2>> corners;
            for (const std::size_t i : cell) corners.push_back(points[i]);
            sum = checked(Operation::union_, sum, convex_hull<2>(corners));
        }
        return sum;
    };
    const Region<2> a = solid(v1, f1);
    const Region<2> a_plus = solid(v1, extended(f1, {{2, 3, 11}, {3, 4, 10}, {5, 6, 9}, {6, 7, 8}}));
    const Region<2> b = solid(v2, f2);
    const Region<2> b_plus = solid(v2, extended(f2, {{1, 2, 7}, {3, 4, 6}}));
    CHECK(area(a) == 71);
    CHECK(area(a_plus) == 109);
    CHECK(area(b) == Rational(119) / 2);
    CHECK(area(b_plus) == 98);
    const auto over = [](const char* den, const char* join, const char* common, const char* left, const char* right,
                         const char* odd) {
        const auto fraction = [den](const char* num) {
            return Rational(Rational(std::string(num)) / Rational(std::string(den)));
        };
        return Areas{fraction(common), fraction(join), fraction(left), fraction(right), fraction(odd)};
    };
    check_areas(a_plus, b_plus, over("119209", "16037015", "8639248", "4354533", "3043234", "7397767"));
    check_areas(a, b_plus,
                over("663278876", "81795990109", "30298139935", "16794660261", "34703189913", "51497850174"));
    check_areas(a, b,
                over("4640080134466920", "466263151693710227", "139267305854222833", "190178383692928487",
                     "136817462146558907", "326995845839487394"));
}

TEST_CASE("plane: squares and rooms, the planar arrangement cases 4, 5, 7 and 10") {
    const auto q = [](int n) { return Rational(Rational(n) / 2); };
    check_areas(box<2>({0, 0}, {10, 10}), box<2>({q(5), q(5)}, {q(25), q(25)}),
                {Rational(225) / 4, Rational(575) / 4, Rational(175) / 4, Rational(175) / 4, Rational(175) / 2});
    check_areas(box<2>({0, 0}, {5, 5}), box<2>({5, 0}, {10, 5}), {0, 50, 25, 25, 50});
    check_areas(box<2>({0, 0}, {10, 10}), box<2>({q(5), q(5)}, {q(15), q(15)}), {25, 100, 75, 0, 75});
    const std::vector<Region<2>> rooms = {box<2>({1, 1}, {7, 6}), box<2>({8, 1}, {14, 7}), box<2>({1, 7}, {7, 13}),
                                          box<2>({8, 8}, {14, 13})};
    const Region<2> flat = checked_evaluate<2, Rational>(BooleanFunction::union_(4), rooms);
    CHECK(area(flat) == 132);
    check_areas(box<2>({0, 0}, {15, 14}), flat, {132, 210, 78, 0, 78});
}

TEST_CASE("plane: rectangles in strips") {
    const Region<2> a = box<2>({0, 0}, {2, 2});
    const Region<2> b = box<2>({1, 1}, {3, 3});
    const auto strips = [](const std::vector<std::array<int, 4>>& list) {
        std::vector<Region<2>> parts;
        for (const auto& r : list) parts.push_back(box<2>({r[0], r[1]}, {r[2], r[3]}));
        return checked_evaluate<2, Rational>(BooleanFunction::union_(unsigned(parts.size())), parts);
    };
    CHECK(equal_sets(a | b, strips({{0, 0, 2, 1}, {0, 1, 3, 2}, {1, 2, 3, 3}})));
    CHECK(equal_sets(a & b, strips({{1, 1, 2, 2}})));
    CHECK(equal_sets(a - b, strips({{0, 0, 2, 1}, {0, 1, 1, 2}})));
    CHECK(equal_sets(a ^ b, strips({{0, 0, 2, 1}, {0, 1, 1, 2}, {2, 1, 3, 2}, {1, 2, 3, 3}})));
}
