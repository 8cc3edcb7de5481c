// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/point_interner.hpp>
//
#include "support/catch.hpp"
#include "support/kernel_planes.hpp"

#include <vector>

using namespace cleave;
using namespace support;

TEST_CASE("point interner: the ten names of a point on five planes are one point") {
    Kernel<3> kernel;
    PointInterner<3> points(kernel);
    // Five planes through (1, 2, 3), no three of them with a common line.
    std::vector<std::uint32_t> planes;
    for (const auto& n : std::vector<std::array<int, 3>>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 2, 4}})
        planes.push_back(unoriented(plane_of(kernel, n[0], n[1], n[2], -(n[0] + 2 * n[1] + 3 * n[2]))));
    std::size_t names = 0;
    PointId representative = no_id;
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = i + 1; j < 5; ++j)
            for (std::size_t k = j + 1; k < 5; ++k) {
                const PointId p = points(kernel.add_meet({planes[k], planes[i], planes[j]}));
                if (representative == no_id) representative = p;
                CHECK(p == representative);
                ++names;
            }
    CHECK(names == 10);
    CHECK(points(kernel.add_point(Doubles<3>{1, 2, 3})) == representative);
    CHECK(points(kernel.add_point(Homogeneous<3>{Integer(7), Integer(14), Integer(21), Integer(7)})) == representative);
    CHECK(points(kernel.add_point(Doubles<3>{1, 2, 3.0000000000000004})) != representative);
}

TEST_CASE("point interner: both zeros are one coordinate") {
    Kernel<2> kernel;
    PointInterner<2> points(kernel);
    CHECK(points(kernel.add_point(Doubles<2>{0.0, -0.0})) == points(kernel.add_point(Doubles<2>{-0.0, 0.0})));
}

TEST_CASE("point interner: points without residues are still told apart") {
    Kernel<1> kernel;
    PointInterner<1> points(kernel);
    const Integer p61 = Integer::scaled(1, 61) - Integer(1);
    const PointId one = points(kernel.add_point(Homogeneous<1>{Integer(1), p61}));
    const PointId two = points(kernel.add_point(Homogeneous<1>{Integer(2), p61}));
    CHECK(one != two);
    CHECK(points(kernel.add_point(Homogeneous<1>{Integer(3), p61 * Integer(3)})) == one);
}

TEST_CASE("point interner: thousands of points on a grid, each met twice") {
    Kernel<2> kernel;
    PointInterner<2> points(kernel);
    for (int x = 0; x < 60; ++x)
        for (int y = 0; y < 60; ++y) {
            const PointId p = points(kernel.add_point(Doubles<2>{x / 7.0, y / 7.0}));
            const PointId q = points(kernel.add_point(Doubles<2>{x / 7.0, y / 7.0}));
            REQUIRE(p == q);
            REQUIRE(kernel.point(p).approximation == std::array<double, 2>{x / 7.0, y / 7.0});
        }
}
