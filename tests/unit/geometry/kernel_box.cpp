// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/kernel_box.hpp>

#include "support/catch.hpp"

#include <array>
#include <limits>

using namespace cleave;

TEST_CASE("kernel box: the box of a point given by doubles is that point", "[kernel_box]") {
    Kernel<3> kernel;
    const std::array<double, 3> x{0.1, -2, 1e300};
    const Box<3> box = box_of(kernel, kernel.add_point(x));
    CHECK(box.lo == x);
    CHECK(box.hi == x);
}

TEST_CASE("kernel box: a fraction lies strictly inside its box", "[kernel_box]") {
    Kernel<2> kernel;
    // (1/3, -1/7)
    const PointId p = kernel.add_point(Homogeneous<2>{Integer(7), Integer(-3), Integer(21)});
    const Box<2> box = box_of(kernel, p);
    CHECK(box.lo[0] < 1.0 / 3);
    CHECK(1.0 / 3 < box.hi[0]);
    CHECK(box.hi[0] - box.lo[0] < 1e-15);
    CHECK(box.lo[1] < -1.0 / 7);
    CHECK(-1.0 / 7 < box.hi[1]);
}

TEST_CASE("kernel box: a meet that nothing is known of yet is computed", "[kernel_box]") {
    Kernel<2> kernel;
    const std::uint32_t x = unoriented(kernel.planes.intern({Integer(3), Integer(0), Integer(-1)}));
    const std::uint32_t y = unoriented(kernel.planes.intern({Integer(0), Integer(7), Integer(1)}));
    const Box<2> box = box_of(kernel, kernel.add_meet({x, y}));
    CHECK(box.contains({1.0 / 3, -1.0 / 7}));
    CHECK(box.hi[0] - box.lo[0] < 1e-15);
}

TEST_CASE("kernel box: beyond the doubles the box is all of space", "[kernel_box]") {
    Kernel<1> kernel;
    const Box<1> box = box_of(kernel, kernel.add_point(Homogeneous<1>{Integer::scaled(1, 5000), Integer(3)}));
    CHECK(box.lo[0] == -std::numeric_limits<double>::infinity());
    CHECK(box.hi[0] == std::numeric_limits<double>::infinity());
}
