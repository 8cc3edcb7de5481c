// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/coordinates.hpp>

#include "support/catch.hpp"
#include "support/exact_types.hpp"

#include <array>
#include <cstdint>
#include <limits>

using namespace cleave;

static_assert(Coordinate<int> && Coordinate<std::uint64_t> && Coordinate<double> && Coordinate<float> &&
              Coordinate<Integer> && Coordinate<Rational>);
static_assert(!Coordinate<const char*> && !Coordinate<Sign>);

TEST_CASE("coordinates: every kind of number is a fraction in lowest terms") {
    CHECK(exact_fraction(-6) == Fraction{-6, 1});
    CHECK(exact_fraction(std::numeric_limits<std::uint64_t>::max()) == Fraction{(Integer(1) << 64) - 1, 1});
    CHECK(exact_fraction(std::numeric_limits<std::int64_t>::min()) == Fraction{-(Integer(1) << 63), 1});
    CHECK(exact_fraction(0.75) == Fraction{3, 4});
    CHECK(exact_fraction(-96.0) == Fraction{-96, 1});
    CHECK(exact_fraction(0.0) == Fraction{0, 1});
    CHECK(exact_fraction(-0.0) == Fraction{0, 1});
    CHECK(exact_fraction(0.5F) == Fraction{1, 2});
    CHECK(exact_fraction(0x1p-1074) == Fraction{1, Integer(1) << 1074});
    CHECK(exact_fraction(rational(10, 4)) == Fraction{5, 2});
    CHECK_THROWS_AS(exact_fraction(std::numeric_limits<double>::quiet_NaN()), NumberError);
}

TEST_CASE("coordinates: a ring gets the least common denominator, a field none") {
    const auto ring = over_common_denominator<Integer>(rational(1, 6), 0.25, 5, rational(-3, 10));
    CHECK(ring.denominator == Integer(60));
    CHECK(ring.numerators == std::array<Integer, 4>{10, 15, 300, -18});
    const auto field = over_common_denominator<Rational>(rational(1, 6), 0.25, 5, rational(-3, 10));
    CHECK(field.denominator == rational(1));
    CHECK(field.numerators == std::array<Rational, 4>{rational(1, 6), rational(1, 4), rational(5), rational(-3, 10)});
    const auto array = over_common_denominator<Integer>(std::array<double, 2>{0.5, 0.125});
    CHECK(array.denominator == Integer(8));
    CHECK(array.numerators == std::array<Integer, 2>{4, 1});
}

TEST_CASE("coordinates: a value that does not fit a fixed width is refused") {
    CHECK_THROWS_AS(over_common_denominator<FixedInt<128>>(0x1p-200, 1), NumberError);
    CHECK_THROWS_AS(over_common_denominator<FixedInt<128>>(0x1p+200), NumberError);
}

TEMPLATE_LIST_TEST_CASE("coordinates: a ratio is a number of the field", "", ExactTypes) {
    using N = TestType;
    CHECK(ratio(N(-6), N(4)) == fraction_of<N>(-3, 2));
    CHECK(ratio(N(0), N(5)) == fraction_of<N>(0));
}
