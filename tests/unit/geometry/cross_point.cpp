// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/cross_point.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

#include <cleave/algebra/echelon.hpp>
#include <cleave/geometry/side.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("cross point: A-T1, the lines x = 1 and y = 2 meet in (1, 2), not (1, -2)", "", RingAndField) {
    using N = TestType;
    CHECK(meet(make_plane<N>(1, 0, -1), make_plane<N>(0, 1, -2)) == make_point<N>(1, 2));
    CHECK(meet(make_plane<N>(-1, 0, 1), make_plane<N>(0, 1, -2)) == make_point<N>(1, 2));
    // 2x - 2 = 0, 2y - 4 = 0 and the plane x - 3 = 0: the point is inside.
    const auto p = meet(make_plane<N>(2, 0, -2), make_plane<N>(0, 2, -4));
    REQUIRE(p);
    CHECK(side(make_plane<N>(1, 0, -3), *p) == Sign::minus);
    CHECK(number_traits<N>::sign(p->weight()) == Sign::plus);
}

TEMPLATE_LIST_TEST_CASE("cross point: planes without exactly one common point have no meet", "", RingAndField) {
    using N = TestType;
    CHECK_FALSE(meet(make_plane<N>(1, 2, 3), make_plane<N>(2, 4, 3)));                                    // parallel
    CHECK_FALSE(meet(make_plane<N>(1, 2, 3), make_plane<N>(-2, -4, -6)));                                 // coincident
    CHECK_FALSE(meet(make_plane<N>(1, 0, 0, 0), make_plane<N>(0, 1, 0, 0), make_plane<N>(1, 1, 0, 0)));   // a pencil
    CHECK_FALSE(meet(make_plane<N>(1, 0, 0, 0), make_plane<N>(0, 1, 0, 0), make_plane<N>(1, 1, 0, -1)));  // a prism
    CHECK(meet(make_plane<N>(1, 0, 0, 0), make_plane<N>(0, 1, 0, 0), make_plane<N>(1, 1, 3, -1)) ==
          make_point<N>(0, 0, rational(1, 3)));
    CHECK(meet(make_plane<N>(-3, 1)) == make_point<N>(rational(1, 3)));
}

TEMPLATE_LIST_TEST_CASE("cross point: points that span no plane have no join", "", RingAndField) {
    using N = TestType;
    const Point<2, N> p = make_point<N>(1, 2);
    CHECK_FALSE(join(p, Point<2, N>(Vector<3, N>{N(2), N(4), N(2)})));
    CHECK_FALSE(join(make_point<N>(0, 0, 0), make_point<N>(1, 1, 1), make_point<N>(2.5, 2.5, 2.5)));
    CHECK_FALSE(join(make_point<N>(0, 0, 0), make_point<N>(1, 1, 1), make_point<N>(0, 0, 0)));
}

TEMPLATE_LIST_TEST_CASE("cross point: outward order puts the inside on the minus side", "", RingAndField) {
    using N = TestType;
    // D = 1: the upper end of an interval.
    CHECK(side(*join(make_point<N>(5)), make_point<N>(4)) == Sign::minus);
    // D = 2: the lower edge of a square, counter-clockwise.
    CHECK(side(*join(make_point<N>(0, 0), make_point<N>(2, 0)), make_point<N>(1, 1)) == Sign::minus);
    CHECK(join(make_point<N>(0, 0), make_point<N>(2, 0)) == make_plane<N>(0, -1, 0));
    // D = 3: the top of a cube, counter-clockwise as seen from above.
    CHECK(side(*join(make_point<N>(0, 0, 2), make_point<N>(2, 0, 2), make_point<N>(2, 2, 2)), make_point<N>(1, 1, 1)) ==
          Sign::minus);
    CHECK(join(make_point<N>(0, 0, 2), make_point<N>(2, 0, 2), make_point<N>(2, 2, 2)) == make_plane<N>(0, 0, 1, -2));
}

TEMPLATE_LIST_TEST_CASE("cross point: directions may take the place of points", "", RingAndField) {
    using N = TestType;
    const Vector<4, N> up{N(0), N(0), N(1), N(0)};
    const auto wall =
        join_homogeneous<N>(make_point<N>(0, 0, 0).homogeneous(), make_point<N>(1, 1, 7).homogeneous(), up);
    REQUIRE(wall);
    CHECK(*wall == make_plane<N>(1, -1, 0, 0));
    const Vector<4, N> right{N(1), N(0), N(0), N(0)};
    const Vector<4, N> back{N(0), N(1), N(0), N(0)};
    CHECK_FALSE(join_homogeneous<N>(right, back, up));  // the plane at infinity is not one of ours
    CHECK(join_homogeneous<N>(make_point<N>(4, 5, 6).homogeneous(), right, back) == make_plane<N>(0, 0, 1, -6));
}

namespace {

/// The sign of det(v, p_2 - p_1, ..., p_D - p_1) by the definition of a determinant: sum over permutations.
template <int D>
Sign outward_first(const std::array<Rational, std::size_t(D)>& v,
                   const std::array<Point<D, Integer>, std::size_t(D)>& p) {
    std::array<std::array<Rational, std::size_t(D)>, std::size_t(D)> m;
    m[0] = v;
    for (std::size_t i = 1; i < std::size_t(D); ++i) {
        for (std::size_t j = 0; j < std::size_t(D); ++j) m[i][j] = p[i].coordinate(j) - p[0].coordinate(j);
    }
    std::array<std::size_t, std::size_t(D)> order;
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    Rational sum = 0;
    do {
        Rational term = 1;
        bool odd = false;
        for (std::size_t i = 0; i < order.size(); ++i) {
            term *= m[i][order[i]];
            for (std::size_t j = 0; j < i; ++j) odd = odd != (order[j] > order[i]);
        }
        sum += odd ? Rational(-term) : term;
    } while (std::next_permutation(order.begin(), order.end()));
    return sign_of(sum);
}

template <int D>
void check_join_and_meet() {
    using P = Point<D, Integer>;
    using H = Plane<D, Integer>;
    property("the join contains its points, and its normal comes first in a positive basis",
             [](const std::array<P, std::size_t(D)>& points) {
                 const std::optional<H> h = join(points);
                 RC_PRE(h.has_value());
                 for (const P& p : points) RC_ASSERT(side(*h, p) == Sign::zero);
                 std::array<Rational, std::size_t(D)> normal;
                 for (std::size_t i = 0; i < std::size_t(D); ++i) {
                     normal[i] = number_traits<Rational>::from_integer((*h)[i]);
                 }
                 RC_ASSERT(outward_first<D>(normal, points) == Sign::plus);
             });
    property("exchanging two points turns the plane round", [](std::array<P, std::size_t(D)> points) {
        const std::optional<H> h = join(points);
        RC_PRE(h.has_value());
        if constexpr (D > 1) {
            std::swap(points[0], points[D - 1]);
            RC_ASSERT(join(points) == flip(*h));
        }
    });
    property("the meet is on its planes, whatever their orientation", [](std::array<H, std::size_t(D)> planes) {
        const std::optional<P> p = meet(planes);
        RC_PRE(p.has_value());
        RC_ASSERT(p->weight().sign() == Sign::plus);
        for (const H& h : planes) RC_ASSERT(side(h, *p) == Sign::zero);
        planes[0] = flip(planes[0]);
        RC_ASSERT(meet(planes) == p);
        std::swap(planes[0], planes[D - 1]);
        RC_ASSERT(meet(planes) == p);
    });
    property("the corners of a simplex are the meets of its joins",
             [](const std::array<P, std::size_t(D) + 1>& corners) {
                 std::array<H, std::size_t(D) + 1> walls;
                 for (std::size_t i = 0; i <= std::size_t(D); ++i) {
                     std::array<P, std::size_t(D)> others;
                     for (std::size_t j = 0, k = 0; j <= std::size_t(D); ++j) {
                         if (j != i) others[k++] = corners[j];
                     }
                     const std::optional<H> wall = join(others);
                     RC_PRE(wall.has_value());
                     RC_PRE(side(*wall, corners[i]) != Sign::zero);
                     walls[i] = *wall;
                 }
                 for (std::size_t i = 0; i <= std::size_t(D); ++i) {
                     std::array<H, std::size_t(D)> others;
                     for (std::size_t j = 0, k = 0; j <= std::size_t(D); ++j) {
                         if (j != i) others[k++] = walls[j];
                     }
                     RC_ASSERT(meet(others) == corners[i]);
                 }
             });
}

}  // namespace

TEST_CASE("cross point: join and meet in D = 1") {
    check_join_and_meet<1>();
}
TEST_CASE("cross point: join and meet in D = 2") {
    check_join_and_meet<2>();
}
TEST_CASE("cross point: join and meet in D = 3") {
    check_join_and_meet<3>();
}
TEST_CASE("cross point: join and meet in D = 4") {
    check_join_and_meet<4>();
}
TEST_CASE("cross point: join and meet in D = 5") {
    check_join_and_meet<5>();
}

TEST_CASE("cross point: A-T16, planes that share an edge must have rank D - 1, not only be that many") {
    // In D = 4, x = 0, y = 0 and x + y = 0 are three planes, but what they share is a 2-flat, not an edge.
    const auto x = make_plane<Integer>(1, 0, 0, 0, 0);
    const auto y = make_plane<Integer>(0, 1, 0, 0, 0);
    const auto sum = make_plane<Integer>(1, 1, 0, 0, 0);
    const auto z = make_plane<Integer>(0, 0, 1, 0, -1);
    const auto w = make_plane<Integer>(0, 0, 0, 1, -1);
    CHECK(rank(rows_of(x.normal(), y.normal(), sum.normal())) == 2);
    CHECK(rank(rows_of(x.normal(), y.normal(), z.normal())) == 3);
    CHECK_FALSE(meet(x, y, sum, z));
    CHECK_FALSE(meet(x, y, sum, w));
    CHECK(meet(x, y, z, w) == make_point<Integer>(0, 0, 1, 1));
    CHECK(meet(x, sum, z, w) == make_point<Integer>(0, 0, 1, 1));
}

TEST_CASE("cross point: coordinates on a grid of b bits give planes within the bounds") {
    // In D = 3: normals of 2b + 2 bits and offsets of 3b + 2 for coordinates up to 2^b in size.
    const std::int64_t big = std::int64_t(1) << 20;
    property("D = 3", [](const std::array<std::array<std::uint32_t, 3>, 3>& drawn) {
        std::array<Point<3, Integer>, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            std::array<std::int64_t, 3> x;
            for (std::size_t j = 0; j < 3; ++j) x[j] = std::int64_t(drawn[i][j]) * 7919 % (2 * big + 1) - big;
            p[i] = make_point<Integer>(x);
        }
        const auto h = join(p);
        RC_PRE(h.has_value());
        for (std::size_t i = 0; i < 3; ++i) RC_ASSERT((*h)[i].bit_length() <= std::size_t(2 * 20 + 3));
        RC_ASSERT(h->offset().bit_length() <= std::size_t(3 * 20 + 3));
    });
}
