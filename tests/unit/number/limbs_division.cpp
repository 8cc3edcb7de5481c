// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/limbs_division.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <vector>

using namespace cleave;

namespace {

constexpr Limb top_bit = Limb(1) << 63;

mpz_class value(const std::vector<Limb>& a) {
    return oracle::from_words(a.data(), a.size());
}

/// A divisor limb with its top bit set, often an extreme one.
Limb normalised_limb(oracle::Numbers& numbers) {
    switch (numbers.below(4)) {
        case 0:
            return top_bit;
        case 1:
            return ~Limb(0);
        default:
            return numbers.limb() | top_bit;
    }
}

}  // namespace

TEST_CASE("limbs_division: reciprocals are the defined ones") {
    oracle::Numbers numbers(1);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        const Limb d1 = normalised_limb(numbers);
        const Limb d0 = numbers.limb();
        const mpz_class b = oracle::power_of_two(64);
        REQUIRE(mpz_class(limbs::reciprocal(d1)) == (b * b - 1) / mpz_class(d1) - b);
        REQUIRE(mpz_class(limbs::reciprocal(d1, d0)) == (b * b * b - 1) / (mpz_class(d1) * b + mpz_class(d0)) - b);
    }
}

TEST_CASE("limbs_division: two limbs by one and three by two") {
    oracle::Numbers numbers(2);
    for (std::size_t i = 0; i < scaled(10000); ++i) {
        const Limb d1 = normalised_limb(numbers);
        const Limb d0 = numbers.limb();
        const Limb u0 = numbers.limb();
        const Limb high = i % 4 == 0 ? d1 - 1 : numbers.limb() % d1;
        const auto step = limbs::divide_2_by_1(high, u0, d1, limbs::reciprocal(d1));
        const mpz_class two = (mpz_class(high) << 64) + mpz_class(u0);
        REQUIRE(mpz_class(step.quotient) == two / mpz_class(d1));
        REQUIRE(mpz_class(step.remainder) == two % mpz_class(d1));

        const mpz_class d = (mpz_class(d1) << 64) + mpz_class(d0);
        mpz_class top = i % 4 == 0 ? mpz_class(d - 1)
                                   : mpz_class(((mpz_class(numbers.limb()) << 64) + mpz_class(numbers.limb())) % d);
        const Limb u2 = mpz_class(top >> 64).get_ui();
        const Limb u1 = mpz_class(top % oracle::power_of_two(64)).get_ui();
        const mpz_class three = (top << 64) + mpz_class(u0);
        REQUIRE(mpz_class(limbs::divide_3_by_2(u2, u1, u0, d1, d0, limbs::reciprocal(d1, d0))) == three / d);
    }
}

TEST_CASE("limbs_division: by one limb, with and without quotient") {
    oracle::Numbers numbers(3);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        std::vector<Limb> a(numbers.below(8));
        for (Limb& limb : a) limb = numbers.limb();
        Limb d = numbers.limb();
        if (d == 0) d = 1;
        std::vector<Limb> q(a.size());
        const limbs::LimbDivisor divisor(d);
        const Limb r = divisor.divide(q.data(), a.data(), a.size());
        REQUIRE(value(q) == value(a) / mpz_class(d));
        REQUIRE(mpz_class(r) == value(a) % mpz_class(d));
        REQUIRE(divisor.divide(nullptr, a.data(), a.size()) == r);
        REQUIRE(divisor.divide(a.data(), a.data(), a.size()) == r);
        REQUIRE(a == q);
    }
}

TEST_CASE("limbs_division: long division, and quotient digits that are first estimated too large") {
    oracle::Numbers numbers(4);
    for (std::size_t i = 0; i < scaled(10000); ++i) {
        const std::size_t m = 2 + numbers.below(5);
        std::vector<Limb> d(m);
        for (Limb& limb : d) limb = numbers.limb();
        d[m - 1] = normalised_limb(numbers);
        std::vector<Limb> u(m + numbers.below(5));
        for (Limb& limb : u) limb = numbers.limb();
        if (i % 2 == 0) {
            // A multiple of d, less one: its digits provoke every correction.
            const mpz_class wanted = value(d) * mpz_class(value(u) >> (64 * m)) + value(d) - 1;
            std::size_t count = 0;
            std::fill(u.begin(), u.end(), Limb(0));
            if (mpz_sizeinbase(wanted.get_mpz_t(), 2) <= 64 * u.size())
                mpz_export(u.data(), &count, -1, 8, 0, 0, wanted.get_mpz_t());
        }
        const mpz_class dividend = value(u);
        u.push_back(0);
        std::vector<Limb> q(u.size() - m);
        auto no_quotient = u;
        limbs::divide_normalised(q.data(), u.data(), u.size() - 1, d.data(), m);
        REQUIRE(value(q) == dividend / value(d));
        REQUIRE(value(u) == dividend % value(d));
        limbs::divide_normalised(nullptr, no_quotient.data(), u.size() - 1, d.data(), m);
        REQUIRE(no_quotient == u);
    }
}

TEST_CASE("limbs_division: long division where the leading limbs agree") {
    // u = d 2^64 - 1: the first digit is 2^64 - 1 and comes from the special case.
    const std::vector<Limb> d{5, top_bit};
    std::vector<Limb> u{~Limb(0), 4, top_bit, 0};
    std::vector<Limb> q(2);
    const mpz_class dividend = value(u);
    limbs::divide_normalised(q.data(), u.data(), 3, d.data(), 2);
    CHECK(value(q) == dividend / value(d));
    CHECK(q[0] == ~Limb(0));
    CHECK(value(u) == dividend % value(d));
}

TEST_CASE("limbs_division: inverses modulo a limb") {
    oracle::Numbers numbers(5);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        const Limb odd = numbers.limb() | 1;
        REQUIRE(odd * limbs::inverse_modulo_limb(odd) == 1);
    }
}

TEST_CASE("limbs_division: exact division from the low end") {
    oracle::Numbers numbers(6);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        std::vector<Limb> d(1 + numbers.below(5));
        for (Limb& limb : d) limb = numbers.limb();
        d[0] |= 1;
        std::vector<Limb> q(1 + numbers.below(5));
        for (Limb& limb : q) limb = numbers.limb();
        const mpz_class product = value(d) * value(q);
        std::vector<Limb> a(d.size() + q.size());
        std::size_t count = 0;
        mpz_export(a.data(), &count, -1, 8, 0, 0, product.get_mpz_t());
        limbs::divide_exactly(a.data(), a.data(), q.size(), d.data(), d.size());
        a.resize(q.size());
        REQUIRE(a == q);
    }
}
