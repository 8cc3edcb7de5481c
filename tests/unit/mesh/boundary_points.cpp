// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/boundary_points.hpp>
//
#include <cleave/region/boundary.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/sphere.hpp>

#include "support/catch.hpp"

#include <array>
#include <cstdint>

using namespace cleave;

TEST_CASE("boundary_points: says what a kernel with all points says") {
    // Points of doubles, of integers, and meets of three planes.
    const Region<3> r = sphere<Rational>({0, 0, 0}, 1, {8, 4}) - sphere<Rational>({Rational(1, 3), 0, 1}, 1, {8, 4});
    const Boundary<3>& boundary = r.boundary();
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(boundary, kernel);
    BoundaryPoints points(boundary);
    const auto n = static_cast<PointId>(boundary.points.size());
    REQUIRE(n > 10);
    for (const FaceList::Face& face : boundary.faces.faces) {
        const Projection projection = points.projection_of(face.plane);
        const Projection expected = projection_of(kernel, loaded.plane(face.plane));
        REQUIRE(std::array{projection.u, projection.v} == std::array{expected.u, expected.v});
        const std::span<const Corner> loop = boundary.faces.loop(face.first_loop);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const PointId p = loop[i].point;
            const PointId q = loop[(i + 1) % loop.size()].point;
            const PointId s = (p + 7 * q) % n;  // some point of another face
            for (const PointId x : {loop[(i + 2) % loop.size()].point, s})
                REQUIRE(points.turn(p, q, x, projection) == turn(kernel, loaded.first_point + p, loaded.first_point + q,
                                                                 loaded.first_point + x, projection));
            for (const int axis : {0, 1, 2})
                for (const PointId x : {q, s, p})
                    REQUIRE(points.compare(axis, p, x) ==
                            kernel.compare(axis, loaded.first_point + p, loaded.first_point + x));
        }
    }
    for (PointId p = 0; p < n; ++p) {
        kernel.refine(loaded.first_point + p);
        REQUIRE(points.rounded(p) == kernel.point(loaded.first_point + p).approximation);
        REQUIRE(points.coordinates(p) == kernel.coordinates(loaded.first_point + p));
    }
}
