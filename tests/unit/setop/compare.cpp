// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/compare.hpp>
//
#include <cleave/region/convex.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"

using namespace cleave;
using namespace support;

namespace {

template <int D>
void check_equal(const Region<D>& a, const Region<D>& b) {
    const bool expected = (a ^ b).is_empty();
    CHECK(equal(a, b) == expected);
    CHECK(equal(b, a) == expected);
    CHECK(equal(~a, ~b) == expected);
    CHECK(equal(a | b, b | a));
    CHECK(equal(a, a & (a | b)));
    CHECK(!equal(a, ~a));
}

template <int D>
void check_random(unsigned seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const bool bounded = dice.below(2) == 0;
    const Region<D> a = region_of<D>(random_convex<D>(dice, bounded).planes);
    const Region<D> b = region_of<D>(random_convex<D>(dice, bounded).planes);
    check_equal(a, b);
    check_equal(a | b, (a - b) | b);
}

}  // namespace

TEST_CASE("equal: empty and full, copies, and different numbers of faces") {
    CHECK(equal(Region<3>::empty(), Region<3>()));
    CHECK(equal(Region<3>::full(), ~Region<3>::empty()));
    CHECK(!equal(Region<3>::full(), Region<3>::empty()));
    CHECK(!equal(Region<2>::empty(), box<2>({0, 0}, {1, 1})));
    const Region<2> whole = box<2>({0, 0}, {2, 1});
    const Region<2> copy = whole;
    CHECK(equal(whole, copy));
    CHECK(equal(whole, box<2>({0, 0}, {1, 1}) | box<2>({1, 0}, {2, 1})));
    CHECK(!equal(whole, box<2>({0, 0}, {2, 1}) - box<2>({1, 0}, {Rational(1000000001, 1000000000), 1})));
    CHECK(!equal(whole, box<2>({10, 0}, {12, 1})));
    CHECK(equal(half_space(make_plane<Integer>(2, 4, 6)), half_space(make_plane<Integer>(1, 2, 3))));
    CHECK(!equal(half_space(make_plane<Integer>(1, 2, 3)), half_space(make_plane<Integer>(-1, -2, -3))));
}

TEST_CASE("equal: always the answer of an empty symmetric difference") {
    for (unsigned seed = 0; seed < scaled(60); ++seed) {
        check_random<1>(seed);
        check_random<2>(seed);
    }
    for (unsigned seed = 0; seed < scaled(30); ++seed) check_random<3>(seed);
    for (unsigned seed = 0; seed < scaled(5); ++seed) check_random<4>(seed);
}
