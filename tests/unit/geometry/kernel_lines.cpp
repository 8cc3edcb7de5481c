// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/kernel_lines.hpp>
//
#include "support/catch.hpp"
#include "support/kernel_planes.hpp"

using namespace cleave;
using namespace support;

TEST_CASE("kernel lines: an edge runs along n_f x n_e, whatever the orientations") {
    Kernel<3> kernel;
    const PlaneId top = plane_of(kernel, 0, 0, 1, -1);    // facing up
    const PlaneId front = plane_of(kernel, 0, -1, 0, 0);  // facing -y
    const AxisDirection d = edge_direction(kernel, top, front);
    CHECK(d.axis == 0);
    CHECK(d.sign == Sign::plus);  // (0,0,1) x (0,-1,0) = (1,0,0)
    CHECK(edge_direction(kernel, flipped(top), front).sign == Sign::minus);
    CHECK(edge_direction(kernel, flipped(top), flipped(front)).sign == Sign::plus);
}

TEST_CASE("kernel lines: an edge plane is oriented with the face on its minus side, also at reflex edges") {
    Kernel<3> kernel;
    const PlaneId top = plane_of(kernel, 0, 0, 1, 0);
    const PointId u = kernel.add_point(Doubles<3>{0, 0, 0});
    const PointId v = kernel.add_point(Doubles<3>{1, 0, 0});
    const PointId left = kernel.add_point(Doubles<3>{0, 1, 0});
    for (const PlaneId wall :
         {plane_of(kernel, 0, 1, 0, 0), plane_of(kernel, 0, 1, 5, 0), plane_of(kernel, 0, -2, 1, 0)}) {
        const PlaneId e = orient_edge(kernel, top, wall, u, v);
        CHECK(kernel.side(e, left) == Sign::minus);
        CHECK(orient_edge(kernel, top, flipped(wall), u, v) == e);
        CHECK(orient_edge(kernel, top, wall, v, u) == flipped(e));
    }
}

TEST_CASE("kernel lines: turns of edges of a square") {
    Kernel<3> kernel;
    const PlaneId top = plane_of(kernel, 0, 0, 1, 0);
    const PlaneId south = plane_of(kernel, 0, -1, 0, 0);
    const PlaneId east = plane_of(kernel, 1, 0, 0, -1);
    CHECK(turn(kernel, top, south, east) == Sign::plus);
    CHECK(turn(kernel, top, east, south) == Sign::minus);
    CHECK(turn(kernel, top, south, flipped(south)) == Sign::zero);
    CHECK(turn(kernel, flipped(top), south, east) == Sign::minus);
}

TEST_CASE("kernel lines: planes of one pencil have proportional residues within a face's plane") {
    Kernel<3> kernel;
    const PlaneId top = plane_of(kernel, 0, 0, 1, -3);
    const PlaneId a = plane_of(kernel, 1, 1, 0, -2);
    const PlaneId b = plane_of(kernel, 2, 2, 5, -19);  // 2a + 5 top
    const PlaneId c = plane_of(kernel, 1, 1, 0, -1);
    const auto ra = line_residues(kernel, top, a);
    const auto rb = line_residues(kernel, top, b);
    const auto rc = line_residues(kernel, top, c);
    CHECK(proportional(ra, rb));
    CHECK(projective_hash(ra) == projective_hash(rb));
    CHECK_FALSE(proportional(ra, rc));
}

TEST_CASE("kernel lines: in the plane an edge runs with the set on its left") {
    Kernel<2> kernel;
    const PlaneId south = kernel.planes.intern({Integer(0), Integer(-1), Integer(0)});  // set above
    const AxisDirection d = edge_direction(kernel, south, no_id);
    CHECK(d.axis == 0);
    CHECK(d.sign == Sign::plus);
}
