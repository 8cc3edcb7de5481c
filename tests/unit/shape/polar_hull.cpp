// SPDX-License-Identifier: Apache-2.0
#include <cleave/shape/polar_hull.hpp>
//
#include <cleave/query/measure.hpp>
#include <cleave/query/representation.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/hull.hpp>
#include <cleave/shape/simplex.hpp>

#include "support/catch.hpp"
#include "support/convex_sets.hpp"
#include "support/region_checker.hpp"

#include <algorithm>
#include <limits>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

/// Points with small integer coordinates: coplanar, collinear and equal ones among them.
template <int D>
std::vector<RationalPoint<D>> crowd(Dice& dice, int count, int range) {
    std::vector<RationalPoint<D>> points(static_cast<std::size_t>(count));
    for (auto& p : points)
        for (Rational& x : p) x = dice.below(range);
    return points;
}

template <int D>
Region<D> polar_hull(const std::vector<RationalPoint<D>>& points) {
    return Region<D>(detail::PolarHull<D>(points).build());
}

/// Every point is inside every facet's plane, and every vertex is one of the points.
template <int D>
void check_hull(const std::vector<RationalPoint<D>>& points, const Region<D>& hull) {
    for (const Plane<D, Integer>& h : facet_planes(hull)) {
        int on = 0;
        for (const RationalPoint<D>& p : points) {
            const Sign s = side(h, make_point<Integer>(p));
            REQUIRE(s != Sign::plus);
            on += s == Sign::zero ? 1 : 0;
        }
        CHECK(on >= D);
    }
    for (const RationalPoint<D>& v : vertices(hull)) CHECK(std::count(points.begin(), points.end(), v) > 0);
}

}  // namespace

TEST_CASE("polar hull: the same as the others in the plane and in space") {
    Dice dice(1);
    for (unsigned n = 0; n < scaled(200); ++n) {
        const std::vector<RationalPoint<2>> points = crowd<2>(dice, dice.between(0, 12), 4);
        CHECK(canonical(verified(polar_hull<2>(points))) == canonical(convex_hull<2>(points)));
        const std::vector<RationalPoint<3>> in_space = crowd<3>(dice, dice.between(0, 16), 3);
        const Region<3> hull = verified(polar_hull<3>(in_space));
        CHECK(canonical(hull) == canonical(convex_hull<3>(in_space)));
        CHECK(hull.face_count() == convex_hull<3>(in_space).face_count());
    }
}

TEST_CASE("polar hull: known polytopes in 4-D and 5-D") {
    std::vector<RationalPoint<4>> cube;
    for (int m = 0; m < 81; ++m) cube.push_back({m % 3, m / 3 % 3, m / 9 % 3, m / 27});
    CHECK(canonical(convex_hull<4>(cube)) == canonical(box<4>({0, 0, 0, 0}, {2, 2, 2, 2})));
    CHECK(vertices(convex_hull<4>(cube)).size() == 16);

    // The cross-polytope of radius 1 has 2^D facets and measure 2^D / D!.
    std::vector<RationalPoint<4>> cross;
    std::vector<RationalPoint<5>> cross5;
    for (std::size_t i = 0; i < 5; ++i)
        for (const int s : {1, -1}) {
            RationalPoint<5> p{0, 0, 0, 0, 0};
            p[i] = s;
            cross5.push_back(p);
            if (i < 4) cross.push_back({p[0], p[1], p[2], p[3]});
        }
    CHECK(facet_planes(convex_hull<4>(cross)).size() == 16);
    CHECK(measure(convex_hull<4>(cross)) == Rational(2, 3));
    CHECK(facet_planes(convex_hull<5>(cross5)).size() == 32);
    CHECK(measure(convex_hull<5>(cross5)) == Rational(4, 15));

    // The 24-cell: the 24 points with two coordinates of +-1 and two of 0; 24 octahedra; measure 8.
    std::vector<RationalPoint<4>> points;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            for (int m = 0; m < 4; ++m) {
                RationalPoint<4> p{0, 0, 0, 0};
                p[i] = (m & 1) != 0 ? 1 : -1;
                p[j] = (m & 2) != 0 ? 1 : -1;
                points.push_back(p);
            }
    const Region<4> cell24 = convex_hull<4>(points);
    CHECK(facet_planes(cell24).size() == 24);
    CHECK(vertices(cell24).size() == 24);
    CHECK(measure(cell24) == Rational(8));

    // The cyclic polytope of 8 points on the moment curve in 4-D is neighbourly: n (n - 3) / 2 = 20 facets.
    std::vector<RationalPoint<4>> curve;
    for (int t = 0; t < 8; ++t) curve.push_back({t, t * t, t * t * t, t * t * t * t});
    CHECK(facet_planes(convex_hull<4>(curve)).size() == 20);
    check_hull(curve, convex_hull<4>(curve));
}

TEST_CASE("polar hull: random points in 4-D and 5-D; vertices and planes give it back") {
    Dice dice(2);
    for (unsigned n = 0; n < scaled(40); ++n) {
        const std::vector<RationalPoint<4>> points = crowd<4>(dice, dice.between(0, 14), 3);
        const Region<4> hull = convex_hull<4>(points);
        check_hull(points, hull);
        CHECK(canonical(convex_hull<4>(vertices(hull))) == canonical(hull));
        if (!hull.is_empty()) CHECK(canonical(half_spaces<4, Integer>(facet_planes(hull))) == canonical(hull));
    }
    for (unsigned n = 0; n < scaled(10); ++n) {
        const std::vector<RationalPoint<5>> points = crowd<5>(dice, dice.between(5, 11), 2);
        const Region<5> hull = convex_hull<5>(points);
        check_hull(points, hull);
        CHECK(canonical(convex_hull<5>(vertices(hull))) == canonical(hull));
    }
}

TEST_CASE("polar hull: input points keep their coordinates, fractions too") {
    const std::vector<RationalPoint<4>> points{
        {0, 0, 0, 0}, {Rational(1, 3), 0, 0, 0}, {0, Rational(1, 7), 0, 0}, {0, 0, Rational(1, 2), 0}, {0, 0, 0, 1},
    };
    std::vector<RationalPoint<4>> sorted = points;
    std::sort(sorted.begin(), sorted.end());
    const Region<4> hull = convex_hull<4>(points);
    CHECK(vertices(hull) == sorted);
    CHECK(canonical(hull) == canonical(simplex<4>({{points[0], points[1], points[2], points[3], points[4]}})));
    CHECK(measure(hull) == Rational(1, 3 * 7 * 2 * 24));
}

TEST_CASE("polar hull: points that span no interior give the empty set") {
    CHECK(convex_hull<4>(std::vector<RationalPoint<4>>{}).is_empty());
    CHECK(convex_hull<4>({{1, 2, 3, 4}}).is_empty());
    CHECK(convex_hull<4>({{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}, {3, 0, 5, 1}})
              .is_empty());
    CHECK(convex_hull<4>({{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}).is_empty());
    CHECK_THROWS_AS((convex_hull<4, double>({{0, 0, 0, std::numeric_limits<double>::infinity()}})), NumberError);
}
