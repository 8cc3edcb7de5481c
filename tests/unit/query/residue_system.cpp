// SPDX-License-Identifier: Apache-2.0
#include <cleave/query/residue_system.hpp>

#include "support/catch.hpp"

#include <cstdint>
#include <string>
#include <vector>

using namespace cleave;

namespace {

/// The system of p/q modulo `count` primes.
ResidueSystem system_of(const Integer& p, const Integer& q, int count) {
    ResidueSystem system;
    PrimeFields primes;
    for (int i = 0; i < count; ++i) {
        const PrimeField f = primes.next();
        system.add(f, f.multiply(f.residue(p), f.inverse(f.residue(q))));
    }
    return system;
}

Integer power(int base, int n) {
    Integer result = 1;
    for (int i = 0; i < n; ++i) result *= Integer(base);
    return result;
}

}  // namespace

TEST_CASE("prime field: the largest primes below 2^62", "[residue_system]") {
    PrimeFields primes;
    const std::uint64_t top = std::uint64_t(1) << 62U;
    std::vector<std::uint64_t> found;
    for (int i = 0; i < 3; ++i) found.push_back(top - primes.next().modulus());
    // As tables of primes below powers of two have them.
    CHECK(found == std::vector<std::uint64_t>{57, 87, 117});
    for (std::uint64_t c = 1; c < 57; c += 2) CHECK_FALSE(PrimeField(c).is_prime());
}

TEST_CASE("prime field: arithmetic", "[residue_system]") {
    const PrimeField f(57);
    const std::uint64_t p = f.modulus();
    CHECK(f.add(p - 1, 1) == 0);
    CHECK(f.add(p - 1, p - 1) == p - 2);
    CHECK(f.negate(0) == 0);
    CHECK(f.negate(1) == p - 1);
    CHECK(f.multiply(p - 1, p - 1) == 1);
    CHECK(f.power(2, 62) == 57);
    for (const std::uint64_t a : {std::uint64_t(1), std::uint64_t(2), p / 2, p - 1})
        CHECK(f.multiply(a, f.inverse(a)) == 1);
    CHECK(f.residue(Integer(0)) == 0);
    CHECK(f.residue(Integer(-1)) == p - 1);
    CHECK(f.residue(Integer(p) * Integer(p)) == 0);
    CHECK(f.residue(power(2, 62 * 5)) == f.power(57, 5));
    CHECK(f.residue(-power(2, 62 * 5)) == f.negate(f.power(57, 5)));
}

TEST_CASE("residue system: an integer comes back once the modulus exceeds it", "[residue_system]") {
    const Integer x = power(7, 100);
    const ResidueSystem system = system_of(x, 1, 6);
    CHECK(system.modulus() > x);
    CHECK(system.value() == x);
}

TEST_CASE("residue system: fractions are found, and only fractions that are there", "[residue_system]") {
    const Integer p = -power(7, 60);
    const Integer q = power(10, 40) + Integer(7);
    const ResidueSystem system = system_of(p, q, 8);
    CHECK(system.may_be_fraction([&](const Integer& a, const Integer& b) { return a == -p && b == q; }));
    CHECK_FALSE(system.may_be_fraction([&](const Integer& a, const Integer& b) { return digit_count(a, b) <= 91; }));
    CHECK(digit_count(p, q) == 51 + 41);
    CHECK(system.may_be_fraction([&](const Integer& a, const Integer& b) { return digit_count(a, b) <= 92; }));
    CHECK(system_of(0, 1, 3).may_be_fraction([](const Integer& a, const Integer&) { return a.is_zero(); }));
}

TEST_CASE("digit count: around powers of ten", "[residue_system]") {
    CHECK(digit_count(Integer(0)) == 1);
    CHECK(digit_count(Integer(-9)) == 1);
    for (const int n : {1, 2, 5, 17, 18, 19, 20, 100, 1000, 2000}) {
        const Integer ten = power(10, n);
        CHECK(digit_count(ten) == std::size_t(n) + 1);
        CHECK(digit_count(ten - Integer(1)) == std::size_t(n));
        CHECK(digit_count(-ten) == std::size_t(n) + 1);
    }
    for (int n = 0; n < 500; ++n) CHECK(digit_count(power(2, n)) == power(2, n).to_string().size());
    CHECK(digit_count(Integer(15), Integer(1)) == 2);
    CHECK(digit_count(Integer(-15), Integer(7)) == 3);
}
