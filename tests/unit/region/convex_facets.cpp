// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/convex_facets.hpp>
//
#include "support/catch.hpp"

#include <array>
#include <cstdint>

using namespace cleave;

TEST_CASE("convex facets: tests by corners and by planes agree") {
    // The same triangles, whose planes are wanted at once or not at all, tilted and along each axis.
    const std::array<std::array<std::array<double, 3>, 3>, 4> triangles{{{{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}},
                                                                         {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}},
                                                                         {{{0, 2, 0}, {0, 2, 4}, {4, 2, 0}}},
                                                                         {{{3, 0, 0}, {3, 0, 5}, {3, 5, 0}}}}};
    for (const auto& t : triangles) {
        Kernel<3> kernel;
        ConvexFacets facets(kernel);
        std::array<Corner, 3> loop;
        for (std::size_t i = 0; i < 3; ++i) loop[i] = {kernel.add_point(t[i]), no_id};
        facets.add(7, no_id, loop);
        const PlaneId plane = kernel.join(std::array<PointId, 3>{loop[0].point, loop[1].point, loop[2].point}).value();
        std::array<Corner, 3> complete = loop;
        for (std::size_t i = 0; i < 3; ++i)
            complete[i].edge = plane_across(kernel, plane, loop[i].point, loop[(i + 1) % 3].point);
        facets.add(7, plane, complete);
        CHECK(facets.size() == 2);
        CHECK_FALSE(facets.are_known_coplanar(0, 1));
        for (double x = -1; x <= 4; ++x)
            for (double y = -1; y <= 4; ++y)
                for (double z = -1; z <= 4; ++z) {
                    const PointId p = kernel.add_point(std::array<double, 3>{x, y, z});
                    const Sign side = facets.side(0, p);
                    CHECK(side == facets.side(1, p));
                    if (side != Sign::zero) continue;
                    for (std::size_t i = 0; i < 3; ++i)
                        CHECK(facets.edge_side(0, i, p) == kernel.side(facets.edge(1, i), p));
                }
        CHECK(facets.plane(0) == plane);
        CHECK(facets.are_known_coplanar(0, 1));
        for (std::size_t i = 0; i < 3; ++i)  // any plane through the edge will do: it has the facet on its minus side
            CHECK(kernel.side(facets.edge(0, i), loop[(i + 2) % 3].point) == Sign::minus);
    }
}

TEST_CASE("convex facets: boxes and inner edges") {
    Kernel<3> kernel;
    ConvexFacets facets(kernel);
    std::array<Corner, 3> loop;
    const std::array<std::array<double, 3>, 3> at{{{1, 5, 0}, {-2, 2, 0}, {0, 2, 8}}};
    for (std::size_t i = 0; i < 3; ++i) loop[i] = {kernel.add_point(at[i]), no_id};
    facets.add(0, no_id, loop, std::array<bool, 3>{false, true, false});
    const Bounds<3> box = facets.bounds(0);
    CHECK(box.lo == std::array<double, 3>{-2, 2, 0});
    CHECK(box.hi == std::array<double, 3>{1, 5, 8});
    for (std::size_t i = 0; i < 3; ++i) CHECK(facets.is_inner(0, i) == (i == 1));
    CHECK(facets.next(0, 2) == 0);
}
