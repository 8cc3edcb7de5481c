// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/clip_3d.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/facet_generators.hpp"
#include "support/facet_measure.hpp"

#include <cleave/clip/make_facet.hpp>

#include <algorithm>
#include <optional>
#include <vector>

using namespace cleave;
using support::property;

namespace {

/// The polygon in the plane z = 0 with the given x, y, seen from above.
template <class N>
Facet<3, N> flat(std::initializer_list<std::pair<int, int>> corners) {
    std::vector<Point<3, N>> points;
    for (const auto& [x, y] : corners) points.push_back(make_point<N>(x, y, 0));
    return *make_facet(points);
}

/// Whether the facet has exactly these vertices, in this cyclic order.
template <class N>
bool has_vertices(const Facet<3, N>& f, std::vector<Point<3, N>> expected) {
    const std::vector<Point<3, N>> points = vertices(f);
    if (points.size() != expected.size()) return false;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (points == expected) return true;
        std::rotate(expected.begin(), expected.begin() + 1, expected.end());
    }
    return false;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("clip 3d: A-T2, a piece cut through two vertices keeps its edges", "", RingAndField) {
    using N = TestType;
    const Facet<3, N> f = flat<N>({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    const auto diagonal = split(make_plane<N>(-1, 1, 0, 0), f);  // x - y = 0 goes through two vertices
    REQUIRE(diagonal.side == FacetSide::crossing);
    REQUIRE(has_vertices(*diagonal.minus, {make_point<N>(2, 0, 0), make_point<N>(2, 2, 0), make_point<N>(0, 0, 0)}));
    REQUIRE(has_vertices(*diagonal.plus, {make_point<N>(0, 0, 0), make_point<N>(2, 2, 0), make_point<N>(0, 2, 0)}));
    CHECK(is_valid(*diagonal.minus));
    CHECK(is_valid(*diagonal.plus));
    // With the edge planes exchanged the next cut finds (1, 2), outside the piece.
    const auto again = split(make_plane<N>(1, 0, 0, -1), *diagonal.minus);
    REQUIRE(again.side == FacetSide::crossing);
    CHECK(has_vertices(*again.minus, {make_point<N>(0, 0, 0), make_point<N>(1, 0, 0), make_point<N>(1, 1, 0)}));
    CHECK(has_vertices(
        *again.plus, {make_point<N>(1, 0, 0), make_point<N>(2, 0, 0), make_point<N>(2, 2, 0), make_point<N>(1, 1, 0)}));
    CHECK(is_valid(*again.minus));
    CHECK(is_valid(*again.plus));
}

TEMPLATE_LIST_TEST_CASE("clip 3d: A-T3, a facet that touches the plane with a whole side is not cut", "",
                        RingAndField) {
    using N = TestType;
    // Three collinear vertices on y = 0, the rest below.
    const Facet<3, N> f = flat<N>({{0, 0}, {0, -1}, {2, -1}, {2, 0}, {1, 0}});
    const Plane<3, N> h = make_plane<N>(0, 1, 0, 0);
    const auto s = split(h, f);
    CHECK(s.side == FacetSide::minus);
    CHECK(s.minus == f);
    CHECK_FALSE(s.plus);
    CHECK_FALSE(s.on);
    const auto t = split(flip(h), f);
    CHECK(t.side == FacetSide::plus);
    CHECK(t.plus == f);
    CHECK_FALSE(t.minus);
}

TEMPLATE_LIST_TEST_CASE("clip 3d: A-T5, a triangulated cube loses no area to a cut", "", RingAndField) {
    using N = TestType;
    // [0,2]^3, each square as two triangles, each triangle with its neighbour across the diagonal named: a coplanar
    // one.
    const int corners[8][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};
    const int squares[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const Plane<3, N> h = make_plane<N>(2, 0, 0, -1);  // x = 1/2
    auto minus = fraction_of<N>(0);
    auto plus = fraction_of<N>(0);
    for (const auto& square : squares) {
        for (const auto& [i, j, k] : {std::tuple(0, 1, 2), std::tuple(0, 2, 3)}) {
            std::vector<Point<3, N>> p;
            for (const int v : {square[i], square[j], square[k]}) {
                p.push_back(make_point<N>(corners[v][0], corners[v][1], corners[v][2]));
            }
            const std::vector<std::optional<Plane<3, N>>> neighbours(3, join(p[0], p[1], p[2]));
            const auto f =
                make_facet(std::span<const Point<3, N>>(p), std::span<const std::optional<Plane<3, N>>>(neighbours));
            REQUIRE(f);
            CHECK(is_valid(*f));
            const auto s = split(h, *f);
            if (s.minus) minus += projected_measure(*s.minus);
            if (s.plus) plus += projected_measure(*s.plus);
        }
    }
    CHECK(plus == fraction_of<N>(2 * 16));  // twice the areas
    CHECK(minus == fraction_of<N>(2 * 8));
}

TEMPLATE_LIST_TEST_CASE("clip 3d: coincident planes, co- and anti-oriented", "", RingAndField) {
    using N = TestType;
    const Facet<3, N> f = flat<N>({{0, 0}, {2, 0}, {0, 2}});
    CHECK(side(make_plane<N>(0, 0, 5, 0), f) == FacetSide::on_same);
    CHECK(side(make_plane<N>(0, 0, -1, 0), f) == FacetSide::on_opposite);
    CHECK(split(make_plane<N>(0, 0, -1, 0), f).on == f);
    CHECK(side(make_plane<N>(0, 0, 1, -1), f) == FacetSide::minus);
}

TEST_CASE("clip 3d: numbers do not grow from cut to cut") {
    // A polygon is cut a hundred times, every piece keeps being cut: its vertices stay meets of three given planes.
    Facet<3, Integer> f = flat<Integer>({{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}});
    std::size_t bits = 0;
    for (int i = 0; i < 100; ++i) {
        const int x = (i * 37) % 23 - 11;
        const int y = (i * 53) % 29 - 14;
        if (x == 0 && y == 0) continue;
        const auto s = split(make_plane<Integer>(x, y, i % 7 + 1, -100 - i), f);
        if (s.minus) f = *s.minus;
        REQUIRE(is_valid(f));
        for (const FacetCorner<Integer>& c : f.corners) {
            for (const Integer& v : c.point.homogeneous()) bits = std::max(bits, v.bit_length());
        }
    }
    CHECK(f.corners.size() > 6);
    // Three planes: the face (22 bits as joined), an outer edge (21) or a cut (12), another cut (4 in its normal).
    CHECK(bits <= 22 + 21 + 4 + 1);
}

TEST_CASE("clip 3d: parts are valid, on their sides, and add up, for many cuts after one another") {
    property("a hundred pieces of one facet",
             [](const Facet<3, Integer>& f, const std::vector<Plane<3, Integer>>& cuts) {
                 std::vector<Facet<3, Integer>> pieces{f};
                 for (const Plane<3, Integer>& h : cuts) {
                     std::vector<Facet<3, Integer>> next;
                     for (const Facet<3, Integer>& piece : pieces) {
                         const auto s = split(h, piece);
                         for (const auto& part : {s.minus, s.on, s.plus}) {
                             if (!part) continue;
                             RC_ASSERT(is_valid(*part));
                             RC_ASSERT(part->plane == f.plane);
                             next.push_back(*part);
                         }
                     }
                     pieces = std::move(next);
                 }
                 RC_ASSERT(projected_measure(pieces) == projected_measure(f));
                 // Original vertices are still there, and every piece lies in the facet.
                 for (const Facet<3, Integer>& piece : pieces) {
                     for (const Plane<3, Integer>& e : ridges(f)) RC_ASSERT(side(e, piece) == FacetSide::minus);
                 }
             });
}
