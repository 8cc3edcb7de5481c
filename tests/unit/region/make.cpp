// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/make.hpp>
//
#include "support/catch.hpp"
#include "support/region_checker.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

using Loop = std::vector<std::array<Rational, 2>>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The ends in order of the faces, and which interval each came from.
struct End {
    Rational at;
    bool upper;
    std::uint32_t source;
    friend bool operator==(const End&, const End&) = default;
};

std::vector<End> ends(const Region<1>& region) {
    verified(region);
    const ExactRegion<1> exact(region);
    std::vector<End> list;
    for (std::size_t f = 0; f < exact.faces().size(); ++f) {
        const Source source = region.boundary().faces.faces[f].source;
        CHECK(source.operand == 0);
        list.push_back({exact.faces()[f].loops[0][0][0], exact.faces()[f].plane[0] > 0, source.face});
    }
    return list;
}

Region<2> polygons_of(const std::vector<Loop>& loops) {
    return polygons<Rational>(std::span<const Loop>(loops));
}

Rational area(const Region<2>& region) {
    return ExactRegion<2>(verified(region)).measure();
}

std::string shape_error(const std::vector<Loop>& loops) {
    try {
        (void)polygons_of(loops);
    } catch (const ShapeError& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("make: a coordinate becomes a double exactly where it is one") {
    using Kind = PointRecord<2>::Kind;
    Kernel<2> kernel;
    const Rational tiny = Rational(1) / Rational(number_traits<Rational>::from_double(0x1p1000));
    const Rational third(1, 3);
    const Rational half(1, 2);
    const auto kind = [&](const Rational& x, const Rational& y) {
        const PointId p = add_point<Rational, 2>(kernel, {x, y});
        const Homogeneous<2> h = kernel.coordinates(p);
        CHECK(rational(h[0], h[2]) == x);
        CHECK(rational(h[1], h[2]) == y);
        return kernel.point(p).kind;
    };
    const Rational bits53 = number_traits<Rational>::from_double(0x1p53);
    CHECK(kind(0, half) == Kind::doubles);
    CHECK(kind(-3, Rational(-7) / 8) == Kind::doubles);
    CHECK(kind(Rational(bits53 - 1), 0) == Kind::doubles);
    CHECK(kind(Rational(bits53 + 1), 0) == Kind::integers);  // 54 bits
    CHECK(kind(half, third) == Kind::integers);              // one is enough
    CHECK(kind(tiny, 0) == Kind::doubles);
    CHECK(kind(Rational(tiny / 2), 0) == Kind::integers);
    CHECK(kind(0, Rational(1 / tiny) * Rational(1 / tiny)) == Kind::integers);  // beyond the largest double
    // The least common weight, not the product.
    const PointId p = add_point<Rational, 2>(kernel, {Rational(1, 6), Rational(1, 10)});
    CHECK(kernel.coordinates(p)[2] == Integer(30));
}

TEST_CASE("intervals: ends in order, each from the interval it belongs to") {
    CHECK(ends(intervals({{0, 1}, {2, 3}})) ==
          std::vector<End>{{0, false, 0}, {1, true, 0}, {2, false, 1}, {3, true, 1}});
    // In any order, and with either end first.
    CHECK(ends(intervals({{3, 2}, {1, 0}})) ==
          std::vector<End>{{0, false, 1}, {1, true, 1}, {2, false, 0}, {3, true, 0}});
    CHECK(ends(intervals({{Rational(-1, 3), Rational(1, 7)}})) ==
          std::vector<End>{{Rational(-1, 3), false, 0}, {Rational(1, 7), true, 0}});
}

TEST_CASE("intervals: what overlaps, touches, repeats or is nested is joined") {
    CHECK(ends(intervals({{0, 2}, {1, 3}})) == std::vector<End>{{0, false, 0}, {3, true, 1}});
    CHECK(ends(intervals({{1, 2}, {0, 1}})) == std::vector<End>{{0, false, 1}, {2, true, 0}});
    CHECK(ends(intervals({{0, 9}, {2, 3}, {9, 8}})) == std::vector<End>{{0, false, 0}, {9, true, 0}});
    CHECK(ends(intervals({{0, 1}, {0, 1}, {1, 0}})) == std::vector<End>{{0, false, 0}, {1, true, 0}});
    // Three in a row that touch, the middle one given last; then a gap.
    CHECK(ends(intervals({{0, 1}, {2, 3}, {1, 2}, {4, 5}})) ==
          std::vector<End>{{0, false, 0}, {3, true, 1}, {4, false, 3}, {5, true, 3}});
}

TEST_CASE("intervals: without length they add nothing, and do not join") {
    CHECK(intervals<Rational>({}).is_empty());
    CHECK(intervals({{1, 1}}).is_empty());
    CHECK(ends(intervals({{1, 1}, {0, 1}, {0, 0}, {5, 5}})) == std::vector<End>{{0, false, 1}, {1, true, 1}});
    // Nor where doubles cannot tell the ends apart.
    const Rational tiny = Rational(1) / Rational(number_traits<Rational>::from_double(0x1p1000));
    const Rational third(1, 3);
    const Rational after(third + tiny);
    CHECK(ends(intervals({{third, after}, {third, third}})) == std::vector<End>{{third, false, 0}, {after, true, 0}});
    CHECK(ends(intervals({{0, third}, {after, 1}})).size() == 4);
}

TEST_CASE("intervals: of doubles and of integers; infinite ends are refused") {
    CHECK(ends(Region<1>(intervals<double>({{0.1, 0.5}}))) ==
          std::vector<End>{{number_traits<Rational>::from_double(0.1), false, 0}, {Rational(1, 2), true, 0}});
    CHECK(ends(Region<1>(intervals<Integer>({{Integer(4), Integer(-4)}}))) ==
          std::vector<End>{{-4, false, 0}, {4, true, 0}});
    CHECK_THROWS_AS(intervals<double>({{0.0, 1.0}, {0.0, infinity}}), NumberError);
    CHECK_THROWS_AS(intervals<double>({{-infinity, 0.0}}), NumberError);
    CHECK_THROWS_AS(intervals<double>({{no_number, no_number}}), NumberError);
}

TEST_CASE("polygon: the set is on the left, sources count edges, and -0 is 0") {
    const Region<2> triangle = polygon<Rational>({{0, 0}, {4, 0}, {0, 2}});
    CHECK(area(triangle) == 4);
    REQUIRE(triangle.face_count() == 3);
    for (std::uint32_t f = 0; f < 3; ++f) CHECK(triangle.boundary().faces.faces[f].source == Source{0, f});
    CHECK(ExactRegion<2>(triangle).locate({1, 1}) == Where::inside);
    CHECK(ExactRegion<2>(triangle).locate({2, 1}) == Where::boundary);
    const Region<2, double> zeros = polygon<double>({{0.0, -0.0}, {1.0, 0.0}, {-0.0, 1.0}, {-0.0, 0.0}});
    CHECK(zeros.face_count() == 3);  // the last corner is the first
    CHECK(area(Region<2>(zeros)) == Rational(1, 2));
}

TEST_CASE("polygon: repeated corners count once, straight ones are kept") {
    const Region<2> repeated = polygon<Rational>({{0, 0}, {0, 0}, {2, 0}, {2, 0}, {2, 2}, {0, 0}, {0, 0}});
    CHECK(repeated.face_count() == 3);
    CHECK(area(repeated) == 2);
    // Ends between two collinear segments have lines of their own.
    const Region<2> straight =
        polygon<Rational>({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 2}, {Rational(1, 3), Rational(1, 3)}});
    CHECK(straight.face_count() == 6);
    CHECK(area(straight) == 3);
    CHECK(equal_sets(straight, polygon<Rational>({{0, 0}, {3, 0}, {2, 2}})));
}

TEST_CASE("polygons: holes, islands in holes, and loops that touch") {
    const Loop square = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    const Loop hole = {{1, 1}, {1, 7}, {7, 7}, {7, 1}};
    const Loop island = {{3, 3}, {5, 3}, {5, 5}, {3, 5}};
    const Region<2> nested = polygons_of({square, hole, island});
    CHECK(area(nested) == 64 - 36 + 4);
    for (std::uint32_t f = 0; f < 12; ++f) CHECK(nested.boundary().faces.faces[f].source == Source{0, f});
    CHECK(area(polygons_of({island, hole, square})) == 32);  // in any order
    // A hole with a corner on a side (in its middle and in a corner), and two holes that touch in a corner.
    CHECK(area(polygons_of({square, {{8, 4}, {6, 3}, {6, 5}}})) == 62);
    CHECK(area(polygons_of({square, {{0, 0}, {1, 2}, {2, 1}}})) == Rational(125, 2));
    CHECK(area(polygons_of({square, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{2, 2}, {2, 3}, {3, 3}, {3, 2}}})) == 62);
    // One loop that passes a corner twice: two squares, and a square with a hole.
    CHECK(area(polygons_of({{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}})) == 2);
    CHECK(area(polygons_of({{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 2}, {2, 1}}})) == Rational(15, 2));
    CHECK(polygons_of({}).is_empty());
}

TEST_CASE("polygons: a loop of one or two points is named") {
    const Loop square = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    for (const Loop& flat : {Loop{}, Loop{{1, 1}}, Loop{{1, 1}, {1, 1}, {1, 1}}, Loop{{1, 1}, {2, 2}},
                             Loop{{1, 1}, {2, 2}, {1, 1}}, Loop{{1, 1}, {2, 1}, {1, 1}, {2, 1}}}) {
        CHECK(has(shape_error({square, flat}), "loop 1 has fewer than three different points"));
        CHECK(has(shape_error({flat, square}), "loop 0 "));
    }
    CHECK_THROWS_AS(polygon<Rational>({{0, 0}, {1, 1}}), ShapeError);
}

TEST_CASE("polygons: what runs clockwise or encloses nothing is refused") {
    const Loop square = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    const Loop reversed = {{0, 8}, {8, 8}, {8, 0}, {0, 0}};
    CHECK(shape_error({square}).empty());
    CHECK(has(shape_error({reversed}), "clockwise"));
    CHECK(has(shape_error({{{0, 0}, {1, 1}, {2, 2}}}), "enclose no area"));
    CHECK(has(shape_error({square, reversed}), "enclose no area"));
    CHECK(has(shape_error({{{1, 1}, {2, 1}, {2, 2}}, reversed}), "holes clockwise"));
    // However little area there is, its sign is known.
    const Rational tiny = Rational(1) / Rational(number_traits<Rational>::from_double(0x1p1000));
    CHECK(area(polygons_of({{{0, 0}, {1, 1}, {2, Rational(2 + tiny)}}})) == Rational(tiny / 2));
    CHECK(has(shape_error({{{0, 0}, {1, 1}, {2, Rational(2 - tiny)}}}), "clockwise"));
}

TEST_CASE("polygons: coordinates that are no numbers are refused") {
    CHECK_THROWS_AS(polygon<double>({{0, 0}, {1, 0}, {no_number, 1}}), NumberError);
    CHECK_THROWS_AS(polygon<double>({{0, 0}, {1, 0}, {0, infinity}}), NumberError);
}
