// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/point.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

#include <limits>

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("point: coordinates of every kind are taken exactly", "", ExactTypes) {
    using N = TestType;
    using Field = typename number_traits<N>::field_type;
    const Point<4, N> p = make_point<N>(3, 2.5, rational(1, 3), Integer(-7));
    CHECK(p.coordinate(0) == Field(3));
    CHECK(p.coordinate(1) == fraction_of<N>(5, 2));
    CHECK(p.coordinate(2) == fraction_of<N>(1, 3));
    CHECK(p.coordinate(3) == Field(-7));
    CHECK(p.coordinates()[1] == p.coordinate(1));
    // A double is the number that it is, not the decimal it was written as.
    CHECK_FALSE(make_point<N>(0.1).coordinate(0) == fraction_of<N>(1, 10));
    CHECK(make_point<N>(0.1).coordinate(0) ==
          number_traits<Field>::from_fraction(Integer(3602879701896397), Integer::scaled(1, 55)));
    CHECK(make_point<N>(0x1p-1074, 0x1p+60) == make_point<N>(0x1p-1074, std::int64_t(1) << 60));
    CHECK_THROWS_AS(make_point<N>(std::numeric_limits<double>::infinity()), NumberError);
    CHECK_THROWS_AS(make_point<N>(1, std::numeric_limits<double>::quiet_NaN()), NumberError);
}

TEMPLATE_LIST_TEST_CASE("point: a ring keeps the least common denominator as weight", "", ExactTypes) {
    using N = TestType;
    const Point<3, N> p = make_point<N>(0.5, rational(1, 6), 0.25);
    if constexpr (number_traits<N>::is_field) {
        CHECK(p.weight() == N(1));
    } else {
        CHECK(p.weight() == N(12));
        CHECK(p[0] == N(6));
        CHECK(p[1] == N(2));
        CHECK(p[2] == N(3));
    }
}

TEMPLATE_LIST_TEST_CASE("point: equality is of places, and the weight is made positive", "", ExactTypes) {
    using N = TestType;
    const Point<2, N> p(Vector<3, N>{N(2), N(-4), N(6)});
    const Point<2, N> q(Vector<3, N>{N(-1), N(2), N(-3)});
    CHECK(p == q);
    CHECK(q.weight() == N(3));
    CHECK(q[0] == N(1));
    CHECK(p != Point<2, N>(Vector<3, N>{N(2), N(-4), N(5)}));
    CHECK(p != Point<2, N>(Vector<3, N>{N(-2), N(4), N(6)}));
    CHECK(Point<2, N>() == make_point<N>(0, 0));
    CHECK(Point<2, N>(Vector<3, N>{N(0), N(0), N(7)}) == Point<2, N>());
    CHECK_THROWS_AS((Point<2, N>(Vector<3, N>{N(1), N(2), N(0)})), ContractViolation);
}

TEST_CASE("point: comparisons are those of the coordinates") {
    using N = Integer;
    property("in every coordinate", [](const Point<3, N>& a, const Point<3, N>& b) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Rational difference = a.coordinate(i) - b.coordinate(i);
            RC_ASSERT(compare_coordinate(a, b, i) == sign_of(difference));
        }
    });
    property("lexicographically, as a total order",
             [](const Point<3, N>& a, const Point<3, N>& b, const Point<3, N>& c) {
                 RC_ASSERT((compare(a, b) == Sign::minus) == (a.coordinates() < b.coordinates()));
                 RC_ASSERT((compare(a, b) == Sign::zero) == (a == b));
                 RC_ASSERT(compare(a, b) == -compare(b, a));
                 if (compare(a, b) == Sign::minus && compare(b, c) == Sign::minus)
                     RC_ASSERT(compare(a, c) == Sign::minus);
             });
}
