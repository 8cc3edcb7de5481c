// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/fixed_digits.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

using namespace cleave;

namespace {

template <unsigned Bits>
mpz_class to_mpz(const FixedDigits<Bits>& x) {
    return oracle::to_mpz(x.to_fixed().to_integer());
}

/// |value| < 2^Bits, often the greatest possible.
template <unsigned Bits>
mpz_class value(oracle::Numbers& numbers) {
    if (numbers.below(4) == 0) {
        const mpz_class greatest = oracle::power_of_two(Bits) - 1;
        return numbers.below(2) == 0 ? greatest : mpz_class(-greatest);
    }
    return numbers.of_bits(numbers.below(Bits + 1));
}

template <unsigned Bits>
FixedDigits<Bits> digits(const mpz_class& z) {
    return FixedDigits<Bits>(oracle::from_mpz<8>(z));
}

template <unsigned A, unsigned B>
void check_sums(std::uint64_t seed) {
    oracle::Numbers numbers(seed);
    constexpr unsigned bits = A + B + 2;
    for (std::size_t i = 0; i < scaled(3000); ++i) {
        const mpz_class a = value<A>(numbers);
        const mpz_class b = value<B>(numbers);
        const mpz_class c = i % 5 == 0 ? a : value<A>(numbers);
        const mpz_class d = i % 5 == 0 ? b : value<B>(numbers);
        const auto x = digits<A>(a);
        const auto y = digits<B>(b);
        const auto z = digits<A>(c);
        const auto w = digits<B>(d);
        const auto difference = sum_of_products<bits>(plus_product(x, y), minus_product(z, w));
        REQUIRE(to_mpz(difference) == a * b - c * d);
        REQUIRE(difference.sign() == oracle::sign(a * b - c * d));
        REQUIRE(to_mpz(sum_of_products<A + B>(plus_product(x, w))) == a * d);
        const auto three = sum_of_products<bits>(minus_product(y, x), minus_product(w, z), plus_product(x, w));
        REQUIRE(to_mpz(three) == a * d - a * b - c * d);
        REQUIRE(three.sign() == oracle::sign(a * d - a * b - c * d));
    }
}

template <unsigned Bits>
void check_round_trip(std::uint64_t seed) {
    oracle::Numbers numbers(seed);
    for (std::size_t i = 0; i < scaled(500); ++i) {
        const mpz_class z = value<Bits>(numbers);
        const auto x = digits<Bits>(z);
        REQUIRE(to_mpz(x) == z);
        REQUIRE(x.sign() == oracle::sign(z));
    }
    const mpz_class limit = oracle::power_of_two(Bits);
    CHECK_THROWS_AS(digits<Bits>(limit), NumberError);
    CHECK_THROWS_AS(digits<Bits>(-limit), NumberError);
    CHECK(to_mpz(digits<Bits>(1 - limit)) == 1 - limit);
    CHECK(to_mpz(digits<Bits>(limit - 1)) == limit - 1);
    CHECK(FixedDigits<Bits>().sign() == Sign::zero);
}

}  // namespace

TEST_CASE("fixed_digits: what goes in comes out, and what is too large is refused") {
    check_round_trip<1>(1);
    check_round_trip<59>(2);
    check_round_trip<60>(3);
    check_round_trip<61>(4);
    check_round_trip<63>(5);
    check_round_trip<64>(6);
    check_round_trip<120>(7);
    check_round_trip<128>(8);
    check_round_trip<256>(9);
    check_round_trip<344>(10);
}

TEST_CASE("fixed_digits: sums of products are exact at the ends of the range") {
    check_sums<20, 30>(11);
    check_sums<60, 60>(12);
    check_sums<59, 61>(13);
    check_sums<56, 83>(14);
    check_sums<120, 60>(15);
    check_sums<121, 180>(16);
    check_sums<230, 344>(17);
}
