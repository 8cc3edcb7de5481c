// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/limbs_gcd.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

using namespace cleave;

namespace {

/// The gcd by the routine under test; a and b positive, b odd.
mpz_class long_gcd(const mpz_class& a, const mpz_class& b) {
    const std::size_t n = std::max(mpz_size(a.get_mpz_t()), mpz_size(b.get_mpz_t()));
    std::vector<Limb> u(n);
    std::vector<Limb> v(n);
    std::size_t count = 0;
    mpz_export(u.data(), &count, -1, 8, 0, 0, a.get_mpz_t());
    mpz_export(v.data(), &count, -1, 8, 0, 0, b.get_mpz_t());
    const std::size_t size = limbs::gcd_odd(u.data(), v.data(), n);
    return oracle::from_words(v.data(), size);
}

}  // namespace

TEST_CASE("limbs_gcd: limbs") {
    oracle::Numbers numbers(1);
    for (std::size_t i = 0; i < scaled(20000); ++i) {
        const Limb c = 1 + numbers.below(1000);
        const Limb a = numbers.limb() / (i % 2 == 0 ? 1 : 1000) * (i % 2 == 0 ? 1 : c);
        const Limb b = numbers.limb() / (i % 2 == 0 ? 1 : 1000) * (i % 2 == 0 ? 1 : c);
        REQUIRE(limbs::gcd(a, b) == std::gcd(a, b));
    }
    CHECK(limbs::gcd(0, 0) == 0);
    CHECK(limbs::gcd(0, 6) == 6);
    CHECK(limbs::gcd(6, 0) == 6);
    CHECK(limbs::gcd(~Limb(0), ~Limb(0)) == ~Limb(0));
    CHECK(limbs::gcd(Limb(1) << 63, 3 * (Limb(1) << 62)) == Limb(1) << 62);
}

TEST_CASE("limbs_gcd: long numbers with and without a common divisor") {
    oracle::Numbers numbers(2);
    for (std::size_t i = 0; i < scaled(10000); ++i) {
        const mpz_class common = i % 3 == 0 ? mpz_class(1) : mpz_class(abs(numbers.number(1 + i % 4)) | 1);
        const mpz_class a = abs(numbers.number(1 + i % 9)) * common;
        const mpz_class b = (abs(numbers.number(1 + i % 7)) | 1) * common;
        REQUIRE(long_gcd(a, b) == gcd(a, b));
    }
}

TEST_CASE("limbs_gcd: neighbours, multiples, powers of two and Fibonacci numbers") {
    mpz_class f = 1;
    mpz_class g = 1;
    for (int i = 0; i < 800; ++i) {  // the longest Euclidean sequences
        if (mpz_odd_p(f.get_mpz_t()) != 0) REQUIRE(long_gcd(g, f) == 1);
        const mpz_class next = f + g;
        f = g;
        g = next;
    }
    for (unsigned long n = 1; n < 400; n += 7) {
        const mpz_class p = oracle::power_of_two(n);
        CHECK(long_gcd(p, p + 1) == 1);
        CHECK(long_gcd(p - 1, p - 1) == p - 1);
        CHECK(long_gcd(p, p - 1) == 1);
        CHECK(long_gcd((p - 1) * (p + 1), p - 1) == p - 1);
        CHECK(long_gcd(p - 1, (p - 1) * (p + 1)) == p - 1);
        CHECK(long_gcd(0, p - 1) == p - 1);
        CHECK(long_gcd(p, 1) == 1);
        CHECK(long_gcd(1, p + 1) == 1);
    }
}

TEST_CASE("limbs_gcd: a batch's matrix has the promised divisibility") {
    oracle::Numbers numbers(3);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        const Limb a = numbers.limb();
        const Limb b = numbers.limb() | 1;
        const auto m = limbs::gcd_batch(a, b);
        const mpz_class first = mpz_class(m.f0) * mpz_class(a) + mpz_class(m.g0) * mpz_class(b);
        const mpz_class second = mpz_class(m.f1) * mpz_class(a) + mpz_class(m.g1) * mpz_class(b);
        REQUIRE(first % oracle::power_of_two(31) == 0);
        REQUIRE(second % oracle::power_of_two(31) == 0);
        REQUIRE(abs(mpz_class(m.f0)) + abs(mpz_class(m.g0)) <= oracle::power_of_two(31));
        REQUIRE(abs(mpz_class(m.f1)) + abs(mpz_class(m.g1)) <= oracle::power_of_two(31));
        const mpz_class determinant = abs(mpz_class(m.f0) * mpz_class(m.g1) - mpz_class(m.f1) * mpz_class(m.g0));
        REQUIRE(determinant == oracle::power_of_two(31));
    }
}
