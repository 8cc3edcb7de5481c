// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/double.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

using namespace cleave;

namespace {

using oracle::from_mpz;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
mpq_class value(T x) {
    return mpq_class(static_cast<double>(x));
}

/// Whether `r` is what IEEE rounding makes of q: checked against r's neighbours, with exact rationals.
template <class T>
bool is_rounded(const mpq_class& q, T r, Rounding direction) {
    const T largest = std::numeric_limits<T>::max();
    const T inf = std::numeric_limits<T>::infinity();
    if (r == 0 && std::signbit(r)) return false;
    if (direction == Rounding::down) {
        if (r == inf) return false;
        if (r == -inf) return q < value(-largest);
        const T above = std::nextafter(r, inf);
        return value(r) <= q && (above == inf || q < value(above));
    }
    if (direction == Rounding::up) return is_rounded(-q, r == 0 ? r : -r, Rounding::down);
    // The overflow threshold is half a unit beyond the largest number.
    mpq_class threshold = value(largest) + (value(largest) - value(std::nextafter(largest, T(0)))) / 2;
    if (r == inf) return q >= threshold;
    if (r == -inf) return q <= -threshold;
    const T above = std::nextafter(r, inf);
    const T below = std::nextafter(r, -inf);
    const mpq_class upper = above == inf ? threshold : mpq_class((value(r) + value(above)) / 2);
    const mpq_class lower = below == -inf ? mpq_class(-threshold) : mpq_class((value(r) + value(below)) / 2);
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    const bool even = (std::bit_cast<Bits>(r) & 1) == 0;
    return (lower < q || (even && lower == q)) && (q < upper || (even && q == upper));
}

constexpr std::array directions{Rounding::nearest, Rounding::down, Rounding::up};

template <class T>
void check_ratio(const mpz_class& num, const mpz_class& den) {
    mpq_class q(num, den);
    q.canonicalize();
    for (const Rounding direction : directions) {
        const T r = round_ratio_to<T>(from_mpz<3>(num), from_mpz<6>(den), direction);
        INFO(num << " / " << den << " -> " << r);
        REQUIRE(is_rounded(q, r, direction));
    }
}

}  // namespace

TEST_CASE("double: a double is taken apart exactly") {
    CHECK(decompose(0.0).mantissa == 0);
    CHECK(decompose(-0.0).exponent == 0);
    CHECK(decompose(1.0).mantissa == 1);
    CHECK(decompose(-0.75).mantissa == -3);
    CHECK(decompose(-0.75).exponent == -2);
    CHECK(decompose(std::numeric_limits<double>::denorm_min()).exponent == -1074);
    CHECK(decompose(std::numeric_limits<double>::max()).mantissa == (std::int64_t(1) << 53) - 1);
    CHECK(decompose(std::numeric_limits<double>::max()).exponent == 971);
    CHECK_THROWS_AS(decompose(infinity), NumberError);
    CHECK_THROWS_AS(decompose(-infinity), NumberError);
    CHECK_THROWS_AS(decompose(std::numeric_limits<double>::quiet_NaN()), NumberError);
}

TEST_CASE("double: taking apart and rounding again is the identity on every kind of double") {
    oracle::Numbers numbers(3);
    for (std::size_t i = 0; i < scaled(20000); ++i) {
        std::uint64_t pattern = numbers.word();
        if (i % 4 == 0) pattern &= 0x800f'ffff'ffff'ffffU;  // subnormal
        const double x = std::bit_cast<double>(pattern);
        if (!std::isfinite(x) || x == 0) continue;
        const DoubleParts parts = decompose(x);
        REQUIRE((parts.mantissa & 1) == 1);
        for (const Rounding direction : directions)
            REQUIRE(to_double(Integer(parts.mantissa), parts.exponent, direction) == x);
    }
}

TEMPLATE_TEST_CASE("double: integers times powers of two are rounded correctly", "", double, float) {
    oracle::Numbers numbers(4);
    for (std::size_t i = 0; i < scaled(20000); ++i) {
        const mpz_class m = numbers.number(1 + i % 5);
        const int exponent = static_cast<int>(numbers.below(i % 2 == 0 ? 2500 : 60)) - (i % 2 == 0 ? 1300 : 30);
        mpq_class q(m);
        if (exponent >= 0)
            q *= oracle::power_of_two(static_cast<unsigned long>(exponent));
        else
            q /= oracle::power_of_two(static_cast<unsigned long>(-exponent));
        for (const Rounding direction : directions) {
            const TestType r = round_to<TestType>(from_mpz<4>(m), exponent, direction);
            INFO(m << " * 2^" << exponent << " -> " << r);
            REQUIRE(is_rounded(q, r, direction));
        }
    }
}

TEST_CASE("double: ties go to even, and a bit far below a tie breaks it") {
    const Integer tie = Integer::scaled(1, 53) + 1;  // halfway between 2^53 and 2^53 + 2
    CHECK(to_double(tie) == 0x1p53);
    CHECK(to_double(tie + 2) == 0x1p53 + 4);
    CHECK(to_double((tie << 500) + 1, -500) == 0x1p53 + 2);
    CHECK(to_double((tie << 500) - 1, -500) == 0x1p53);
    CHECK(to_double(-tie) == -0x1p53);
    CHECK(to_double(tie, 0, Rounding::up) == 0x1p53 + 2);
    CHECK(to_double(-tie, 0, Rounding::up) == -0x1p53);
    CHECK(to_double(-tie, 0, Rounding::down) == -0x1p53 - 2);
}

TEST_CASE("double: the ends of the range") {
    const double least = std::numeric_limits<double>::denorm_min();
    const double largest = std::numeric_limits<double>::max();
    CHECK(to_double(Integer(1), -1074) == least);
    CHECK(to_double(Integer(1), -1075) == 0.0);  // a tie between zero and the least: even is zero
    CHECK(to_double(Integer(3), -1076) == least);
    CHECK(to_double(Integer(1), -1075, Rounding::up) == least);
    CHECK(to_double(Integer(1), -5000, Rounding::up) == least);
    CHECK(to_double(Integer(-1), -5000, Rounding::up) == 0.0);
    CHECK_FALSE(std::signbit(to_double(Integer(-1), -5000)));
    CHECK(to_double(Integer(-1), -5000, Rounding::down) == -least);
    CHECK(to_double(Integer::scaled(1, 54) - 1, 970) == infinity);  // half a unit beyond the largest: up to even
    CHECK(to_double(Integer::scaled(1, 55) - 3, 969) == largest);
    CHECK(to_double(Integer(1), 1024) == infinity);
    CHECK(to_double(Integer(1), 1024, Rounding::down) == largest);
    CHECK(to_double(Integer(-1), 1024, Rounding::up) == -largest);
    CHECK(to_double(Integer(-1), 1024, Rounding::down) == -infinity);
    CHECK(to_double(Integer(1), std::numeric_limits<std::int64_t>::max()) == infinity);
    CHECK(to_double(Integer(1), std::numeric_limits<std::int64_t>::min()) == 0.0);
    CHECK(to_double(Integer(0), std::numeric_limits<std::int64_t>::max()) == 0.0);
    CHECK(round_to<float>(Integer(1), 128) == std::numeric_limits<float>::infinity());
    CHECK(round_to<float>(Integer(1), -149) == std::numeric_limits<float>::denorm_min());
}

TEMPLATE_TEST_CASE("double: ratios are rounded correctly", "", double, float) {
    oracle::Numbers numbers(5);
    for (std::size_t i = 0; i < scaled(20000); ++i) {
        mpz_class num = numbers.number(1 + i % 7);
        mpz_class den = numbers.number(1 + i % 5);
        if (den == 0) den = 1;
        if (i % 5 == 0) num *= den;                               // an exact quotient
        if (i % 5 == 1) num = num * den + (i % 2 == 0 ? 1 : -1);  // next to one
        check_ratio<TestType>(num, den);
    }
}

TEST_CASE("double: ratios next to a tie, with denominators of several limbs") {
    // (2 m + 1) / 2 for a 53-bit m is a tie; the denominator is multiplied by a long number and the numerator moved by
    // one.
    oracle::Numbers numbers(6);
    for (std::size_t i = 0; i < scaled(3000); ++i) {
        const mpz_class m = numbers.of_bits(54) | 1;
        const mpz_class factor = abs(numbers.of_bits(1 + numbers.below(300)));
        for (int off = -1; off <= 1; ++off) check_ratio<double>(m * factor + off, 2 * factor);
    }
}

TEST_CASE("double: ratios of very long numbers, beyond and below the range") {
    oracle::Numbers numbers(7);
    for (std::size_t i = 0; i < scaled(500); ++i) {
        const mpz_class num = numbers.of_bits(1 + numbers.below(2400));
        const mpz_class den = numbers.of_bits(1 + numbers.below(2400));
        check_ratio<double>(num, den);
        check_ratio<float>(num, den);
    }
}

TEST_CASE("double: a ratio with denominator zero throws") {
    CHECK_THROWS_AS(ratio_to_double(Integer(1), Integer(0)), NumberError);
    CHECK_THROWS_AS(ratio_to_float(Integer(0), Integer(0)), NumberError);
    CHECK(ratio_to_double(Integer(0), Integer(-5)) == 0.0);
    CHECK(ratio_to_float(Integer(1), Integer(3)) == 1.0F / 3.0F);
}
