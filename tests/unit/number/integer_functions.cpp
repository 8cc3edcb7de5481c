// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/integer_functions.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <type_traits>

using namespace cleave;

namespace {

using oracle::from_mpz;
using oracle::to_mpz;

}  // namespace

TEST_CASE("integer_functions: absolute value and text") {
    CHECK(abs(Integer(-5)) == 5);
    CHECK(abs(Integer(5)) == 5);
    CHECK(abs(Integer(0)) == 0);
    CHECK(to_string(Integer(-12)) == "-12");
}

TEST_CASE("integer_functions: sums of products without temporaries") {
    oracle::Numbers numbers(1);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        const mpz_class x = numbers.number(i % 5);
        const mpz_class y = numbers.number(i % 7);
        const mpz_class z = i % 4 == 0 ? mpz_class(x * y) : numbers.number(i % 9);
        const auto a = from_mpz<6>(x);
        const auto b = from_mpz<3>(y);
        auto sum = from_mpz<4>(z);
        add_product(sum, a, b);
        REQUIRE(to_mpz(sum) == z + x * y);
        sub_product(sum, a, b);
        REQUIRE(to_mpz(sum) == z);
        sub_product(sum, a, b);
        REQUIRE(to_mpz(sum) == z - x * y);
        auto itself = a;
        add_product(itself, itself, b);
        REQUIRE(to_mpz(itself) == x + x * y);
        sub_product(itself, itself, itself);
        REQUIRE(to_mpz(itself) == (x + x * y) - (x + x * y) * (x + x * y));
        Integer zero;
        add_product(zero, zero, b);
        REQUIRE(zero.is_zero());
    }
}

TEST_CASE("integer_functions: division truncates toward zero, whatever the sizes and signs") {
    oracle::Numbers numbers(2);
    for (std::size_t i = 0; i < scaled(10000); ++i) {
        mpz_class y = numbers.number(1 + i % 6);
        if (y == 0) y = -1;
        mpz_class x = numbers.number(i % 9);
        if (i % 3 == 0) x = y * numbers.number(1 + i % 4) + (i % 2 == 0 ? -1 : 0);
        const auto a = from_mpz<6>(x);
        const auto b = from_mpz<4>(y);
        const auto [quotient, remainder] = divide(a, b);
        mpz_class q;
        mpz_class r;
        mpz_tdiv_qr(q.get_mpz_t(), r.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
        REQUIRE(to_mpz(quotient) == q);
        REQUIRE(to_mpz(remainder) == r);
        REQUIRE(quotient * b + remainder == a);
    }
}

TEST_CASE("integer_functions: exact division, by odd and even divisors of every size") {
    oracle::Numbers numbers(3);
    for (std::size_t i = 0; i < scaled(10000); ++i) {
        const mpz_class x = numbers.number(i % 9);
        mpz_class y = numbers.number(1 + i % 6);
        if (i % 4 == 0) y <<= numbers.below(200);
        if (i % 16 == 1) y = oracle::power_of_two(numbers.below(300));
        if (y == 0) y = 3;
        const auto product = from_mpz<6>(x * y);
        REQUIRE(to_mpz(exact_divide(product, from_mpz<4>(y))) == x);
        REQUIRE(to_mpz(exact_divide(product, -from_mpz<6>(y))) == -x);
    }
    static_assert(std::is_same_v<decltype(exact_divide(Integer(), WideInteger(1))), Integer>);
}

TEST_CASE("integer_functions: division by zero is an error") {
    CHECK_THROWS_AS(divide(Integer(1), Integer(0)), NumberError);
    CHECK_THROWS_AS(divide(Integer(0), Integer(0)), NumberError);
    CHECK_THROWS_AS(exact_divide(Integer(1), Integer(0)), NumberError);
    CHECK(divide(Integer(0), Integer(-5)).quotient.is_zero());
}

TEST_CASE("integer_functions: the greatest common divisor") {
    oracle::Numbers numbers(4);
    for (std::size_t i = 0; i < scaled(10000); ++i) {
        const mpz_class common = i % 2 == 0 ? mpz_class(1) : numbers.number(1 + i % 3);
        const mpz_class x = numbers.number(i % 8) * common;
        const mpz_class y = numbers.number(1 + i % 5) * common;
        const auto a = from_mpz<6>(x);
        const auto b = from_mpz<3>(y);
        REQUIRE(to_mpz(gcd(a, b)) == gcd(x, y));
        REQUIRE(gcd(b, a) == gcd(a, b));
        REQUIRE(to_mpz(gcd(a << (i % 100), b << (i % 77))) == gcd(mpz_class(x << (i % 100)), mpz_class(y << (i % 77))));
    }
    CHECK(gcd(Integer(0), Integer(0)) == 0);
    CHECK(gcd(Integer(0), Integer(-6)) == 6);
    CHECK(gcd(Integer(-4), Integer(0)) == 4);
    CHECK(gcd(Integer(-4), Integer(-6)) == 2);
    const Integer big = Integer::scaled(-9, 700);
    CHECK(gcd(big, big) == -big);
    CHECK(gcd(big, Integer(0)) == -big);
}

TEST_CASE("integer_functions: the greatest common divisor of thousands of bits") {
    oracle::Numbers numbers(5);
    for (std::size_t i = 0; i < scaled(30); ++i) {
        const mpz_class common = numbers.of_bits(1 + numbers.below(2000));
        const mpz_class x = numbers.of_bits(1 + numbers.below(4000)) * common;
        const mpz_class y = numbers.of_bits(1 + numbers.below(4000)) * common;
        REQUIRE(to_mpz(gcd(from_mpz<6>(x), from_mpz<6>(y))) == gcd(x, y));
    }
}
