// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/affine_map.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"
#include "support/geometry_generators.hpp"

#include <cleave/geometry/cross_point.hpp>
#include <cleave/geometry/side.hpp>

#include <array>

using namespace cleave;
using support::property;

TEMPLATE_LIST_TEST_CASE("affine map: translations, scalings and the 3-4-5 rotation", "", RingAndField) {
    using N = TestType;
    const Point<3, N> p = make_point<N>(1, 2, 3);
    CHECK(translation<N>(0.5, rational(-1, 3), 0)(p) == make_point<N>(1.5, rational(5, 3), 3));
    CHECK(scaling<N>(2, 0.5, -1)(p) == make_point<N>(2, 1, -3));
    const AffineMap<3, N> turn = rational_rotation<3, N>(0, 1, 2, 1);
    CHECK(turn(make_point<N>(5, 0, 7)) == make_point<N>(3, 4, 7));
    CHECK(turn(make_point<N>(0, 5, 7)) == make_point<N>(-4, 3, 7));
    const AffineMap<3, N> quarter = rational_rotation<3, N>(2, 0, 1, 1);
    CHECK(quarter(make_point<N>(0, 0, 1)) == make_point<N>(1, 0, 0));
    CHECK(compose(quarter, compose(quarter, compose(quarter, quarter))) == AffineMap<3, N>());
    CHECK(AffineMap<3, N>()(p) == p);
    CHECK_THROWS_AS((rational_rotation<3, N>(1, 1, 2, 1)), ContractViolation);
    CHECK_THROWS_AS((rational_rotation<3, N>(0, 1, 0, 0)), ContractViolation);
}

TEMPLATE_LIST_TEST_CASE("affine map: a reflection is known by its determinant, and keeps inside inside", "",
                        RingAndField) {
    using N = TestType;
    CHECK(scaling<N>(1, -1, 1).orientation() == Sign::minus);
    CHECK(scaling<N>(-1, -1, 2).orientation() == Sign::plus);
    CHECK(scaling<N>(-1, -1, 0).orientation() == Sign::zero);
    CHECK(rational_rotation<3, N>(0, 2, 5, 3).orientation() == Sign::plus);
    const Plane<2, N> h = make_plane<N>(1, 0, -1);
    CHECK(image(scaling<N>(-1, 1), h) == make_plane<N>(-1, 0, -1));
    CHECK(image(translation<N>(2.5, 7), h) == make_plane<N>(1, 0, -3.5));
    CHECK_FALSE(inverse(scaling<N>(1, 0)).has_value());
    CHECK_THROWS_AS((PlaneMap<2, N>(scaling<N>(1, 0))), ContractViolation);
}

TEST_CASE("affine map: the last row must be that of an affine map") {
    auto m = identity_matrix<3, Integer>();
    m(2, 0) = Integer(1);
    CHECK_THROWS_AS((AffineMap<2, Integer>(m)), ContractViolation);
    m(2, 0) = Integer(0);
    m(2, 2) = Integer(0);
    CHECK_THROWS_AS((AffineMap<2, Integer>(m)), ContractViolation);
    m(2, 2) = Integer(-1);
    CHECK(AffineMap<2, Integer>(m)(make_point<Integer>(3, 4)) == make_point<Integer>(-3, -4));
}

namespace {

template <int D>
void check_maps() {
    using Map = AffineMap<D, Integer>;
    using P = Point<D, Integer>;
    using H = Plane<D, Integer>;
    property("composition is application one after the other", [](const Map& a, const Map& b, const P& p) {
        RC_ASSERT(compose(a, b)(p) == a(b(p)));
        RC_ASSERT(compose(a, b).orientation() == a.orientation() * b.orientation());
    });
    property("the inverse undoes", [](const Map& a, const P& p) {
        const auto back = inverse(a);
        RC_ASSERT(back.has_value() == (a.orientation() != Sign::zero));
        RC_PRE(back.has_value());
        RC_ASSERT((*back)(a(p)) == p);
        RC_ASSERT(compose(a, *back) == Map());
        RC_ASSERT(inverse(*back) == a);
    });
    property("planes keep their sides, in reflections too", [](const Map& a, const H& h, const P& p) {
        RC_PRE(a.orientation() != Sign::zero);
        RC_ASSERT(side(image(a, h), a(p)) == side(h, p));
        RC_ASSERT(image(a, flip(h)) == flip(image(a, h)));
    });
    property("the join of images is the image of the join, turned round by a reflection",
             [](const Map& a, const std::array<P, std::size_t(D)>& points) {
                 RC_PRE(a.orientation() != Sign::zero);
                 const auto h = join(points);
                 RC_PRE(h.has_value());
                 std::array<P, std::size_t(D)> images;
                 for (std::size_t i = 0; i < points.size(); ++i) images[i] = a(points[i]);
                 const H expected = image(a, *h);
                 RC_ASSERT(join(images) == (a.orientation() == Sign::plus || D == 1 ? expected : flip(expected)));
             });
}

}  // namespace

TEST_CASE("affine map: laws in D = 2") {
    check_maps<2>();
}
TEST_CASE("affine map: laws in D = 3") {
    check_maps<3>();
}
TEST_CASE("affine map: laws in D = 4") {
    check_maps<4>();
}
