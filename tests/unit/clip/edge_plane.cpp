// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/edge_plane.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

#include <cleave/geometry/relation.hpp>

#include <array>
#include <optional>

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("edge plane: the neighbour's plane, turned so that the face is inside", "", RingAndField) {
    using N = TestType;
    // The bottom of a box seen from below: the edge along y = 0 runs from x = 2 to x = 0.
    const Plane<3, N> bottom = make_plane<N>(0, 0, -1, 0);
    const Point<3, N> a = make_point<N>(2, 0, 0);
    const Point<3, N> b = make_point<N>(0, 0, 0);
    const Plane<3, N> front = make_plane<N>(0, -1, 0, 0);
    CHECK(side(bottom, make_point<N>(1, 1, 1)) == Sign::minus);
    CHECK(edge_plane<N>(bottom, b, a, front) == flip(front));  // face at y < 0
    CHECK(edge_plane<N>(bottom, a, b, front) == front);        // face at y > 0
    CHECK(edge_plane<N>(bottom, a, b, flip(front)) == front);
    CHECK_THROWS_AS(edge_plane<N>(bottom, a, b, make_plane<N>(0, -1, 0, 1)), ContractViolation);
}

TEMPLATE_LIST_TEST_CASE("edge plane: A-T5, a coplanar neighbour gives way to an auxiliary plane", "", RingAndField) {
    using N = TestType;
    const Plane<3, N> top = make_plane<N>(1, 1, 3, -6);
    const Point<3, N> a = make_point<N>(0, 0, 2);
    const Point<3, N> b = make_point<N>(3, 0, 1);
    for (const std::optional<Plane<3, N>>& neighbour :
         {std::optional<Plane<3, N>>(), std::optional(top), std::optional(flip(top))}) {
        const Plane<3, N> e = edge_plane(top, a, b, neighbour);
        CHECK(relation(e, top) == PlaneRelation::crossing);
        CHECK(side(e, a) == Sign::zero);
        CHECK(side(e, b) == Sign::zero);
        CHECK(side(e, make_point<N>(0, 3, 1)) == Sign::minus);
        CHECK(number_traits<N>::sign(e[2]) == Sign::zero);  // it contains the z-direction
    }
}

TEST_CASE("edge plane: the auxiliary axis is never parallel to the face") {
    CHECK(auxiliary_axis(make_plane<Integer>(0, 0, -1, 5)) == 2);
    CHECK(auxiliary_axis(make_plane<Integer>(0, -7, 3, 5)) == 1);
    CHECK(auxiliary_axis(make_plane<Integer>(2, -2, 2, 5)) == 0);
    property("it belongs to a largest normal entry", [](const Plane<3, Integer>& h) {
        const Integer largest = abs(h[auxiliary_axis(h)]);
        for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(!(largest < abs(h[i])));
    });
}

TEST_CASE("edge plane: the third corner of a triangle is inside every edge plane") {
    property("with and without neighbours", [](const std::array<Point<3, Integer>, 3>& p, const Point<3, Integer>& q) {
        const auto h = join(p);
        RC_PRE(h.has_value());
        for (std::size_t i = 0; i < 3; ++i) {
            const Point<3, Integer>& a = p[i];
            const Point<3, Integer>& b = p[(i + 1) % 3];
            for (const auto& neighbour : {std::optional<Plane<3, Integer>>(), join(a, b, q)}) {
                const Plane<3, Integer> e = edge_plane(*h, a, b, neighbour);
                RC_ASSERT(side(e, p[(i + 2) % 3]) == Sign::minus);
                RC_ASSERT(side(e, a) == Sign::zero);
                RC_ASSERT(side(e, b) == Sign::zero);
                RC_ASSERT(relation(e, *h) == PlaneRelation::crossing);
                if (neighbour && side(*h, q) != Sign::zero) RC_ASSERT(is_coincident(relation(e, *neighbour)));
            }
        }
    });
}
