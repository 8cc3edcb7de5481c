// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/plane.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("plane: coefficients of every kind, up to a positive factor", "", ExactTypes) {
    using N = TestType;
    const Plane<3, N> h = make_plane<N>(0.5, rational(1, 3), 0, -2);
    CHECK(h == make_plane<N>(3, 2, 0, -12));
    CHECK(h != make_plane<N>(-3, -2, 0, 12));
    CHECK(h != make_plane<N>(3, 2, 0, 12));
    CHECK(h.normal()[2] == N(0));
    if constexpr (!number_traits<N>::is_field) {
        CHECK(h[0] == N(3));
        CHECK(h.offset() == N(-12));
    }
}

TEMPLATE_LIST_TEST_CASE("plane: a zero normal is no plane", "", ExactTypes) {
    using N = TestType;
    CHECK_THROWS_AS(make_plane<N>(0, 0, 0, 1), ContractViolation);
    CHECK_THROWS_AS((Plane<1, N>(Vector<2, N>{N(0), N(0)})), ContractViolation);
    CHECK(Plane<2, N>() == make_plane<N>(1, 0, 0));
}

TEST_CASE("plane: flip is an involution that changes the plane") {
    property("D = 4", [](const Plane<4, Integer>& h) {
        RC_ASSERT(flip(h) != h);
        RC_ASSERT(flip(flip(h)) == h);
        RC_ASSERT(flip(flip(h)).coefficients() == h.coefficients());
    });
}
