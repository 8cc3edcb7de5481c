// SPDX-License-Identifier: Apache-2.0
#include <cleave/shape/rational_point.hpp>

#include "support/catch.hpp"

#include <limits>

using namespace cleave;

TEST_CASE("rational point: any exact coordinate is kept") {
    CHECK(to_rational(3) == 3);
    CHECK(to_rational(-0.75) == Rational(-3, 4));
    CHECK(to_rational(Integer(7)) == 7);
    CHECK(to_rational(Rational(2, 3)) == Rational(2, 3));
    CHECK(to_rational_point(std::array{0.5, 2.0}) == RationalPoint<2>{Rational(1, 2), 2});
}

TEST_CASE("rational point: a double is not the decimal it was written as") {
    CHECK(to_rational(0.1) != Rational(1, 10));
    CHECK(to_rational(0.1) == Rational(to_rational(3602879701896397.0) / to_rational(0x1p55)));
}

TEST_CASE("rational point: infinities and NaN are no coordinates") {
    CHECK_THROWS_AS(to_rational(std::numeric_limits<double>::infinity()), NumberError);
    CHECK_THROWS_AS(to_rational(std::numeric_limits<double>::quiet_NaN()), NumberError);
}
