// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/facet.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/facet_generators.hpp"
#include "support/facet_measure.hpp"

#include <cleave/clip/make_facet.hpp>

#include <vector>

using namespace cleave;
using support::property;

namespace {

/// The square [0,2]^2 in the plane z = 0, seen from above, with upright edge planes.
template <class N>
Facet<3, N> square() {
    return *make_facet(std::vector<Point<3, N>>{make_point<N>(0, 0, 0), make_point<N>(2, 0, 0), make_point<N>(2, 2, 0),
                                                make_point<N>(0, 2, 0)});
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("facet: A-T6, flipping reverses the loop and shifts the edge planes", "", RingAndField) {
    using N = TestType;
    const Facet<3, N> f = square<N>();
    CHECK(f.corners[0].edge == make_plane<N>(0, -1, 0, 0));
    CHECK(f.corners[1].edge == make_plane<N>(1, 0, 0, -2));
    CHECK(f.corners[2].edge == make_plane<N>(0, 1, 0, -2));
    CHECK(f.corners[3].edge == make_plane<N>(-1, 0, 0, 0));
    const Facet<3, N> g = flip(f);
    CHECK(g.plane == make_plane<N>(0, 0, -1, 0));
    // (p0, e3), (p3, e2), (p2, e1), (p1, e0)
    CHECK(g.corners[0] == FacetCorner<N>{f.corners[0].point, f.corners[3].edge});
    CHECK(g.corners[1] == FacetCorner<N>{f.corners[3].point, f.corners[2].edge});
    CHECK(g.corners[2] == FacetCorner<N>{f.corners[2].point, f.corners[1].edge});
    CHECK(g.corners[3] == FacetCorner<N>{f.corners[1].point, f.corners[0].edge});
    CHECK(is_valid(g));
    // Winding and plane agree: measured from its own outside the area is positive before and after.
    CHECK(projected_measure(f) == fraction_of<N>(8));
    CHECK(projected_measure(g) == fraction_of<N>(8));
    // With the planes left where they were the loop would not fit its planes.
    Facet<3, N> unshifted = g;
    for (std::size_t i = 0; i < 4; ++i) unshifted.corners[i].edge = f.corners[(4 - i) % 4].edge;
    CHECK_FALSE(is_valid(unshifted));
}

TEMPLATE_LIST_TEST_CASE("facet: what is not a facet is recognised", "", RingAndField) {
    using N = TestType;
    const Facet<3, N> f = square<N>();
    CHECK(is_valid(f));
    Facet<3, N> g = f;
    g.plane = flip(g.plane);  // the winding does not fit the plane
    CHECK_FALSE(is_valid(g));
    g = f;
    g.corners[1].edge = flip(g.corners[1].edge);  // the facet on the plus side of an edge plane
    CHECK_FALSE(is_valid(g));
    g = f;
    g.corners[1].edge = g.plane;  // A-T5: an edge plane that is coplanar
    CHECK_FALSE(is_valid(g));
    g = f;
    g.corners[2].point = make_point<N>(2, 2, 1);  // off the plane
    CHECK_FALSE(is_valid(g));
    g = f;
    g.corners[2].point = make_point<N>(1, 1, 0);  // not on its edge planes
    CHECK_FALSE(is_valid(g));
    g = f;
    g.corners.pop_back();  // the last edge is not closed
    CHECK_FALSE(is_valid(g));
    g = f;
    g.corners.insert(g.corners.begin() + 1, g.corners.front());  // an edge of length zero
    CHECK_FALSE(is_valid(g));
    g = f;
    g.corners.insert(g.corners.end(), f.corners.begin(), f.corners.end());  // twice round
    CHECK_FALSE(is_valid(g));
    g.corners.resize(2);
    CHECK_FALSE(is_valid(g));
    const Facet<2, N> s = *make_facet(make_point<N>(0, 0), make_point<N>(2, 1));
    CHECK(is_valid(s));
    CHECK_FALSE(is_valid(Facet<2, N>{s.plane, s.end, s.begin}));
    CHECK_FALSE(is_valid(Facet<2, N>{s.plane, s.begin, s.begin}));
}

TEMPLATE_LIST_TEST_CASE("facet: vertices in the middle of a side are allowed", "", RingAndField) {
    using N = TestType;
    const auto f = make_facet(std::vector<Point<3, N>>{make_point<N>(0, 0, 0), make_point<N>(1, 0, 0),
                                                       make_point<N>(2, 0, 0), make_point<N>(0, 2, 0)});
    REQUIRE(f);
    CHECK(f->corners.size() == 4);
    CHECK(is_valid(*f));
}

namespace {

template <int D, class N>
void check_facets() {
    property("flip is an involution and keeps size and validity", [](const Facet<D, N>& f) {
        RC_ASSERT(is_valid(f));
        RC_ASSERT(is_valid(flip(f)));
        RC_ASSERT(flip(flip(f)) == f);
        RC_ASSERT(flip(f).plane == flip(f.plane));
        RC_ASSERT(projected_measure(f) > 0);
        RC_ASSERT(projected_measure(flip(f)) == projected_measure(f));
    });
    property("ridges have the facet inside and bound it", [](const Facet<D, N>& f, const Point<D, N>& p) {
        bool inside_all = side(f.plane, p) == Sign::zero;
        for (const Plane<D, N>& e : ridges(f)) {
            RC_ASSERT(D == 1 || relation(e, f.plane) == PlaneRelation::crossing);
            std::size_t on_ridge = 0;
            for (const Point<D, N>& v : vertices(f)) {
                RC_ASSERT(side(e, v) != Sign::plus);
                if (side(e, v) == Sign::zero) ++on_ridge;
            }
            RC_ASSERT(on_ridge >= std::size_t(D - 1));
            if (side(e, p) == Sign::plus) inside_all = false;
        }
        if (D == 2 && inside_all) {
            // A point of the line between the ridges is between the ends.
            RC_ASSERT(compare(p, vertices(f).front()) != compare(p, vertices(f).back()) ||
                      compare(p, vertices(f).front()) == Sign::zero);
        }
    });
}

}  // namespace

TEST_CASE("facet: laws in D = 1") {
    check_facets<1, Integer>();
}
TEST_CASE("facet: laws in D = 2") {
    check_facets<2, Integer>();
}
TEST_CASE("facet: laws in D = 3") {
    check_facets<3, Integer>();
}
TEST_CASE("facet: laws in D = 3 over a field") {
    check_facets<3, Rational>();
}
