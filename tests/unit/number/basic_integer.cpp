// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/basic_integer.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <limits>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>

using namespace cleave;

namespace {

using oracle::from_mpz;
using oracle::to_mpz;

template <class T>
bool survives(T value) {
    const std::string text = std::is_signed_v<T> ? std::to_string(static_cast<long long>(value))
                                                 : std::to_string(static_cast<unsigned long long>(value));
    return Integer(value).to_string() == text;
}

template <class T>
bool limits_survive() {
    return survives(std::numeric_limits<T>::min()) && survives(std::numeric_limits<T>::max()) && survives(T(0)) &&
           survives(T(1));
}

}  // namespace

TEST_CASE("basic_integer: every built-in integer at its limits") {
    CHECK(limits_survive<signed char>());
    CHECK(limits_survive<unsigned char>());
    CHECK(limits_survive<short>());
    CHECK(limits_survive<unsigned short>());
    CHECK(limits_survive<int>());
    CHECK(limits_survive<unsigned>());
    CHECK(limits_survive<long>());
    CHECK(limits_survive<unsigned long>());
    CHECK(limits_survive<long long>());
    CHECK(limits_survive<unsigned long long>());
    CHECK(Integer(true) == 1);
    CHECK(to_mpz(Integer(~UInt128(0))) == oracle::power_of_two(128) - 1);
    CHECK(to_mpz(Integer(Int128(1) << 126)) == oracle::power_of_two(126));
    const Int128 least = -(Int128(1) << 126) - (Int128(1) << 126);
    CHECK(to_mpz(Integer(least)) == -oracle::power_of_two(127));
    CHECK(Integer(Int128(-1)) == -1);
    CHECK(Integer(UInt128(7)) == 7);
    CHECK(Integer().is_zero());
}

TEST_CASE("basic_integer: back to 64 bits where the value fits") {
    for (const std::int64_t x : {std::int64_t(0), std::int64_t(5), std::int64_t(-5),
                                 std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
        REQUIRE(Integer(x).fits_int64());
        CHECK(Integer(x).to_int64() == x);
    }
    CHECK_FALSE(Integer(std::uint64_t(1) << 63).fits_int64());
    CHECK_FALSE((Integer(std::numeric_limits<std::int64_t>::min()) - 1).fits_int64());
    CHECK_FALSE(Integer::scaled(1, 64).fits_int64());
#if CLEAVE_CONTRACTS >= 1
    CHECK_THROWS_AS(Integer::scaled(1, 64).to_int64(), ContractViolation);
#endif
}

TEMPLATE_TEST_CASE_SIG("basic_integer: ring operations and comparisons agree with GMP", "",
                       ((unsigned K, unsigned M), K, M), (2, 2), (2, 6), (6, 2), (6, 6), (6, 24), (24, 6)) {
    oracle::Numbers numbers(K * 100 + M);
    for (std::size_t i = 0; i < scaled(3000); ++i) {
        const mpz_class x = numbers.number(i % 9);
        const mpz_class y = i % 6 == 0 ? x : (i % 6 == 1 ? mpz_class(-x) : numbers.number(1 + i % 8));
        const auto a = from_mpz<K>(x);
        const auto b = from_mpz<M>(y);
        static_assert(std::is_same_v<decltype(a + b), BasicInteger<(K > M ? K : M)>>);
        REQUIRE(to_mpz(a + b) == x + y);
        REQUIRE(to_mpz(a - b) == x - y);
        REQUIRE(to_mpz(a * b) == x * y);
        REQUIRE(to_mpz(-a) == -x);
        REQUIRE(to_mpz(-BasicInteger<K>(a)) == -x);
        REQUIRE(+a == a);
        REQUIRE((a == b) == (x == y));
        REQUIRE((a != b) == (x != y));
        REQUIRE((a < b) == (x < y));
        REQUIRE((a >= b) == (x >= y));
        REQUIRE(((a <=> b) == 0) == (x == y));
        auto c = a;
        REQUIRE(to_mpz(c += b) == x + y);
        REQUIRE(to_mpz(c -= b) == x);
        REQUIRE(to_mpz(c *= b) == x * y);
        REQUIRE(a.sign() == oracle::sign(x));
        REQUIRE(a.is_zero() == (x == 0));
        REQUIRE(a.is_one() == (x == 1));
        REQUIRE(a.is_odd() == (mpz_odd_p(x.get_mpz_t()) != 0));
        REQUIRE(a.bit_length() == (x == 0 ? 0 : mpz_sizeinbase(x.get_mpz_t(), 2)));
        REQUIRE(a.trailing_zeros() == (x == 0 ? 0 : mpz_scan1(x.get_mpz_t(), 0)));
        REQUIRE(a.to_string() == x.get_str());
        REQUIRE(BasicInteger<K>::from_string(x.get_str()) == a);
        if (x == y) REQUIRE(a.hash() == b.hash());
    }
}

TEST_CASE("basic_integer: the operands of a compound operation may be the same object") {
    oracle::Numbers numbers(3);
    for (std::size_t i = 0; i < scaled(1000); ++i) {
        const mpz_class x = numbers.number(i % 9);
        auto a = from_mpz<6>(x);
        const auto& alias = a;
        a += alias;
        REQUIRE(to_mpz(a) == 2 * x);
        a *= alias;
        REQUIRE(to_mpz(a) == 4 * x * x);
        a -= alias;
        REQUIRE(a.is_zero());
        a = from_mpz<6>(x);
        a = alias;
        REQUIRE(to_mpz(a) == x);
    }
}

TEST_CASE("basic_integer: built-in operands on either side") {
    const Integer a(5);
    CHECK(a + 2 == 7);
    CHECK(2 + a == 7);
    CHECK(a - 7 == -2);
    CHECK(7 - a == 2);
    CHECK(a * -3 == -15);
    CHECK(3U * a == 15);
    CHECK(a > 4);
    CHECK(4LL < a);
    Integer b = a;
    b += 1;
    b -= 10ULL;
    b *= -2;
    CHECK(b == 8);
}

TEST_CASE("basic_integer: moving leaves zero behind, on the heap and inline") {
    for (const std::size_t shift : {3U, 500U}) {
        Integer a = Integer::scaled(-7, shift);
        const Integer copy = a;
        Integer b(std::move(a));
        CHECK(a.is_zero());
        CHECK(b == copy);
        a = std::move(b);
        CHECK(b.is_zero());
        CHECK(a == copy);
        b = a + 1;
        CHECK(b - a == 1);
    }
}

TEST_CASE("basic_integer: changing the inline size keeps the value") {
    oracle::Numbers numbers(4);
    for (std::size_t i = 0; i < scaled(500); ++i) {
        const mpz_class x = numbers.number(i % 12);
        const auto a = from_mpz<24>(x);
        const Integer narrow(a);
        REQUIRE(to_mpz(narrow) == x);
        WideInteger wide = narrow;
        REQUIRE(wide == a);
        wide = 1;
        wide = narrow;
        REQUIRE(wide == a);
        REQUIRE(narrow.hash() == a.hash());
    }
    static_assert(std::is_convertible_v<Integer, WideInteger>);
    static_assert(!std::is_convertible_v<WideInteger, Integer>);
    static_assert(std::is_constructible_v<Integer, WideInteger>);
    static_assert(sizeof(Integer) == 56);
    static_assert(std::is_nothrow_move_constructible_v<Integer> && std::is_nothrow_move_assignable_v<Integer>);
}

TEST_CASE("basic_integer: from limbs, with leading zeros and zero itself") {
    const std::uint64_t limbs[] = {5, 1, 0, 0};
    CHECK(to_mpz(Integer::from_limbs(Sign::minus, limbs)) == -(oracle::power_of_two(64) + 5));
    CHECK(Integer::from_limbs(Sign::zero, {}).is_zero());
    CHECK(Integer::from_limbs(Sign::minus, std::span(limbs + 2, 2)).is_zero());
    CHECK(Integer::from_limbs(Sign::minus, std::span(limbs + 2, 2)).sign() == Sign::zero);
    CHECK(Integer(77).limbs().size() == 1);
    CHECK(Integer(0).limbs().empty());
}

TEST_CASE("basic_integer: scaled mantissas, and shifts that truncate toward zero") {
    CHECK(to_mpz(Integer::scaled(-3, 200)) == -3 * oracle::power_of_two(200));
    CHECK(Integer::scaled(std::numeric_limits<std::int64_t>::min(), 1) ==
          Integer(std::numeric_limits<std::int64_t>::min()) * 2);
    CHECK(Integer::scaled(0, 1000).is_zero());
    CHECK((Integer(-1) >> 1).is_zero());
    CHECK((Integer(-5) >> 1) == -2);
    CHECK((Integer(5) << 0) == 5);
    CHECK((Integer(5) >> 1000).is_zero());
    Integer a(-5);
    a <<= 300;
    a >>= 299;
    CHECK(a == -10);
}

TEST_CASE("basic_integer: text that is not an integer is an error with the text in it") {
    for (const char* text : {"", "-", "+", "--1", "1-", " 1", "1 ", "0x10", "1e3", "1.5", "1/2"})
        CHECK_THROWS_AS(Integer::from_string(text), NumberError);
    try {
        static_cast<void>(Integer::from_string("12z"));
    } catch (const NumberError& error) {
        CHECK(std::string(error.what()).find("12z") != std::string::npos);
    }
    CHECK(Integer::from_string("+17") == 17);
    CHECK(Integer::from_string("-0").sign() == Sign::zero);
    CHECK(Integer::from_string("-000123") == -123);
}

TEST_CASE("basic_integer: a hundred thousand digits, there and back") {
    std::string digits = "7";
    for (std::size_t i = 1; i < scaled(100'000); ++i) digits.push_back(static_cast<char>('0' + (i * i / 7) % 10));
    const Integer x = Integer::from_string(digits);
    CHECK(x.to_string() == digits);
    CHECK(to_mpz(x) == mpz_class(digits));
}

TEST_CASE("basic_integer: the residue modulo 2^61 - 1 is that of the value") {
    oracle::Numbers numbers(6);
    const mpz_class p = oracle::power_of_two(61) - 1;
    for (std::size_t i = 0; i < scaled(2000); ++i) {
        const mpz_class x = i % 5 == 0 ? mpz_class(p * numbers.number(3)) : numbers.number(8);
        mpz_class r;
        mpz_fdiv_r(r.get_mpz_t(), x.get_mpz_t(), p.get_mpz_t());
        REQUIRE(mpz_class(from_mpz<6>(x).modulo_61()) == r);
    }
}

TEST_CASE("basic_integer: hashes tell values apart and feed the standard containers") {
    std::unordered_set<Integer> set;
    for (int i = -500; i < 500; ++i) set.insert(Integer::scaled(i, 70));
    CHECK(set.size() == 1000);
    CHECK(set.contains(Integer::scaled(-3, 70)));
    CHECK_FALSE(set.contains(Integer(-3)));
    CHECK(Integer(1).hash() != Integer(-1).hash());
}
