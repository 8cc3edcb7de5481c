// SPDX-License-Identifier: Apache-2.0
/// Exact tests on points: against rational arithmetic, where the filter decides and where it cannot.
#include <cleave/mesh/point_tests.hpp>

#include "support/catch.hpp"
#include "support/property.hpp"

#include <cmath>
#include <limits>

using namespace cleave;
using support::property;

namespace {

template <class T>
using Points = std::vector<std::array<T, 3>>;

template <class T>
Rational exact(const T& x) {
    return Rational(x);
}

template <class T>
Rational turn_value(const Points<T>& p, Projection h) {
    const Rational qu = exact(p[1][h.u]) - exact(p[0][h.u]), qv = exact(p[1][h.v]) - exact(p[0][h.v]);
    const Rational ru = exact(p[2][h.u]) - exact(p[0][h.u]), rv = exact(p[2][h.v]) - exact(p[0][h.v]);
    const Rational result = qu * rv - qv * ru;
    return result;
}

template <class T>
Rational side_value(const Points<T>& p) {
    std::array<std::array<Rational, 3>, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t x = 0; x < 3; ++x) d[i][x] = exact(p[i + 1][x]) - exact(p[0][x]);
    }
    Rational det(0);
    for (std::size_t x = 0; x < 3; ++x) {
        const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
        det += (d[0][y] * d[1][z] - d[0][z] * d[1][y]) * d[2][x];
    }
    return det;
}

/// All tests on four points against their definition.
template <class T>
void check(const Points<T>& points) {
    const PointTests<T> tests(points);
    bool collinear = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
        for (const bool reversed : {false, true}) {
            const Projection h = Projection::along(axis, reversed);
            const Sign expected = number_traits<Rational>::sign(turn_value(points, h));
            REQUIRE(tests.turn(0, 1, 2, h) == expected);
            REQUIRE(tests.turn(1, 0, 2, h) == -expected);
            collinear = collinear && expected == Sign::zero;
            REQUIRE(tests.less(0, 1, h) == (std::pair(exact(points[0][h.u]), exact(points[0][h.v])) <
                                            std::pair(exact(points[1][h.u]), exact(points[1][h.v]))));
        }
    }
    REQUIRE(tests.collinear(0, 1, 2) == collinear);
    const auto axis = tests.projectable_axis(0, 1, 2);
    REQUIRE(axis.has_value() != collinear);
    if (axis) REQUIRE(tests.turn(0, 1, 2, Projection::along(*axis)) != Sign::zero);
    REQUIRE(tests.side(0, 1, 2, 3) == number_traits<Rational>::sign(side_value(points)));
    REQUIRE(tests.side(1, 0, 2, 3) == -number_traits<Rational>::sign(side_value(points)));
}

}  // namespace

TEST_CASE("point_tests: a counter-clockwise triangle turns left seen from the plus end of each axis") {
    // In each coordinate plane: e_u, e_v and the origin.
    for (unsigned axis = 0; axis < 3; ++axis) {
        Points<double> points(3, {0, 0, 0});
        points[1][(axis + 1) % 3] = 1;
        points[2][(axis + 2) % 3] = 1;
        const PointTests<double> tests(points);
        REQUIRE(tests.turn(0, 1, 2, Projection::along(axis)) == Sign::plus);
        REQUIRE(tests.turn(0, 1, 2, Projection::along(axis, true)) == Sign::minus);
        // The point above sees it counter-clockwise: plus is outside.
        points.push_back({0, 0, 0});
        points[3][axis] = 1;
        REQUIRE(PointTests<double>(points).side(0, 1, 2, 3) == Sign::plus);
        points[3][axis] = -1;
        REQUIRE(PointTests<double>(points).side(0, 1, 2, 3) == Sign::minus);
    }
}

TEST_CASE("point_tests: small integers, where most fours are degenerate") {
    property("doubles and rationals agree with the definition", [] {
        Points<double> doubles;
        Points<Rational> rationals;
        const int den = support::draw_int(1, 4);
        for (std::size_t i = 0; i < 4; ++i) {
            std::array<int, 3> p;
            for (int& x : p) x = support::draw_int(-2, 3);
            doubles.push_back({double(p[0]), double(p[1]), double(p[2])});
            rationals.push_back({Rational(p[0]) / den, Rational(p[1]) / 7, Rational(p[2]) / (den + 1)});
        }
        check(doubles);
        check(rationals);
    });
}

TEST_CASE("point_tests: one unit in the last place decides where rounding errors hide it") {
    // Points on the line x = y = z, one of them moved by the least possible amount: every product is rounded.
    const double a = 0.1, b = 0.7, c = 12.9;
    for (const double moved : {c, std::nextafter(c, 13.0), std::nextafter(c, 12.0)}) {
        check<double>({{a, a, a}, {b, b, b}, {c, c, moved}, {1, 2, 3}});
        check<double>({{a, a, 0}, {b, b, 0}, {c, moved, 0}, {1, 2, 3}});
        check<double>({{a, b, c}, {b, c, a}, {c, a, b}, {moved, a, b}});
    }
    // A plane x + y + z = 1 in doubles that cannot lie on it exactly.
    check<double>({{0.1, 0.2, 0.7}, {0.3, 0.3, 0.4}, {0.9, 0.05, 0.05}, {0.25, 0.25, 0.5}});
    // Exact points whose rounded positions coincide or turn the other way.
    const Rational third = Rational(1) / 3, tiny = Rational(1) / Rational(1e30);
    const Rational third_up = third + tiny, third_down = third - tiny;
    check<Rational>({{0, 0, 0}, {third, third, 0}, {1, 1, 0}, {0, 0, 1}});
    check<Rational>({{0, 0, 0}, {third, third_up, 0}, {1, 1, 0}, {0, 0, 1}});
    check<Rational>({{0, 0, 0}, {third, third_down, 0}, {1, 1, 0}, {0, 0, tiny}});
}

TEST_CASE("point_tests: overflow and underflow are decided exactly") {
    const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
    check<double>({{-huge, -huge, 0}, {huge, huge, 0}, {huge, -huge, tiny}, {0, 0, huge}});
    check<double>({{-huge, -huge, -huge}, {huge, huge, huge}, {0, 0, 0}, {tiny, 0, 0}});
    check<double>({{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}});
    check<double>({{0, 0, 0}, {tiny, tiny, 0}, {3 * tiny, 3 * tiny, 0}, {huge, 0, tiny}});
    check<double>({{1e-200, 0, 0}, {0, 1e-200, 0}, {0, 0, 1e-200}, {1e-200, 1e-200, 1e-200}});
    const Rational huge_square = Rational(huge) * Rational(huge), tiny_square = Rational(tiny) * Rational(tiny);
    check<Rational>({{huge_square, 0, 0}, {0, huge_square, 0}, {0, 0, huge_square}, {1, 1, 1}});
    check<Rational>({{tiny_square, 0, 0}, {0, tiny_square, 0}, {0, 0, 0}, {0, 0, tiny_square}});
}

TEST_CASE("point_tests: doubles of every size agree with rational arithmetic") {
    property("random bits", [] {
        Points<double> points;
        for (std::size_t i = 0; i < 4; ++i) {
            std::array<double, 3> p;
            for (double& x : p) {
                const int mantissa = support::draw_int(-1000, 1001);
                x = std::ldexp(double(mantissa), support::draw_int(-60, 60));
            }
            points.push_back(p);
        }
        check(points);
        // A fourth point near the plane of the others, and a third near the line of two.
        for (std::size_t x = 0; x < 3; ++x) points[3][x] = points[0][x] + (points[1][x] - points[2][x]);
        check(points);
        for (std::size_t x = 0; x < 3; ++x) points[2][x] = points[0][x] + 3 * (points[1][x] - points[0][x]);
        check(points);
    });
}
