// SPDX-License-Identifier: Apache-2.0
#include <cleave/query/measure_fraction.hpp>

#include "support/catch.hpp"

#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/sphere.hpp>

#include <cstddef>
#include <optional>

using namespace cleave;

namespace {

Integer power(int base, int n) {
    Integer result = 1;
    for (int i = 0; i < n; ++i) result *= Integer(base);
    return result;
}

/// A sum with `terms` different odd denominators that cancel all but for num / den.
ShortSum long_way_to(const Integer& num, const Integer& den, int terms) {
    ShortSum sum;
    for (int i = 0; i < terms; ++i) {
        const Integer odd = power(3, 40) * power(10, 20) + Integer(2 * i + 1);
        sum.add(Integer(i + 1), odd);
        sum.add(Integer(-i - 1), odd);
    }
    sum.add(num, den);
    return sum;
}

}  // namespace

TEST_CASE("short sum: the limit is exact, with and without the test by residues", "[measure_fraction]") {
    const Integer num = power(7, 20);   // 17 digits
    const Integer den = power(11, 10);  // 11 digits
    const ShortSum sum = long_way_to(num, den, 20);
    for (const std::size_t exact_bits : {std::size_t(0), std::size_t(1) << 20U}) {
        const std::optional<Fraction> value = sum.value(28, exact_bits);
        REQUIRE(value);
        CHECK(value->num == num);
        CHECK(value->den == den);
        CHECK_FALSE(sum.value(27, exact_bits));
    }
    CHECK(sum.may_be_short(28));
    CHECK_FALSE(sum.may_be_short(27));
}

TEST_CASE("short sum: integers, zero and simple denominators", "[measure_fraction]") {
    ShortSum sum;
    CHECK(sum.value(1) == Fraction{});
    CHECK(sum.value(1, 0) == Fraction{});
    sum.add(5, 12);
    sum.add(7, 12);
    CHECK(sum.value(1) == Fraction{1, 1});
    sum.add(1, 7);
    sum.add(-8, 7);
    CHECK(sum.value(1, 0) == Fraction{0, 1});
    sum.add(1, -48);
    CHECK(sum.value(3, 0) == Fraction{-1, 48});
    CHECK_FALSE(sum.value(2, 0));
    CHECK_FALSE(sum.value(2));
}

TEST_CASE("short sum: a prime that divides a denominator is passed over", "[measure_fraction]") {
    const Integer p((std::uint64_t(1) << 62U) - 57);
    ShortSum sum;
    sum.add(1, p);
    sum.add(3, 7);
    const std::optional<Fraction> value = sum.value(60, 0);
    REQUIRE(value);
    CHECK(value->den == p * Integer(7));
    CHECK(value->num == Integer(7) + Integer(3) * p);
}

TEST_CASE("measure fraction: agrees with the exact measure wherever that is short", "[measure_fraction]") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> b = box<3>({1, 1, 1}, {3, 3, 3});
    CHECK(measure_fraction(a | b, 2000) == Fraction{15, 1});
    CHECK(measure_fraction(a | b, 2) == Fraction{15, 1});
    CHECK_FALSE(measure_fraction(a | b, 1));
    CHECK(measure_fraction(Region<3>::empty(), 1) == Fraction{0, 1});
    CHECK_FALSE(measure_fraction(Region<3>::full(), 2000));
    const Region<3> ball = sphere<Rational>({0, 0, 0}, 1, {16, 8});
    const Region<3> moved = sphere<Rational>({Rational(1, 3), Rational(1, 5), Rational(1, 7)}, 1, {16, 8});
    const Region<3> both = ball & moved;
    const Fraction exact = number_traits<Rational>::to_fraction(*measure(both));
    const std::size_t digits = digit_count(exact.num, exact.den);
    CHECK(digits > 200);  // else this proves little
    CHECK(measure_fraction(both, digits) == exact);
    CHECK_FALSE(measure_fraction(both, digits - 1));
    CHECK_FALSE(measure_fraction(both, 100));
}

TEST_CASE("measure fraction: one and two dimensions", "[measure_fraction]") {
    CHECK(measure_fraction(intervals<Rational>({{0, Rational(1, 3)}, {1, 2}}), 3) == Fraction{4, 3});
    CHECK(measure_fraction(disc<Rational>({0, 0}, 2, 4), 3) == Fraction{8, 1});
}
