// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/point_box.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"

#include <limits>

using namespace cleave;

TEMPLATE_LIST_TEST_CASE("point box: doubles are enclosed flat, other rationals between neighbours", "", ExactTypes) {
    using N = TestType;
    const Box<3> box = box_of(make_point<N>(0.1, rational(1, 3), -7));
    CHECK(box.lo[0] == 0.1);
    CHECK(box.hi[0] == 0.1);
    CHECK(box.lo[1] == 1.0 / 3);  // the nearest double to 1/3 is below it
    CHECK(box.hi[1] == next_above(1.0 / 3));
    CHECK(box.lo[2] == -7.0);
    CHECK(box.hi[2] == -7.0);
    // The same place from other homogeneous coordinates.
    const Point<3, N> p = make_point<N>(0.1, rational(1, 3), -7);
    Vector<4, N> h = p.homogeneous();
    for (N& x : h) x = x * N(-12345);
    CHECK(box_of(Point<3, N>(h)) == box);
}

TEST_CASE("point box: coordinates beyond the largest double have no bound") {
    const Box<1> box = box_of(Point<1, Integer>(Vector<2, Integer>{Integer::scaled(1, 1100), Integer(1)}));
    CHECK(box.hi[0] == std::numeric_limits<double>::infinity());
    CHECK(box.contains(box_of(make_point<Integer>(1e300))));
}
