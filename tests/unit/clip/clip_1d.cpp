// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/clip_1d.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"

#include <cleave/clip/make_facet.hpp>

using namespace cleave;

TEMPLATE_LIST_TEST_CASE("clip 1d: a comparison, with coincidence told apart by orientation", "", RingAndField) {
    using N = TestType;
    const Plane<1, N> h = make_plane<N>(2, -5);  // x <= 5/2 is inside
    const auto f = [](const auto& x, Sign outside) { return make_facet(make_point<N>(x), outside); };
    CHECK(side(h, f(2, Sign::plus)) == FacetSide::minus);
    CHECK(side(h, f(2, Sign::minus)) == FacetSide::minus);
    CHECK(side(h, f(3, Sign::plus)) == FacetSide::plus);
    CHECK(side(h, f(2.5, Sign::plus)) == FacetSide::on_same);
    CHECK(side(h, f(rational(5, 2), Sign::minus)) == FacetSide::on_opposite);
    CHECK(side(flip(h), f(2, Sign::plus)) == FacetSide::plus);

    const auto minus = split(h, f(2, Sign::minus));
    CHECK(minus.side == FacetSide::minus);
    CHECK(minus.minus == f(2, Sign::minus));
    CHECK_FALSE(minus.on);
    CHECK_FALSE(minus.plus);
    const auto on = split(h, f(2.5, Sign::minus));
    CHECK(on.side == FacetSide::on_opposite);
    CHECK(on.on == f(2.5, Sign::minus));
    CHECK_FALSE(on.minus);
    CHECK_FALSE(on.plus);
}
