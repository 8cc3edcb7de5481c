// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/make_facet.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"

#include <optional>
#include <span>
#include <vector>

using namespace cleave;

TEMPLATE_LIST_TEST_CASE("make facet: points and segments in the order of join", "", RingAndField) {
    using N = TestType;
    CHECK(make_facet(make_point<N>(3), Sign::plus).plane == make_plane<N>(1, -3));
    CHECK(make_facet(make_point<N>(3), Sign::minus).plane == make_plane<N>(-1, 3));
    CHECK_THROWS_AS(make_facet(make_point<N>(3), Sign::zero), ContractViolation);
    const auto s = make_facet(make_point<N>(0, 0), make_point<N>(2, 0));
    REQUIRE(s);
    CHECK(s->plane == make_plane<N>(0, -1, 0));
    CHECK_FALSE(make_facet(make_point<N>(1, 2), Point<2, N>(Vector<3, N>{N(2), N(4), N(2)})));
}

TEMPLATE_LIST_TEST_CASE("make facet: A-T15, collinear and repeated vertices do not matter, lines are no facets", "",
                        RingAndField) {
    using N = TestType;
    const auto p = [](int x, int y) { return make_point<N>(x, y, 1); };
    using Points = std::vector<Point<3, N>>;
    // The first three vertices are collinear, two are repeated, the last repeats the first.
    const auto f = make_facet(Points{p(0, 0), p(0, 0), p(1, 0), p(2, 0), p(2, 0), p(0, 2), p(0, 0)});
    REQUIRE(f);
    CHECK(is_valid(*f));
    CHECK(f->corners.size() == 4);
    CHECK(f->plane == make_plane<N>(0, 0, 1, -1));
    CHECK_FALSE(make_facet(Points{p(0, 0), p(1, 1), p(2, 2), p(3, 3)}));
    CHECK_FALSE(make_facet(Points{p(0, 0), p(1, 1), p(1, 1), p(0, 0)}));
    CHECK_FALSE(make_facet(Points{p(0, 0), p(1, 1)}));
    CHECK_FALSE(make_facet(Points{}));
    // Every vertex twice.
    const auto g = make_facet(Points{p(0, 0), p(0, 0), p(2, 0), p(2, 0), p(0, 2), p(0, 2)});
    REQUIRE(g);
    CHECK(g->corners.size() == 3);
    CHECK(is_valid(*g));
}

TEMPLATE_LIST_TEST_CASE("make facet: neighbours give edge planes, edge by edge", "", RingAndField) {
    using N = TestType;
    // The top of the unit cube; one neighbour is missing, one is coplanar.
    const std::vector<Point<3, N>> p{make_point<N>(0, 0, 1), make_point<N>(1, 0, 1), make_point<N>(1, 1, 1),
                                     make_point<N>(0, 1, 1)};
    const Plane<3, N> top = make_plane<N>(0, 0, 1, -1);
    const Plane<3, N> slanted = make_plane<N>(1, 0, 1, -2);
    const std::vector<std::optional<Plane<3, N>>> neighbours{make_plane<N>(0, -1, 0, 0), slanted, std::nullopt,
                                                             flip(top)};
    const auto f =
        make_facet(top, std::span<const Point<3, N>>(p), std::span<const std::optional<Plane<3, N>>>(neighbours));
    REQUIRE(f);
    CHECK(is_valid(*f));
    CHECK(f->corners[0].edge == make_plane<N>(0, -1, 0, 0));
    CHECK(f->corners[1].edge == slanted);
    CHECK(f->corners[2].edge == make_plane<N>(0, 1, 0, -1));
    CHECK(f->corners[3].edge == make_plane<N>(-1, 0, 0, 0));
    const std::vector<std::optional<Plane<3, N>>> too_few(3);
    CHECK_THROWS_AS(
        make_facet(top, std::span<const Point<3, N>>(p), std::span<const std::optional<Plane<3, N>>>(too_few)),
        ContractViolation);
}
