// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/fixed_int.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <limits>
#include <type_traits>

using namespace cleave;

namespace {

template <unsigned Bits>
mpz_class to_mpz(const FixedInt<Bits>& x) {
    return oracle::to_mpz(x.to_integer());
}

template <unsigned Bits>
bool in_range(const mpz_class& z) {
    const mpz_class limit = oracle::power_of_two(Bits - 1);
    return -limit <= z && z < limit;
}

template <unsigned Bits>
mpz_class wrapped(const mpz_class& z) {
    mpz_class r;
    mpz_fdiv_r_2exp(r.get_mpz_t(), z.get_mpz_t(), Bits);
    if (r >= oracle::power_of_two(Bits - 1)) r -= oracle::power_of_two(Bits);
    return r;
}

/// In range; often next to an end of the range or of a limb.
template <unsigned Bits>
mpz_class value(oracle::Numbers& numbers) {
    if (numbers.below(12) == 0) return -oracle::power_of_two(Bits - 1) + static_cast<unsigned>(numbers.below(2));
    if (numbers.below(12) == 0) return oracle::power_of_two(Bits - 1) - 1 - static_cast<unsigned>(numbers.below(2));
    return wrapped<Bits>(numbers.number(1 + numbers.below(Bits / 64)));
}

template <unsigned Bits>
FixedInt<Bits> fixed(const mpz_class& z) {
    return FixedInt<Bits>(oracle::from_mpz<Bits / 64 + 2>(z));
}

/// The operation gives the exact value where it fits and throws where it does not.
template <unsigned Bits, class Operation>
bool right_or_throws(const mpz_class& exact, Operation operation) {
    try {
        const FixedInt<Bits> r = operation();
        return in_range<Bits>(exact) && to_mpz(r) == exact;
    } catch (const NumberError&) {
        return !in_range<Bits>(exact);
    }
}

template <unsigned W, unsigned A, unsigned B>
void check_mixed(std::uint64_t seed) {
    oracle::Numbers numbers(seed);
    for (std::size_t i = 0; i < scaled(2000); ++i) {
        const mpz_class x = value<A>(numbers);
        const mpz_class y = value<B>(numbers);
        const auto a = fixed<A>(x);
        const auto b = fixed<B>(y);
        REQUIRE(to_mpz(wrapping_product<W>(a, b)) == wrapped<W>(x * y));
        REQUIRE(to_mpz(wrapping_sum<W>(a, b)) == wrapped<W>(x + y));
        REQUIRE(to_mpz(wrapping_difference<W>(a, b)) == wrapped<W>(x - y));
        REQUIRE(to_mpz(multiply(a, b)) == x * y);
        REQUIRE(to_mpz(exact_sum(a, b)) == x + y);
        REQUIRE(to_mpz(exact_difference(a, b)) == x - y);
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("fixed_int: ring operations are exact or throw", "", ((unsigned Bits), Bits), 64, 128, 192, 256,
                       512, 1024, 2048) {
    oracle::Numbers numbers(Bits);
    std::size_t thrown = 0;
    for (std::size_t i = 0; i < scaled(3000); ++i) {
        const mpz_class x = value<Bits>(numbers);
        mpz_class y = value<Bits>(numbers);
        if (i % 9 == 0) y = wrapped<Bits>(-x);
        const auto a = fixed<Bits>(x);
        const auto b = fixed<Bits>(y);
        if (!in_range<Bits>(x * y)) ++thrown;
        REQUIRE(right_or_throws<Bits>(x + y, [&] { return a + b; }));
        REQUIRE(right_or_throws<Bits>(x - y, [&] { return a - b; }));
        REQUIRE(right_or_throws<Bits>(x * y, [&] { return a * b; }));
        REQUIRE(right_or_throws<Bits>(-x, [&] { return -a; }));
        REQUIRE(right_or_throws<Bits>(abs(x), [&] { return abs(a); }));
        REQUIRE((a < b) == (x < y));
        REQUIRE((a == b) == (x == y));
        REQUIRE((a <=> b == 0) == (x == y));
        REQUIRE(a.sign() == oracle::sign(x));
        REQUIRE(a.to_string() == x.get_str());
        REQUIRE(FixedInt<Bits>::from_string(x.get_str()) == a);
        REQUIRE(std::hash<FixedInt<Bits>>()(a) == a.to_integer().hash());
    }
    CHECK(thrown > 0);
    CHECK(thrown < scaled(3000));
}

TEST_CASE("fixed_int: operands may be the result") {
    FixedInt<128> a(1);
    const auto& alias = a;
    for (int i = 0; i < 126; ++i) a += alias;
    CHECK(to_mpz(a) == oracle::power_of_two(126));
    CHECK_THROWS_AS(a += alias, NumberError);
    a = -5;
    a *= alias;
    CHECK(a == 25);
    a -= alias;
    CHECK(a.is_zero());
    a = std::numeric_limits<std::int64_t>::min();
    a += alias;
    CHECK(to_mpz(a) == -oracle::power_of_two(64));
}

TEST_CASE("fixed_int: mixed widths, truncated and exact") {
    check_mixed<64, 64, 64>(1);
    check_mixed<128, 64, 64>(2);
    check_mixed<128, 128, 64>(3);
    check_mixed<192, 64, 128>(4);
    check_mixed<192, 128, 128>(5);
    check_mixed<256, 192, 128>(6);
    check_mixed<256, 256, 256>(7);
    check_mixed<64, 512, 256>(8);
    check_mixed<1088, 704, 384>(9);
}

TEST_CASE("fixed_int: widening keeps the value, narrowing keeps it or throws") {
    oracle::Numbers numbers(3);
    for (std::size_t i = 0; i < scaled(2000); ++i) {
        const mpz_class x = value<256>(numbers);
        const auto a = fixed<256>(x);
        const FixedInt<512> wide = a;
        REQUIRE(to_mpz(wide) == x);
        REQUIRE(widen<320>(a) == FixedInt<320>(a));
        REQUIRE(right_or_throws<128>(x, [&] { return FixedInt<128>(a); }));
        REQUIRE(right_or_throws<128>(x, [&] { return FixedInt<128>(a.to_integer()); }));
        REQUIRE(a.fits<128>() == in_range<128>(x));
        REQUIRE(to_mpz(FixedInt<128>::wrap(a)) == wrapped<128>(x));
    }
}

TEST_CASE("fixed_int: built-in integers at their limits") {
    CHECK(to_mpz(FixedInt<64>(std::numeric_limits<std::int64_t>::min())) == -oracle::power_of_two(63));
    CHECK_THROWS_AS(FixedInt<64>(std::numeric_limits<std::uint64_t>::max()), NumberError);
    CHECK(to_mpz(FixedInt<128>(std::numeric_limits<std::uint64_t>::max())) == oracle::power_of_two(64) - 1);
    CHECK_THROWS_AS(FixedInt<128>(~UInt128(0)), NumberError);
    CHECK(to_mpz(FixedInt<192>(~UInt128(0))) == oracle::power_of_two(128) - 1);
    CHECK(to_mpz(FixedInt<192>(Int128(-7))) == -7);
    CHECK_THROWS_AS(FixedInt<64>(Int128(1) << 64), NumberError);
    CHECK(FixedInt<64>(Int128(-3)) == -3);
    CHECK_THROWS_AS(FixedInt<64>((Int128(1) << 64) + 5), NumberError);
    CHECK_THROWS_AS(FixedInt<64>::from_string("9223372036854775808"), NumberError);
    CHECK(FixedInt<64>::from_string("-9223372036854775808") == std::numeric_limits<std::int64_t>::min());
    CHECK_THROWS_AS(FixedInt<128>::from_string("12x"), NumberError);
    CHECK_THROWS_AS(FixedInt<128>::from_string(""), NumberError);
}

TEST_CASE("fixed_int: usable in constant expressions, trivially copyable, no larger than its limbs") {
    constexpr FixedInt<256> a = FixedInt<256>(std::numeric_limits<std::int64_t>::min()) * 3 - 1;
    STATIC_REQUIRE(a + 1 == FixedInt<256>(std::numeric_limits<std::int64_t>::min()) * 3);
    STATIC_REQUIRE(a < 0 && (-a).sign() == Sign::plus);
    STATIC_REQUIRE(multiply(FixedInt<64>(-2), FixedInt<64>(3)) == FixedInt<128>(-6));
    STATIC_REQUIRE(std::is_trivially_copyable_v<FixedInt<256>>);
    STATIC_REQUIRE(sizeof(FixedInt<256>) == 32);
    STATIC_REQUIRE(std::is_convertible_v<FixedInt<128>, FixedInt<256>>);
    STATIC_REQUIRE(!std::is_convertible_v<FixedInt<256>, FixedInt<128>>);
}
