// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/canonical.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

#include <cleave/geometry/cross_point.hpp>

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("canonical: primitive planes and points have coprime integer entries", "", ExactTypes) {
    using N = TestType;
    const Plane<2, N> h = primitive(make_plane<N>(6, -9, 15));
    CHECK(h[0] == N(2));
    CHECK(h[1] == N(-3));
    CHECK(h.offset() == N(5));
    const Plane<2, N> g = primitive(make_plane<N>(rational(-1, 2), rational(1, 3), 0));
    CHECK(g[0] == N(-3));
    CHECK(g[1] == N(2));
    CHECK(g.offset() == N(0));
    const Point<2, N> p = primitive(Point<2, N>(Vector<3, N>{N(-4), N(0), N(-6)}));
    CHECK(p[0] == N(2));
    CHECK(p[1] == N(0));
    CHECK(p.weight() == N(3));
}

TEMPLATE_LIST_TEST_CASE("canonical: A-T16, equal planes have equal names, and orientation is apart", "", ExactTypes) {
    using N = TestType;
    const CanonicalPlane<3> a = canonical(make_plane<N>(0, -2, 4, 6));
    CHECK(a.is_flipped);
    CHECK(a.coefficients == Vector<4, Integer>{0, 1, -2, -3});
    CHECK(canonical(make_plane<N>(0, -1, 2, 3)) == a);
    CHECK(canonical(make_plane<N>(0, 0.5, -1, -1.5)).coefficients == a.coefficients);
    CHECK_FALSE(canonical(make_plane<N>(0, 0.5, -1, -1.5)).is_flipped);
    CHECK(canonical(make_plane<N>(0, 1, -2, 3)).coefficients != a.coefficients);
}

TEST_CASE("canonical: names agree exactly if planes coincide") {
    property("D = 3, over a ring and over a field", [](const Plane<3, Integer>& h, const Plane<3, Integer>& g) {
        const auto a = canonical(h);
        const auto b = canonical(g);
        RC_ASSERT((a == b) == (h == g));
        RC_ASSERT((a.coefficients == b.coefficients) == (h == g || h == flip(g)));
        RC_ASSERT(primitive(h) == h);
        const auto rationals = make_plane<Rational>(h.coefficients());
        RC_ASSERT(canonical(rationals) == a);
    });
}

TEST_CASE("canonical: bits are counted in the primitive vector") {
    CHECK(primitive_bits(make_plane<Integer>(1024, 2048, 0, 4096).coefficients()) == 3);
    CHECK(primitive_bits(make_plane<Rational>(rational(1, 3), 0, 0, 1).coefficients()) == 2);
}
