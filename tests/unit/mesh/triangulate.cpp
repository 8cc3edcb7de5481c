// SPDX-License-Identifier: Apache-2.0
/// Triangulation: exact areas, conformity and strict positivity on polygon sets in general and degenerate position.
#include <cleave/mesh/triangulate.hpp>

#include "support/catch.hpp"
#include "support/property.hpp"

#include <cstdlib>
#include <map>
#include <set>

namespace {

using namespace cleave;
using support::property;

struct Point {
    std::int64_t x, y;
    friend bool operator==(const Point&, const Point&) = default;
};

std::int64_t doubled_area(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A set of loops over integer points, interior on the left.
struct PolygonSet {
    std::vector<Point> points;
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> first{0};

    void add(const std::vector<Point>& loop) {
        for (const Point& p : loop) {
            const auto found = std::find(points.begin(), points.end(), p);
            corners.push_back(static_cast<std::uint32_t>(found - points.begin()));
            if (found == points.end()) points.push_back(p);
        }
        first.push_back(static_cast<std::uint32_t>(corners.size()));
    }

    std::int64_t doubled_area_of_loops() const {
        std::int64_t sum = 0;
        for_each_edge(
            [&](std::uint32_t a, std::uint32_t b) { sum += points[a].x * points[b].y - points[a].y * points[b].x; });
        return sum;
    }

    template <class F>
    void for_each_edge(F&& f) const {
        for (std::size_t l = 0; l + 1 < first.size(); ++l) {
            for (std::uint32_t i = first[l]; i < first[l + 1]; ++i) {
                f(corners[i], corners[i + 1 == first[l + 1] ? first[l] : i + 1]);
            }
        }
    }

    auto orient() const {
        return [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            return sign_of_value(doubled_area(points[a], points[b], points[c]));
        };
    }
    auto less() const {
        return [this](std::uint32_t a, std::uint32_t b) {
            return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
        };
    }
    std::optional<std::vector<IndexTriangle>> triangles() const {
        return triangulate(corners, first, orient(), less());
    }
};

/// Directed edges with multiplicity, opposite ones cancelled: the boundary of a chain.
class Chain {
public:
    void add(std::uint32_t a, std::uint32_t b) {
        if (a < b) ++count_[{a, b}];
        if (b < a) --count_[{b, a}];
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> reduced() const {
        auto result = count_;
        std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
        return result;
    }

private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> count_;
};

/// Positive triangles whose boundary is the loops' cover each point as often as the loops wind around it; with the area
/// they cover the set exactly once, and with edges used once in each direction they meet edge to edge.
void check(const PolygonSet& set, const std::vector<IndexTriangle>& triangles, bool edges_are_split = false) {
    std::int64_t area = 0;
    Chain from_triangles;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    std::set<std::uint32_t> used;
    for (const IndexTriangle& t : triangles) {
        const std::int64_t a = doubled_area(set.points[t[0]], set.points[t[1]], set.points[t[2]]);
        REQUIRE(a > 0);
        area += a;
        for (std::size_t i = 0; i < 3; ++i) {
            from_triangles.add(t[i], t[(i + 1) % 3]);
            REQUIRE(++uses[{t[i], t[(i + 1) % 3]}] == 1);
            used.insert(t[i]);
        }
    }
    REQUIRE(area == set.doubled_area_of_loops());
    if (edges_are_split) return;
    Chain from_loops;
    set.for_each_edge([&](std::uint32_t a, std::uint32_t b) { from_loops.add(a, b); });
    REQUIRE(from_triangles.reduced() == from_loops.reduced());
    for (const auto& entry : from_loops.reduced()) {
        REQUIRE(used.count(entry.first.first) == 1);
        REQUIRE(used.count(entry.first.second) == 1);
    }
}

void check(const PolygonSet& set, bool edges_are_split = false) {
    const auto triangles = set.triangles();
    REQUIRE(triangles);
    check(set, *triangles, edges_are_split);
}

PolygonSet polygon(const std::vector<std::vector<Point>>& loops) {
    PolygonSet set;
    for (const auto& loop : loops) set.add(loop);
    return set;
}

/// The boundary of a union of grid cells, as loops that turn left or right at pinch vertices.
PolygonSet boundary_of_cells(const std::vector<std::vector<bool>>& cell, bool turn_left) {
    const auto filled = [&](std::int64_t x, std::int64_t y) {
        return x >= 0 && y >= 0 && y < std::int64_t(cell.size()) && x < std::int64_t(cell[std::size_t(y)].size()) &&
               cell[std::size_t(y)][std::size_t(x)];
    };
    // direction: 0 east, 1 north, 2 west, 3 south; the cell to the left of the edge is filled, the one to the right
    // not.
    const std::array<Point, 4> step{Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}};
    const auto is_edge = [&](Point p, std::size_t d) {
        const std::array<Point, 4> left{Point{0, 0}, Point{-1, 0}, Point{-1, -1}, Point{0, -1}};
        const Point l = left[d], r = left[(d + 3) % 4];
        return filled(p.x + l.x, p.y + l.y) && !filled(p.x + r.x, p.y + r.y);
    };
    PolygonSet set;
    std::set<std::pair<std::pair<std::int64_t, std::int64_t>, std::size_t>> done;
    const auto height = std::int64_t(cell.size()), width = std::int64_t(cell[0].size());
    for (std::int64_t y = 0; y <= height; ++y) {
        for (std::int64_t x = 0; x <= width; ++x) {
            for (std::size_t d0 = 0; d0 < 4; ++d0) {
                if (!is_edge({x, y}, d0) || done.count({{x, y}, d0})) continue;
                std::vector<Point> loop;
                Point p{x, y};
                std::size_t d = d0;
                while (done.insert({{p.x, p.y}, d}).second) {
                    loop.push_back(p);
                    p = {p.x + step[d].x, p.y + step[d].y};
                    const std::array<std::size_t, 3> turns =
                        turn_left ? std::array<std::size_t, 3>{1, 0, 3} : std::array<std::size_t, 3>{3, 0, 1};
                    for (const std::size_t turn : turns) {
                        if (is_edge(p, (d + turn) % 4)) {
                            d = (d + turn) % 4;
                            break;
                        }
                    }
                }
                set.add(loop);
            }
        }
    }
    return set;
}

/// Drops corners on straight stretches where `drop` says so; other loops may keep a vertex there.
PolygonSet without_straight_corners(const PolygonSet& set, const std::vector<bool>& drop) {
    PolygonSet result;
    for (std::size_t l = 0; l + 1 < set.first.size(); ++l) {
        std::vector<Point> loop;
        const std::size_t n = set.first[l + 1] - set.first[l];
        const auto at = [&](std::size_t i) { return set.points[set.corners[set.first[l] + i % n]]; };
        for (std::size_t i = 0; i < n; ++i) {
            const bool straight = doubled_area(at(i + n - 1), at(i), at(i + 1)) == 0;
            if (!straight || !drop[(set.first[l] + i) % drop.size()]) loop.push_back(at(i));
        }
        result.add(loop);
    }
    return result;
}

/// Integer maps of determinant 1: the same polygon set in a position where no edge is axis-parallel.
void shear(PolygonSet& set, std::int64_t a, std::int64_t b) {
    for (Point& p : set.points) {
        p.x += a * p.y;
        p.y += b * p.x;
    }
}

/// A star-shaped polygon around the origin, through each direction once, at random distance.
std::vector<Point> star(const std::vector<std::pair<int, int>>& seeds) {
    std::vector<Point> corners{{-4, -3}, {5, -2}, {1, 6}};
    for (const auto& [x, y] : seeds) {
        if (x != 0 || y != 0) corners.push_back({x, y});
    }
    const auto upper = [](const Point& p) { return p.y > 0 || (p.y == 0 && p.x > 0); };
    const auto cross = [](const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; };
    std::stable_sort(corners.begin(), corners.end(),
                     [&](const Point& p, const Point& q) { return upper(p) != upper(q) ? upper(p) : cross(p, q) > 0; });
    corners.erase(
        std::unique(corners.begin(), corners.end(),
                    [&](const Point& p, const Point& q) { return cross(p, q) == 0 && p.x * q.x + p.y * q.y > 0; }),
        corners.end());
    return corners;
}

/// Pairs of numbers from first to past - 1.
std::vector<std::pair<int, int>> draw_pairs(int first, int past) {
    return support::draw_list([=] {
        const std::vector<int> drawn = support::draw_ints(2, first, past);
        return std::pair(drawn[0], drawn[1]);
    });
}

void draw_shear(PolygonSet& set, int most) {
    const std::vector<int> drawn = support::draw_ints(2, -most, most + 1);
    shear(set, drawn[0], drawn[1]);
}

}  // namespace

TEST_CASE("triangulate: a triangle is itself") {
    const PolygonSet set = polygon({{{0, 0}, {4, 0}, {1, 3}}});
    REQUIRE(*set.triangles() == std::vector<IndexTriangle>{{0, 1, 2}});
}

TEST_CASE("triangulate: convex, reflex and dart-shaped quadrilaterals in every rotation") {
    const std::vector<std::vector<Point>> quads{{{0, 0}, {2, 0}, {2, 2}, {0, 2}},
                                                {{0, 0}, {4, 0}, {1, 1}, {0, 4}},
                                                {{0, 0}, {2, 0}, {4, 0}, {1, 3}},
                                                {{0, 0}, {3, -1}, {1, 0}, {3, 1}}};
    for (const auto& quad : quads) {
        for (std::size_t s = 0; s < 4; ++s) {
            std::vector<Point> rotated = quad;
            std::rotate(rotated.begin(), rotated.begin() + std::ptrdiff_t(s), rotated.end());
            const PolygonSet set = polygon({rotated});
            check(set);
            REQUIRE(set.triangles()->size() == 2);
        }
    }
}

TEST_CASE("triangulate: the diagonal of a quadrilateral does not depend on the corner its loop starts at") {
    const std::vector<Point> quad{{0, 0}, {3, 1}, {4, 4}, {1, 3}};
    std::set<std::set<std::pair<std::int64_t, std::int64_t>>> diagonals;
    for (std::size_t s = 0; s < 4; ++s) {
        std::vector<Point> rotated = quad;
        std::rotate(rotated.begin(), rotated.begin() + std::ptrdiff_t(s), rotated.end());
        const PolygonSet set = polygon({rotated});
        const auto triangles = *set.triangles();
        std::set<std::pair<std::int64_t, std::int64_t>> shared;
        for (const std::uint32_t v : triangles[0]) {
            if (std::find(triangles[1].begin(), triangles[1].end(), v) != triangles[1].end()) {
                shared.insert({set.points[v].x, set.points[v].y});
            }
        }
        diagonals.insert(shared);
    }
    REQUIRE(diagonals.size() == 1);
}

TEST_CASE("triangulate: corners on straight edges are all used and cost no flat triangle") {
    const PolygonSet set = polygon({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {0, 3}, {0, 2}}});
    check(set);
    REQUIRE(set.triangles()->size() == 8);
    // A triangle with every other corner on its sides: the sweep meets three collinear runs.
    check(polygon({{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {6, 0}, {4, 2}, {3, 3}, {2, 4}, {0, 6}, {0, 5}, {0, 1}}}));
    // All corners but one on one line.
    check(polygon({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 1}}}));
    check(polygon({{{2, -1}, {4, 0}, {3, 0}, {2, 0}, {1, 0}, {0, 0}}}));
}

TEST_CASE("triangulate: holes") {
    const PolygonSet square_in_square = polygon({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}});
    check(square_in_square);
    REQUIRE(square_in_square.triangles()->size() == 8);
    // An island in the hole, and loops given inside out of order.
    check(polygon(
        {{{3, 3}, {3, 6}, {6, 6}, {6, 3}}, {{4, 4}, {5, 4}, {5, 5}, {4, 5}}, {{0, 0}, {9, 0}, {9, 9}, {0, 9}}}));
    // Holes whose corners are collinear with each other and with the outer corners.
    check(polygon({{{0, 0}, {8, 0}, {8, 8}, {0, 8}},
                   {{1, 1}, {1, 2}, {2, 2}, {2, 1}},
                   {{3, 3}, {3, 4}, {4, 4}, {4, 3}},
                   {{5, 5}, {5, 7}, {7, 7}, {7, 5}},
                   {{5, 1}, {5, 2}, {6, 2}, {6, 1}}}));
}

TEST_CASE("triangulate: loops that touch in vertices") {
    // Two holes in one vertex; a hole in an outer vertex; a hole in two outer vertices (the set falls apart there).
    check(polygon(
        {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}, {{4, 4}, {4, 6}, {6, 6}, {6, 4}}}));
    check(polygon({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{0, 0}, {2, 4}, {4, 2}}}));
    check(polygon({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{0, 0}, {2, 6}, {8, 8}, {6, 2}}}));
    // A figure of eight as one loop, and four squares around a vertex as one loop.
    check(polygon({{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}}));
    check(polygon({{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}}));
}

TEST_CASE("triangulate: a bridge to a hole bounds nothing") {
    const std::vector<Point> keyhole{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}};
    check(polygon({keyhole}));
    REQUIRE(polygon({keyhole}).triangles()->size() == 8);
    // A bridge by way of a vertex that has no other edge: it is inside the set and is used all the same.
    const PolygonSet set =
        polygon({{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {2, 1}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}, {2, 1}}});
    check(set);
    std::set<std::uint32_t> used;
    const auto triangles = *set.triangles();
    for (const IndexTriangle& t : triangles) used.insert(t.begin(), t.end());
    REQUIRE(used.size() == set.points.size());
    // A spike to the outside and one along an edge.
    check(polygon({{{0, 0}, {4, 0}, {4, 4}, {7, 5}, {4, 4}, {0, 4}}}));
    check(polygon({{{0, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}}}), true);
}

TEST_CASE("triangulate: a vertex inside an edge splits it") {
    check(polygon({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{0, 4}, {4, 6}, {4, 2}}}), true);
    check(polygon({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{4, 0}, {2, 4}, {6, 4}}}), true);
    check(polygon({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 0}, {2, 4}, {4, 4}, {4, 0}}}), true);
    check(polygon({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{2, 1}, {4, 0}, {4, 2}}}), true);
}

TEST_CASE("triangulate: a set without area has no triangles") {
    REQUIRE(polygon({{{0, 0}, {1, 1}, {3, 3}}}).triangles()->empty());
    REQUIRE(polygon({{{0, 0}, {3, 3}, {1, 1}}}).triangles()->empty());
    REQUIRE(polygon({{{0, 0}, {0, 5}, {0, 2}, {0, 7}, {0, 1}}}).triangles()->empty());
    REQUIRE(polygon({{{0, 0}, {4, 1}}}).triangles()->empty());
    REQUIRE(polygon({{{0, 0}}}).triangles()->empty());
    REQUIRE(polygon({}).triangles()->empty());
    REQUIRE(polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 4}, {4, 4}, {4, 0}, {0, 0}}}).triangles()->empty());
}

TEST_CASE("triangulate: crossing and wrongly turned loops are refused and leave the output alone") {
    const std::vector<std::vector<std::vector<Point>>> bad{
        {{{0, 0}, {0, 4}, {4, 4}, {4, 0}}},                                      // clockwise
        {{{0, 0}, {4, 4}, {4, 0}, {0, 4}}},                                      // bow tie
        {{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 12}, {6, 12}, {6, 3}}},  // a hole that leaves
        {{{0, 0}, {4, 0}, {4, 4}}, {{0, 0}, {4, 0}, {4, 4}}},                    // the same loop twice
        {{{0, 0}, {0, 3}, {3, 0}}},                                              // a clockwise triangle
        {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}, {{2, 2}, {2, 5}, {5, 5}, {5, 2}}}};
    for (const auto& loops : bad) {
        const PolygonSet set = polygon(loops);
        Triangulator triangulator;
        std::vector<IndexTriangle> out{{7, 8, 9}};
        REQUIRE_FALSE(triangulator.triangulate(set.corners, set.first, set.orient(), set.less(), out));
        REQUIRE(out == std::vector<IndexTriangle>{{7, 8, 9}});
    }
}

TEST_CASE("triangulate: indices with equal points are one vertex") {
    PolygonSet set;
    set.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {4, 4}, {2, 2}, {4, 4}, {3, 8}};
    set.corners = {0, 1, 2, 3, 6, 7, 0};  // the corner (4, 4) appears as 2 and as 6
    set.corners = {0, 1, 4, 3};
    set.first = {0, 4};
    REQUIRE(set.triangles()->size() == 2);
    set.corners = {0, 1, 6, 4, 2, 3};
    set.first = {0, 6};
    const auto triangles = *set.triangles();
    std::set<std::uint32_t> used;
    for (const IndexTriangle& t : triangles) used.insert(t.begin(), t.end());
    REQUIRE(used == std::set<std::uint32_t>{0, 1, 2, 3});
}

TEST_CASE("triangulate: unions of grid cells, with pinches, holes and collinear corners") {
    property("every union of grid cells is covered exactly, conforming, without flat triangles", [] {
        const std::size_t width = 1 + support::draw_index(8);
        const std::size_t height = 1 + support::draw_index(8);
        const std::vector<bool> cells = support::draw_bools(width * height);
        std::vector<std::vector<bool>> grid(height);
        for (std::size_t y = 0; y < height; ++y) {
            grid[y].assign(cells.begin() + std::ptrdiff_t(y * width), cells.begin() + std::ptrdiff_t((y + 1) * width));
        }
        PolygonSet set = boundary_of_cells(grid, support::draw_bool());
        draw_shear(set, 3);
        check(set);
        RC_ASSERT(set.doubled_area_of_loops() == 2 * std::count(cells.begin(), cells.end(), true));

        // Straight corners dropped at random: other loops now touch edges in their interior.
        const std::vector<bool> drop = support::draw_bools(13);
        check(without_straight_corners(set, drop), true);
    });
}

TEST_CASE("triangulate: star-shaped polygons with a star-shaped hole") {
    property("every star-shaped polygon is covered exactly", [] {
        const auto seeds = draw_pairs(-6, 7);
        const std::vector<Point> outline = star(seeds);
        check(polygon({outline}));

        // Scaled three times it contains itself, and may touch it nowhere.
        std::vector<Point> outer = outline;
        for (Point& p : outer) p = {3 * p.x, 3 * p.y};
        const std::vector<Point> hole(outline.rbegin(), outline.rend());
        check(polygon({outer, hole}));
        check(polygon({hole, outer}));
        PolygonSet sheared = polygon({outer, hole});
        draw_shear(sheared, 2);
        check(sheared);
    });
}

TEST_CASE("triangulate: any closed walk either fails or is covered as often as it winds") {
    property("no crash, no flat triangle, and the right boundary on success", [] {
        const auto walk = draw_pairs(0, 5);
        std::vector<Point> loop;
        for (const auto& [x, y] : walk) loop.push_back({x, y});
        const PolygonSet set = polygon({loop});
        if (const auto triangles = set.triangles()) {
            std::int64_t area = 0;
            for (const IndexTriangle& t : *triangles) {
                const std::int64_t a = doubled_area(set.points[t[0]], set.points[t[1]], set.points[t[2]]);
                RC_ASSERT(a > 0);
                area += a;
            }
            RC_ASSERT(area == set.doubled_area_of_loops());
        }
    });
}

TEST_CASE("triangulate: a comb whose teeth are all open at once takes n log n") {
    // Teeth along y, their tips to the right and all roots at x = 0: ten thousand slabs live at the same time.
    constexpr std::uint32_t teeth = 10000;
    PolygonSet set;
    for (std::uint32_t i = 0; i < teeth; ++i) {
        set.points.push_back({i % 7, 4 * std::int64_t(i)});
        set.points.push_back({100 + i % 5, 4 * std::int64_t(i) + 1});
        set.points.push_back({i % 3, 4 * std::int64_t(i) + 2});
    }
    set.points.push_back({200, 4 * teeth});
    set.points.push_back({200, -1});
    for (std::uint32_t i = 0; i < set.points.size(); ++i)
        set.corners.push_back(std::uint32_t(set.points.size()) - 1 - i);
    set.first.push_back(std::uint32_t(set.corners.size()));
    std::size_t turns = 0;
    Triangulator triangulator;
    std::vector<IndexTriangle> triangles;
    const auto orient = set.orient();
    REQUIRE(triangulator.triangulate(
        set.corners, set.first,
        [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            ++turns;
            return orient(a, b, c);
        },
        set.less(), triangles));
    check(set, triangles);
    REQUIRE(turns < 40 * set.points.size());
}

TEST_CASE("triangulate: edges that overlap by the thousand on one line cost no more than others") {
    // To and fro between two clusters of a line, and once off it: what remains is a triangle with many corners.
    constexpr std::int64_t n = 20000;
    std::vector<Point> points;
    PolygonSet set;
    for (std::int64_t i = 0; i < n; ++i) {
        points.push_back({i, 2 * i});
        points.push_back({2 * n + (i * 7919) % n, 2 * (2 * n + (i * 7919) % n)});
    }
    points.push_back({0, 10 * n});
    set.points = points;
    for (std::uint32_t i = 0; i < points.size(); ++i) set.corners.push_back(i);
    set.first.push_back(static_cast<std::uint32_t>(points.size()));
    std::size_t turns = 0;
    Triangulator triangulator;
    std::vector<IndexTriangle> triangles;
    const auto orient = set.orient();
    const auto counted = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        ++turns;
        return orient(a, b, c);
    };
    if (triangulator.triangulate(set.corners, set.first, counted, set.less(), triangles)) check(set, triangles, true);
    REQUIRE(turns < 60 * points.size());
}
