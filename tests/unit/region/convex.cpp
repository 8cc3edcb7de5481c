// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/convex.hpp>
//
#include <cleave/bsp/classify.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/sphere.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// sign * x_i + c <= 0.
template <int D>
IntegerPlane<D> across(std::size_t i, int sign, int c) {
    IntegerPlane<D> p{};
    p[i] = sign;
    p[std::size_t(D)] = c;
    return p;
}

/// Half-space, slab, wedge, cone, full, empty: named, and which of the points (2k+1)/2 they contain.
template <int D>
std::vector<std::vector<IntegerPlane<D>>> usual_sets() {
    std::vector<std::vector<IntegerPlane<D>>> sets;
    sets.push_back({});                                                   // full
    sets.push_back({across<D>(0, 1, 0), across<D>(0, -1, 0)});            // empty: no interior
    sets.push_back({across<D>(0, 1, -1)});                                // a half-space
    sets.push_back({across<D>(D - 1, 1, -1), across<D>(D - 1, -1, -1)});  // a slab
    sets.push_back({across<D>(0, 1, 0), across<D>(D - 1, -1, 0)});        // a wedge
    if (D >= 2) {
        IntegerPlane<D> a{};
        IntegerPlane<D> b{};
        a[0] = b[0] = -1;
        a[1] = 1;
        b[1] = -1;
        std::vector<IntegerPlane<D>> cone{a, b};
        for (std::size_t i = 2; i < std::size_t(D); ++i) {
            IntegerPlane<D> c = a;
            c[1] = 0;
            c[i] = 1;
            cone.push_back(c);
            c[i] = -1;
            cone.push_back(c);
        }
        sets.push_back(cone);  // |x_i| <= x_1
    }
    return sets;
}

/// Every operation on every pair, by both engines, against membership at generic points.
template <int D>
void check_all_pairs() {
    const auto sets = usual_sets<D>();
    Dice dice(1);
    std::vector<GenericPoint<D>> points;
    for (int i = 0; i < 30; ++i) points.push_back(GenericPoint<D>::random(dice, 3));
    for (std::size_t i = 0; i < sets.size(); ++i) {
        for (std::size_t j = 0; j < sets.size(); ++j) {
            const Region<D> a = region_of<D>(sets[i]);
            const Region<D> b = region_of<D>(sets[j]);
            for (const Operation operation : all_operations) {
                INFO(D << " dimensions, sets " << i << " and " << j << ", " << to_text(operation));
                const Region<D> r = apply(operation, a, b);
                CHECK(canonical(r) == canonical(apply(Engine::tree_merge, operation, a, b)));
                CHECK(canonical(~r) ==
                      canonical(apply(Engine::tree_merge, Operation::difference, Region<D>::full(), r)));
                Kernel<D> kernel;
                const PlaneTree<PlaneId> tree = tree_of_boundary(r.boundary(), kernel);
                PolytopeClip<D> model(kernel);
                for (const GenericPoint<D>& p : points) {
                    const bool in = apply(operation, p.in({sets[i]}) > 0, p.in({sets[j]}) > 0);
                    CHECK(classify(model, tree, p.add_to(kernel)) == (in ? Location::inside : Location::outside));
                }
            }
        }
    }
}

}  // namespace

TEST_CASE("convex: slab, wedge, cone, half-space, full and empty through every operation in D = 1") {
    check_all_pairs<1>();
}
TEST_CASE("convex: slab, wedge, cone, half-space, full and empty through every operation in D = 2") {
    check_all_pairs<2>();
}
TEST_CASE("convex: slab, wedge, cone, half-space, full and empty through every operation in D = 3") {
    check_all_pairs<3>();
}
TEST_CASE("convex: slab, wedge, cone, half-space, full and empty through every operation in D = 4") {
    check_all_pairs<4>();
}

TEST_CASE("convex: inconsistent half-spaces are empty, and so are those without interior") {
    CHECK(region_of<3>({{1, 0, 0, 1}, {-1, 0, 0, 1}}).is_empty());
    CHECK(region_of<3>({{1, 0, 0, 0}, {-1, 0, 0, 0}}).is_empty());
    CHECK(region_of<2>({{1, 1, 0}, {-1, 0, 0}, {0, -1, 0}}).is_empty());
    CHECK(region_of<1>({{1, 0}, {-1, 1}}).is_empty());
    CHECK(region_of<4>({}).is_full());
}

TEST_CASE("convex: repeated and superfluous planes change nothing") {
    const Region<2> square = region_of<2>({{1, 0, -1}, {-1, 0, 0}, {0, 1, -1}, {0, -1, 0}});
    const Region<2> same = region_of<2>(
        {{1, 0, -1}, {2, 0, -2}, {1, 0, -1}, {-1, 0, 0}, {0, 1, -1}, {0, -1, 0}, {1, 1, -2}, {1, 1, -5}, {-1, -1, 0}});
    CHECK(canonical(same) == canonical(square));
    CHECK(same.face_count() == 4);
    CHECK(measure(same) == 1);
}

TEST_CASE("convex: what is bounded, and what the far point says") {
    const Region<2> below = region_of<2>({{0, 1, 0}});   // y <= 0
    const Region<2> above = region_of<2>({{0, -1, 0}});  // y >= 0
    CHECK_FALSE(below.is_bounded());
    CHECK_FALSE(above.is_bounded());
    CHECK_FALSE(below.has_bounded_boundary());
    CHECK_FALSE(below.boundary().value_at_infinity);  // (t, t^2) is above
    CHECK(above.boundary().value_at_infinity);
    CHECK(canonical(~below) == canonical(above));
    CHECK_FALSE(measure(below));
    const Region<1> left = region_of<1>({{1, 0}});
    CHECK_FALSE(left.is_bounded());
    CHECK_FALSE((~left).is_bounded());
    CHECK((left & region_of<1>({{-1, -1}})).is_bounded());
    const Region<2> box = region_of<2>({{1, 0, -1}, {-1, 0, 0}, {0, 1, -1}, {0, -1, 0}});
    CHECK(box.is_bounded());
    CHECK_FALSE((~box).is_bounded());
    CHECK((~box).has_bounded_boundary());
    CHECK((below & box).is_empty());
    CHECK(measure(above & box) == 1);
}

TEST_CASE("convex: the sets of the documentation") {
    // [sets]
    const Region<3> below = half_space(make_plane<Integer>(0, 0, 1, 0));  // z <= 0
    const std::vector<Plane<2, Integer>> sides{make_plane<Integer>(1, 0, -1), make_plane<Integer>(-1, 0, 0)};
    const Region<2> strip = half_spaces<2, Integer>(sides);  // 0 <= x <= 1
    const Region<3> half_ball = sphere({0, 0, 0}, 1) & below;
    // [/sets]
    CHECK_FALSE(below.is_bounded());
    CHECK(strip.face_count() == 2);
    CHECK(*measure(half_ball) * 2 == *measure(sphere({0, 0, 0}, 1)));
}

TEST_CASE("convex: coefficients may be rationals and doubles' values of any size") {
    const Region<2> triangle = half_spaces<2, Rational>(
        std::vector<Plane<2, Rational>>{make_plane<Rational>(Rational(1, 3), Rational(1, 2), Rational(-1, 6)),
                                        make_plane<Rational>(-1, 0, 0), make_plane<Rational>(0, -1, 0)});
    CHECK(measure(triangle) == Rational(1, 12));
    const Region<2> huge = half_spaces<2, Rational>(std::vector<Plane<2, Rational>>{
        make_plane<Rational>(1, 1, -0x1p900), make_plane<Rational>(-1, 0, 0), make_plane<Rational>(0, -1, 0)});
    CHECK(huge.is_bounded());
    Rational expected(0x1p900);
    expected *= expected;
    expected /= 2;
    CHECK(measure(huge) == expected);
}
