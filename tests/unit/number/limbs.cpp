// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/limbs.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <array>
#include <vector>

using namespace cleave;

namespace {

std::vector<Limb> random_limbs(oracle::Numbers& numbers, std::size_t n) {
    std::vector<Limb> r(n);
    for (Limb& limb : r) limb = numbers.limb();
    return r;
}

mpz_class value(const std::vector<Limb>& a) {
    return oracle::from_words(a.data(), a.size());
}

}  // namespace

TEST_CASE("limbs: addition and subtraction with carries, also in place") {
    oracle::Numbers numbers(1);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        const std::size_t n = 1 + numbers.below(9);
        const std::size_t m = numbers.below(n + 1);
        const auto a = random_limbs(numbers, n);
        const auto b = random_limbs(numbers, m);
        std::vector<Limb> sum(n);
        const Limb carry = limbs::add(sum.data(), a.data(), n, b.data(), m);
        REQUIRE(value(sum) + (mpz_class(carry) << (64 * n)) == value(a) + value(b));
        std::vector<Limb> difference(n);
        const Limb borrow = limbs::subtract(difference.data(), a.data(), n, b.data(), m);
        REQUIRE(value(difference) - (mpz_class(borrow) << (64 * n)) == value(a) - value(b));
        REQUIRE((borrow == 0) == (value(a) >= value(b)));
        auto in_place = a;
        REQUIRE(limbs::add(in_place.data(), in_place.data(), n, b.data(), m) == carry);
        REQUIRE(in_place == sum);
        in_place = a;
        REQUIRE(limbs::subtract(in_place.data(), in_place.data(), n, b.data(), m) == borrow);
        REQUIRE(in_place == difference);
    }
}

TEST_CASE("limbs: a carry runs through every limb") {
    const std::vector<Limb> ones(20, ~Limb(0));
    const Limb one = 1;
    std::vector<Limb> sum(20);
    CHECK(limbs::add(sum.data(), ones.data(), 20, &one, 1) == 1);
    CHECK(limbs::normalised_size(sum.data(), 20) == 0);
    CHECK(limbs::subtract(sum.data(), sum.data(), 20, &one, 1) == 1);
    CHECK(sum == ones);
}

TEST_CASE("limbs: multiples, added and subtracted") {
    oracle::Numbers numbers(2);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        const std::size_t n = 1 + numbers.below(9);
        const auto a = random_limbs(numbers, n);
        const auto b = random_limbs(numbers, n);
        const Limb factor = numbers.limb();
        const mpz_class multiple = value(a) * mpz_class(factor);
        std::vector<Limb> out(n);
        const Limb high = limbs::multiply_by_limb(out.data(), a.data(), n, factor);
        REQUIRE(value(out) + (mpz_class(high) << (64 * n)) == multiple);
        out = b;
        const Limb carry = limbs::add_multiple(out.data(), a.data(), n, factor);
        REQUIRE(value(out) + (mpz_class(carry) << (64 * n)) == value(b) + multiple);
        out = b;
        const Limb borrow = limbs::subtract_multiple(out.data(), a.data(), n, factor);
        REQUIRE(value(out) - (mpz_class(borrow) << (64 * n)) == value(b) - multiple);
        out = a;
        limbs::negate(out.data(), n);
        REQUIRE((value(out) + value(a)) % oracle::power_of_two(64 * n) == 0);
    }
}

TEST_CASE("limbs: shifts by every distance within a limb, also in place") {
    oracle::Numbers numbers(3);
    for (unsigned shift = 1; shift < 64; ++shift) {
        for (std::size_t n = 1; n < 6; ++n) {
            const auto a = random_limbs(numbers, n);
            std::vector<Limb> out(n);
            const Limb carried = limbs::shift_left(out.data(), a.data(), n, shift);
            CHECK(value(out) + (mpz_class(carried) << (64 * n)) == value(a) << shift);
            auto in_place = a;
            CHECK(limbs::shift_left(in_place.data(), in_place.data(), n, shift) == carried);
            CHECK(in_place == out);
            limbs::shift_right(out.data(), a.data(), n, shift);
            CHECK(value(out) == value(a) >> shift);
            in_place = a;
            limbs::shift_right(in_place.data(), in_place.data(), n, shift);
            CHECK(in_place == out);
        }
    }
    CHECK(limbs::shift_left(nullptr, nullptr, 0, 5) == 0);
}

TEST_CASE("limbs: sizes, bits, comparison, residue") {
    oracle::Numbers numbers(4);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        auto a = random_limbs(numbers, numbers.below(6));
        auto b = i % 3 == 0 ? a : random_limbs(numbers, numbers.below(6));
        const std::size_t n = limbs::normalised_size(a.data(), a.size());
        const std::size_t m = limbs::normalised_size(b.data(), b.size());
        const int order = limbs::compare(a.data(), n, b.data(), m);
        REQUIRE(sign_of_value(order) == sign_of_value(cmp(value(a), value(b))));
        REQUIRE(limbs::bit_length(a.data(), n) == (n == 0 ? 0 : mpz_sizeinbase(value(a).get_mpz_t(), 2)));
        if (n != 0) REQUIRE(limbs::trailing_zeros(a.data()) == mpz_scan1(value(a).get_mpz_t(), 0));
        REQUIRE(mpz_class(limbs::modulo_61(a.data(), n)) == value(a) % (oracle::power_of_two(61) - 1));
    }
    const std::vector<Limb> modulus{(Limb(1) << 61) - 1};
    CHECK(limbs::modulo_61(modulus.data(), 1) == 0);
}

TEST_CASE("limbs: the carry functions agree at compile time and at run time") {
    constexpr auto at_compile_time = [] {
        unsigned char carry = 1;
        unsigned char borrow = 1;
        const Limb sum = limbs::add_carry(~Limb(0), 0, carry);
        const Limb difference = limbs::subtract_borrow(0, ~Limb(0), borrow);
        return std::array<Limb, 4>{sum, carry, difference, borrow};
    };
    static_assert(at_compile_time() == std::array<Limb, 4>{0, 1, 0, 1});
    volatile Limb ones = ~Limb(0);
    unsigned char carry = 1;
    unsigned char borrow = 1;
    CHECK(limbs::add_carry(ones, 0, carry) == 0);
    CHECK(carry == 1);
    CHECK(limbs::subtract_borrow(0, ones, borrow) == 0);
    CHECK(borrow == 1);
}
