// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/facet_box.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"

#include <cleave/clip/make_facet.hpp>

#include <vector>

using namespace cleave;

TEMPLATE_LIST_TEST_CASE("facet box: the box of the vertices, exact or rounded outward", "", RingAndField) {
    using N = TestType;
    const auto f = make_facet(std::vector<Point<3, N>>{make_point<N>(0, 1, 0.5), make_point<N>(rational(1, 3), 0, 0),
                                                       make_point<N>(0, 4, 2)});
    REQUIRE(f);
    const auto exact = exact_box_of(*f);
    CHECK(exact.lo == Vector<3, Rational>{rational(0), rational(0), rational(0)});
    CHECK(exact.hi == Vector<3, Rational>{rational(1, 3), rational(4), rational(2)});
    CHECK(box_of(*f) == Box<3>({0, 0, 0}, {next_above(1.0 / 3), 4, 2}));
    const Facet<1, N> end = make_facet(make_point<N>(rational(1, 3)), Sign::plus);
    CHECK(box_of(end) == Box<1>({1.0 / 3}, {next_above(1.0 / 3)}));
    const auto s = make_facet(make_point<N>(3, 1), make_point<N>(2, 7));
    REQUIRE(s);
    CHECK(box_of(*s) == Box<2>({2, 1}, {3, 7}));
}
