// SPDX-License-Identifier: Apache-2.0
#include <cleave/query/representation.hpp>
//
#include <cleave/region/canonical.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/hull.hpp>
#include <cleave/shape/sphere.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"

using namespace cleave;
using namespace support;

namespace {

template <int D>
void check_round_trips(unsigned seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const bool bounded = dice.below(2) == 0;
    const Region<D> r = region_of<D>(random_convex<D>(dice, bounded).planes);
    if (!r.is_empty()) CHECK(canonical(half_spaces<D, Integer>(facet_planes(r))) == canonical(r));
    if (bounded) CHECK(canonical(convex_hull<D, Rational>(vertices(r))) == canonical(r));
}

}  // namespace

TEST_CASE("representation: vertices and planes of a box, in order") {
    const Region<2> b = box<2>({0, 1}, {3, Rational(3, 2)});
    CHECK(vertices(b) ==
          std::vector<std::array<Rational, 2>>{{0, 1}, {0, Rational(3, 2)}, {3, 1}, {3, Rational(3, 2)}});
    const std::vector<Plane<2, Integer>> planes = facet_planes(b);
    REQUIRE(planes.size() == 4);
    CHECK(planes[0] == make_plane<Integer>(-1, 0, 0));
    CHECK(planes[1] == make_plane<Integer>(0, -1, 1));
    CHECK(planes[2] == make_plane<Integer>(0, 2, -3));
    CHECK(planes[3] == make_plane<Integer>(1, 0, -3));
    CHECK(vertices(box<3>({0, 0, 0}, {1, 1, 1})).size() == 8);
    CHECK(vertices(Region<3>::full()).empty());
    CHECK(facet_planes(Region<3>::empty()).empty());
}

TEST_CASE("representation: unbounded sets have finite vertices only; faces in one plane count once") {
    const Region<2> quadrant = half_space(make_plane<Integer>(-1, 0, 0)) & half_space(make_plane<Integer>(0, -1, 0));
    CHECK(vertices(quadrant) == std::vector<std::array<Rational, 2>>{{0, 0}});
    CHECK(facet_planes(quadrant).size() == 2);
    CHECK(vertices(half_space(make_plane<Integer>(1, 2, 3, 4))).empty());
    // Two separate faces in the plane x = 1, the same way round; and one the other way round.
    const Region<2> teeth = box<2>({0, 0}, {1, 1}) | box<2>({0, 2}, {1, 3}) | box<2>({1, 4}, {2, 5});
    CHECK(facet_planes(teeth).size() == 4 + 6);
}

TEST_CASE("representation: convex sets come back from either") {
    for (unsigned seed = 0; seed < scaled(60); ++seed) {
        check_round_trips<1>(seed);
        check_round_trips<2>(seed);
        check_round_trips<3>(seed);
    }
    for (unsigned seed = 0; seed < scaled(20); ++seed) check_round_trips<4>(seed);
    for (unsigned seed = 0; seed < scaled(5); ++seed) check_round_trips<5>(seed);
    const Region<3> ball = sphere<Rational>({0, 0, 0}, 1, {});
    CHECK(canonical(convex_hull<3, Rational>(vertices(ball))) == canonical(ball));
}
