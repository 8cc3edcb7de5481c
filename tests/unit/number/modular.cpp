// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/modular.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <limits>

using namespace cleave;

namespace {

template <std::uint64_t P>
mpz_class residue(const mpz_class& z) {
    mpz_class r;
    const mpz_class p(static_cast<unsigned long>(P));
    mpz_fdiv_r(r.get_mpz_t(), z.get_mpz_t(), p.get_mpz_t());
    return r;
}

template <std::uint64_t P>
bool same(Modular<P> x, const mpz_class& z) {
    return x.value() < P && mpz_class(static_cast<unsigned long>(x.value())) == residue<P>(z);
}

}  // namespace

TEST_CASE("modular: both moduli are prime") {
    CHECK(mpz_probab_prime_p(mpz_class(static_cast<unsigned long>(first_prime)).get_mpz_t(), 40) != 0);
    CHECK(mpz_probab_prime_p(mpz_class(static_cast<unsigned long>(second_prime)).get_mpz_t(), 40) != 0);
}

TEMPLATE_TEST_CASE_SIG("modular: the map from the integers keeps sums, differences and products", "",
                       ((std::uint64_t P), P), first_prime, second_prime) {
    oracle::Numbers numbers(1);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        const mpz_class a = numbers.number(9);
        const mpz_class b = i % 10 == 0 ? mpz_class(-a) : numbers.number(9);
        const Modular<P> x(oracle::from_mpz<3>(a));
        const Modular<P> y(oracle::from_mpz<8>(b));
        REQUIRE(same(x, a));
        REQUIRE(same(x + y, a + b));
        REQUIRE(same(x - y, a - b));
        REQUIRE(same(x * y, a * b));
        REQUIRE(same(-x, -a));
        if (P == first_prime) REQUIRE(oracle::from_mpz<3>(a).modulo_61() == x.value());
    }
}

TEMPLATE_TEST_CASE_SIG("modular: built-in integers at their limits", "", ((std::uint64_t P), P), first_prime,
                       second_prime) {
    CHECK(same(Modular<P>(std::numeric_limits<std::int64_t>::min()), -oracle::power_of_two(63)));
    CHECK(same(Modular<P>(std::numeric_limits<std::uint64_t>::max()), oracle::power_of_two(64) - 1));
    CHECK(same(Modular<P>(Int128(1) << 126), oracle::power_of_two(126)));
    CHECK(same(Modular<P>(~UInt128(0)), oracle::power_of_two(128) - 1));
    CHECK(same(Modular<P>(-1), mpz_class(-1)));
    CHECK(Modular<P>(P).is_zero());
    CHECK((-Modular<P>(0)).value() == 0);
}

TEMPLATE_TEST_CASE_SIG("modular: inverses, one at a time and in batches", "", ((std::uint64_t P), P), first_prime,
                       second_prime) {
    oracle::Numbers numbers(2);
    std::vector<Modular<P>> elements;
    for (std::size_t i = 0; i < 200; ++i) elements.emplace_back(i % 7 == 3 ? 0 : numbers.word());
    std::vector<Modular<P>> inverses = elements;
    invert_all(std::span(inverses));
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (elements[i].is_zero()) {
            CHECK(inverses[i].is_zero());
            continue;
        }
        CHECK(elements[i] * inverses[i] == Modular<P>(1));
        CHECK(inverses[i] == elements[i].inverse());
        CHECK(elements[i] / elements[i] == 1);
    }
    CHECK_THROWS_AS(Modular<P>(0).inverse(), NumberError);
    // Powers of two and their negatives, which have a way of their own modulo 2^61-1.
    for (int i = 0; i < 62; ++i) {
        const Modular<P> power = Modular<P>(2).power(std::uint64_t(i));
        CHECK(power * power.inverse() == Modular<P>(1));
        CHECK(-power * (-power).inverse() == Modular<P>(1));
        CHECK(power.inverse() == power.power(P - 2));
    }
    const Modular<P> largest = -Modular<P>(1);
    CHECK(largest * largest == Modular<P>(1));
    CHECK(Modular<P>(0).power(0) == 1);
    CHECK(Modular<P>(3).power(4) == 81);
    invert_all(std::span<Modular<P>>());
}

TEST_CASE("modular: usable in constant expressions") {
    STATIC_REQUIRE(Mod61(2).power(61) == Mod61(1));
    STATIC_REQUIRE(Mod62(2).power(62) == Mod62(57));
    STATIC_REQUIRE(Mod61(7) * Mod61(7).inverse() == Mod61(1));
}
