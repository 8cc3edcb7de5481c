// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/side.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("side: minus is inside, plus is outside, a point on the plane has sign zero", "", ExactTypes) {
    using N = TestType;
    const Plane<2, N> h = make_plane<N>(1, 0, -1);  // x <= 1 is inside
    CHECK(side(h, make_point<N>(0, 5)) == Sign::minus);
    CHECK(side(h, make_point<N>(1, 5)) == Sign::zero);
    CHECK(side(h, make_point<N>(2, 5)) == Sign::plus);
    CHECK(side(h, make_point<N>(rational(1, 3), 5)) == Sign::minus);
    CHECK(side(flip(h), make_point<N>(2, 5)) == Sign::minus);
    CHECK(side(h, Vector<2, N>{N(0), N(1)}) == Sign::zero);
    CHECK(side(h, Vector<2, N>{N(-1), N(1)}) == Sign::minus);
}

TEMPLATE_LIST_TEST_CASE("side: one unit in the last place of a double is seen", "", ExactTypes) {
    using N = TestType;
    // x + y - 1 at (0.1, 0.9) and its neighbours: the doubles 0.1 and 0.9 add up to slightly more than 1.
    const Plane<2, N> h = make_plane<N>(1, 1, -1);
    CHECK(side(h, make_point<N>(0.1, 0.9)) == Sign::plus);
    CHECK(side(h, make_point<N>(0.25, 0.75)) == Sign::zero);
    CHECK(side(h, make_point<N>(0.25, 0.75 - 0x1p-53)) == Sign::minus);
    CHECK(side(h, make_point<N>(0x1p-1074, 1.0)) == Sign::plus);
}

TEST_CASE("side: it is the sign of the value of the plane") {
    property("D = 3", [](const Plane<3, Integer>& h, const Point<3, Integer>& p) {
        const Rational value = evaluate(h, p);
        RC_ASSERT(side(h, p) == sign_of(value));
        RC_ASSERT(side(flip(h), p) == -side(h, p));
    });
    property("D = 5", [](const Plane<5, Integer>& h, const Point<5, Integer>& p) {
        Rational value = number_traits<Rational>::from_integer(h.offset());
        for (std::size_t i = 0; i < 5; ++i) {
            const Rational n = number_traits<Rational>::from_integer(h[i]);
            value += n * p.coordinate(i);
        }
        RC_ASSERT(value == evaluate(h, p));
        RC_ASSERT(side(h, p) == sign_of(value));
    });
    CHECK(side<WideInteger>(make_plane<Integer>(1, 2, 3), make_point<Integer>(-1, -1)) == Sign::zero);
}
