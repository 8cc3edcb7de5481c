// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/triangle_boundary.hpp>

#include "support/catch.hpp"
#include "support/meshes.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace cleave;

namespace {

std::vector<PointId> points_of_corners(const Boundary<3>& boundary) {
    std::vector<PointId> points;
    for (const Corner& c : boundary.faces.corners) points.push_back(c.point);
    return points;
}

}  // namespace

TEST_CASE("triangle_boundary: points are numbered by their first corners, unused ones are left out") {
    const Mesh mesh = meshes::mesh<double>({{9, 9, 9}, {0, 0, 1}, {0, -0.0, 0}, {0, 1, 0}, {1, 0, 0}},
                                           {{4, 1, 2}, {1, 3, 2}, {3, 4, 2}, {1, 4, 3}});
    const std::vector<std::uint32_t> used{4, 1, 2, 3};
    for (const Boundary<3>& b :
         {cleave::detail::triangle_boundary(mesh, used, {}), cleave::detail::welded_triangle_boundary(mesh, {})}) {
        CHECK(points_of_corners(b) == std::vector<PointId>{0, 1, 2, 1, 3, 2, 3, 0, 2, 1, 0, 3});
        REQUIRE(b.points.size() == 4);
        CHECK(b.points[1].approximation == std::array<double, 3>{0, 0, 1});
        CHECK_FALSE(std::signbit(b.points[2].approximation[1]));
        CHECK(b.faces.faces.size() == 4);
        CHECK(b.faces.loop_first == LargeVector<std::uint32_t>{0, 3, 6, 9, 12});
        CHECK(b.faces.faces[3].source == Source{0, 3});
        CHECK(b.bounds.lo == std::array<double, 3>{0, 0, 0});
        CHECK(b.bounds.hi == std::array<double, 3>{1, 1, 1});
        CHECK((b.is_conforming && b.is_finite && !b.is_complete));
    }
}

TEST_CASE("triangle_boundary: equal points become one") {
    const Mesh mesh = meshes::triangle_cube();
    const Boundary<3> whole = cleave::detail::welded_triangle_boundary(mesh, {});
    const Boundary<3> soup = cleave::detail::welded_triangle_boundary(meshes::soup(mesh), {});
    CHECK(points_of_corners(soup) == points_of_corners(whole));
    CHECK(soup.points.size() == 8);
}

TEST_CASE("triangle_boundary: the sign of the enclosed volume, also where doubles do not tell") {
    Mesh mesh = meshes::triangle_cube();
    for (const double shift : {0.0, 1e15, 1e300}) {
        for (auto& p : mesh.points) p[0] = p[0] < 0.5 ? shift : std::nextafter(shift, 2e300);
        Boundary<3> b = cleave::detail::welded_triangle_boundary(mesh, {});
        CHECK(cleave::detail::enclosed_volume_sign(b) == Sign::plus);
        for (std::size_t c = 0; c < b.faces.corners.size(); c += 3)
            std::swap(b.faces.corners[c], b.faces.corners[c + 1]);
        CHECK(cleave::detail::enclosed_volume_sign(b) == Sign::minus);
        mesh = meshes::triangle_cube();
    }
}
