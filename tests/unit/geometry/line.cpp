// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/line.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

#include <cleave/geometry/side.hpp>

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("line: the trace of a half-space is a half-line with its orientation", "", ExactTypes) {
    using N = TestType;
    const Line<2, N> axis(make_point<N>(0.5, 0), Vector<2, N>{N(2), N(0)});
    const Plane<2, N> h = make_plane<N>(1, 1, -3);  // crosses the line in (3, 0), at t = 5/4
    const auto t = trace(axis, h);
    REQUIRE(t);
    CHECK(side(*t, make_point<N>(rational(5, 4))) == Sign::zero);
    CHECK(side(*t, make_point<N>(0)) == Sign::minus);
    CHECK(meet(axis, h) == make_point<N>(3, 0));
    CHECK(trace(axis, flip(h)) == flip(*t));
    CHECK_FALSE(trace(axis, make_plane<N>(0, 1, -3)));
    CHECK_FALSE(meet(axis, make_plane<N>(0, 1, 0)));
    CHECK(point_at(axis, make_point<N>(rational(1, 4))) == make_point<N>(1, 0));
}

TEST_CASE("line: no direction, no line") {
    CHECK_THROWS_AS((Line<2, Integer>(make_point<Integer>(1, 2), Vector<2, Integer>{0, 0})), ContractViolation);
    CHECK_FALSE(line_through(make_point<Integer>(1, 2), Point<2, Integer>(Vector<3, Integer>{2, 4, 2})));
}

namespace {

template <int D>
void check_lines() {
    using P = Point<D, Integer>;
    property("along the line, sides are sides of the trace",
             [](const P& a, const P& b, const Plane<D, Integer>& h, const Point<1, Integer>& t) {
                 const auto line = line_through(a, b);
                 RC_PRE(line.has_value());
                 const P p = point_at(*line, t);
                 const auto cut = trace(*line, h);
                 RC_ASSERT(side(h, p) == (cut ? side(*cut, t) : side(h, a)));
                 const auto x = meet(*line, h);
                 RC_ASSERT(x.has_value() == cut.has_value());
                 if (x) RC_ASSERT(side(h, *x) == Sign::zero);
             });
    property("it starts at a and reaches b at the product of the weights", [](const P& a, const P& b) {
        const auto line = line_through(a, b);
        RC_ASSERT(line.has_value() == (a != b));
        RC_PRE(line.has_value());
        RC_ASSERT(point_at(*line, Point<1, Integer>()) == a);
        const Vector<2, Integer> t{Integer(1), a.weight() * b.weight()};
        RC_ASSERT(point_at(*line, Point<1, Integer>(t)) == b);
    });
}

}  // namespace

TEST_CASE("line: laws in D = 1") {
    check_lines<1>();
}
TEST_CASE("line: laws in D = 3") {
    check_lines<3>();
}
TEST_CASE("line: laws in D = 4") {
    check_lines<4>();
}
