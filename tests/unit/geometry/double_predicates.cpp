// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/double_predicates.hpp>
//
#include <cleave/number/rational.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

using namespace cleave;
using support::Dice;

namespace {

using P = std::array<double, 3>;

Sign exact_side_of(const P& p, const P& q, const P& r, const P& s) {
    std::array<std::array<Rational, 3>, 3> m;
    for (std::size_t i = 0; i < 3; ++i) {
        m[0][i] = Rational(q[i]) - Rational(p[i]);
        m[1][i] = Rational(r[i]) - Rational(p[i]);
        m[2][i] = Rational(s[i]) - Rational(p[i]);
    }
    Rational det(0);
    for (std::size_t i = 0; i < 3; ++i)
        det += m[2][i] * (m[0][(i + 1) % 3] * m[1][(i + 2) % 3] - m[0][(i + 2) % 3] * m[1][(i + 1) % 3]);
    return number_traits<Rational>::sign(det);
}

Sign exact_turn_of(const P& p, const P& q, const P& r, Projection x) {
    const Rational det((Rational(q[x.u]) - Rational(p[x.u])) * (Rational(r[x.v]) - Rational(p[x.v])) -
                       (Rational(q[x.v]) - Rational(p[x.v])) * (Rational(r[x.u]) - Rational(p[x.u])));
    return number_traits<Rational>::sign(det);
}

}  // namespace

TEST_CASE("double predicates: orientation") {
    CHECK(plane_side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == Sign::plus);
    CHECK(plane_side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, -1}) == Sign::minus);
    CHECK(plane_side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}) == Sign::zero);
    CHECK(turn({0, 0, 9}, {1, 0, 3}, {1, 1, 5}, Projection::along(2)) == Sign::plus);
    CHECK(turn({0, 0, 9}, {1, 0, 3}, {1, 1, 5}, Projection::along(2, true)) == Sign::minus);
    CHECK(turn({0, 0, 9}, {1, 1, 3}, {2, 2, 5}, Projection::along(2)) == Sign::zero);
}

TEST_CASE("double predicates: every sign is exact, from nearly flat to flat and over all exponents") {
    Dice dice(17);
    std::size_t zeros = 0;
    std::size_t undecided = 0;
    const std::size_t cases = scaled(4000);
    for (std::size_t n = 0; n < cases; ++n) {
        std::array<P, 4> p;
        for (P& x : p)
            for (double& c : x) c = dice.between(-8, 8);
        switch (n % 4) {
            case 0:
                break;  // small integers: often coplanar
            case 1:     // a point a few units in the last place off the plane of three others
                for (std::size_t i = 0; i < 3; ++i) p[3][i] = (p[0][i] + p[1][i] + p[2][i]) / 3;
                break;
            case 2:  // one scale for all, beyond what products can hold
                for (P& x : p)
                    for (double& c : x) c = std::ldexp(c + 0.1, n % 8 == 2 ? 1000 : -1000);
                break;
            default:  // and one for each coordinate
                for (P& x : p)
                    for (double& c : x) c = std::ldexp(c, dice.between(-1050, 1000));
        }
        const Sign s = exact_side_of(p[0], p[1], p[2], p[3]);
        CHECK(plane_side(p[0], p[1], p[2], p[3]) == s);
        CHECK(plane_side(p[1], p[0], p[2], p[3]) == -s);
        zeros += s == Sign::zero ? 1U : 0U;
        const auto quick = approximate_side(p[0], p[1], p[2], p[3]);
        if (quick) CHECK(*quick == s);
        undecided += quick ? 0U : 1U;
        for (unsigned axis = 0; axis < 3; ++axis)
            CHECK(turn(p[0], p[1], p[2], Projection::along(axis)) ==
                  exact_turn_of(p[0], p[1], p[2], Projection::along(axis)));
    }
    CHECK(zeros > cases / 100);
    CHECK(undecided > zeros);  // the filter abstains where the answer is zero, and in extreme cases besides
}

TEST_CASE("double predicates: a turn of points that are known up to an error") {
    const P p{0, 0, 0};
    const P q{1, 0, 0};
    const P r{1, 0x1p-10, 0};
    CHECK(approximate_turn(p, q, r, Projection::along(2), 0x1p-14) == Sign::plus);
    CHECK_FALSE(approximate_turn(p, q, r, Projection::along(2), 0x1p-9).has_value());
    CHECK_FALSE(approximate_turn(p, q, r, Projection::along(2), std::numeric_limits<double>::infinity()).has_value());
}
