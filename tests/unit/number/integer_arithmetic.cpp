// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/integer_arithmetic.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <vector>

using namespace cleave;

namespace {

/// A number outside any buffer.
struct Number {
    explicit Number(const mpz_class& z) : words((mpz_sizeinbase(z.get_mpz_t(), 2) + 63) / 64) {
        std::size_t count = 0;
        mpz_export(words.data(), &count, -1, 8, 0, 0, z.get_mpz_t());
        size = sgn(z) < 0 ? -static_cast<std::int32_t>(count) : static_cast<std::int32_t>(count);
    }
    [[nodiscard]] LimbView view() const { return {words.data(), size}; }

    std::vector<Limb> words;
    std::int32_t size = 0;
};

mpz_class value(LimbView x) {
    const mpz_class magnitude = oracle::from_words(x.limbs, x.count());
    return x.negative() ? mpz_class(-magnitude) : magnitude;
}

/// The value, and that the representation is normalised.
template <unsigned R>
bool holds(const LimbBuffer<R>& x, const mpz_class& z) {
    return value(x.view()) == z && (x.count() == 0 || x.data()[x.count() - 1] != 0);
}

/// Every operation into a result of R inline limbs: fresh, and in place of either operand.
template <unsigned R>
void check(const mpz_class& a, const mpz_class& b, const mpz_class& c) {
    const Number x(a);
    const Number y(b);
    const Number z(c);
    LimbBuffer<R> out(z.view());
    arithmetic::assign_sum(out, x.view(), y.view());
    REQUIRE(holds(out, a + b));
    arithmetic::assign_product(out, x.view(), y.view());
    REQUIRE(holds(out, a * b));
    out.assign(z.view());
    arithmetic::add_product(out, x.view(), y.view(), false);
    REQUIRE(holds(out, c + a * b));
    arithmetic::add_product(out, x.view(), y.view(), true);
    REQUIRE(holds(out, c));

    const auto in_place = [&](const mpz_class& start, auto operation, const mpz_class& expected) {
        out.assign(Number(start).view());
        operation();
        REQUIRE(holds(out, expected));
    };
    in_place(
        a, [&] { arithmetic::assign_sum(out, out.view(), y.view()); }, a + b);
    in_place(
        b, [&] { arithmetic::assign_sum(out, x.view(), out.view().negated()); }, a - b);
    in_place(
        a, [&] { arithmetic::assign_sum(out, out.view(), out.view()); }, a + a);
    in_place(
        a, [&] { arithmetic::assign_sum(out, out.view(), out.view().negated()); }, 0);
    in_place(
        a, [&] { arithmetic::assign_product(out, out.view(), y.view()); }, a * b);
    in_place(
        b, [&] { arithmetic::assign_product(out, x.view(), out.view()); }, a * b);
    in_place(
        a, [&] { arithmetic::assign_product(out, out.view(), out.view()); }, a * a);
    in_place(
        a, [&] { arithmetic::add_product(out, out.view(), y.view(), true); }, a - a * b);
    in_place(
        a, [&] { arithmetic::add_product(out, out.view(), out.view(), false); }, a + a * a);
    REQUIRE(arithmetic::equal(x.view(), y.view()) == (a == b));
    REQUIRE((arithmetic::compare(x.view(), y.view()) < 0) == (a < b));
    REQUIRE((arithmetic::compare(x.view(), y.view()) == 0) == (a == b));
}

}  // namespace

TEST_CASE("integer_arithmetic: every size around the inline boundary, equal and opposite operands among them") {
    oracle::Numbers numbers(1);
    for (std::size_t i = 0; i < scaled(6000); ++i) {
        const mpz_class a = numbers.number(i % 8);
        mpz_class b = numbers.number(1 + i % 5);
        if (i % 7 == 0) b = a;
        if (i % 7 == 1) b = -a;
        if (i % 7 == 2) b = a + (i % 2 == 0 ? 1 : -1);
        if (i % 7 == 3) b = -a + (i % 2 == 0 ? 1 : -1);
        const mpz_class c = i % 3 == 0 ? mpz_class(-a * b) : numbers.number(6);
        check<2>(a, b, c);
        check<3>(a, b, c);
        check<6>(a, b, c);
    }
}

TEST_CASE("integer_arithmetic: operands beyond the scratch memory") {
    oracle::Numbers numbers(2);
    for (std::size_t i = 0; i < scaled(200); ++i)
        check<6>(numbers.of_bits(64 * (20 + i % 60)), numbers.of_bits(64 * (20 + i % 50)), numbers.of_bits(6000));
}

TEST_CASE("integer_arithmetic: a carry out of the last inline limb goes to the heap, a fitting result does not") {
    const mpz_class full = oracle::power_of_two(128) - 1;
    const Number x(full);
    const Number one(1);
    LimbBuffer<2> out;
    arithmetic::assign_sum(out, x.view(), one.view());
    CHECK(out.on_heap());
    CHECK(holds(out, full + 1));
    LimbBuffer<3> wide(Number(oracle::power_of_two(192) - 2).view());
    arithmetic::assign_sum(wide, wide.view(), one.view());
    CHECK_FALSE(wide.on_heap());
    // Two limbs times two limbs that happen to fit three.
    LimbBuffer<3> product;
    const Number small(oracle::power_of_two(70));
    arithmetic::assign_product(product, small.view(), small.view());
    CHECK_FALSE(product.on_heap());
    CHECK(holds(product, oracle::power_of_two(140)));
}

TEST_CASE("integer_arithmetic: shifts by any distance, also in place") {
    oracle::Numbers numbers(3);
    for (std::size_t i = 0; i < scaled(3000); ++i) {
        const mpz_class a = numbers.number(i % 6);
        const std::size_t shift = i % 4 == 0 ? 64 * numbers.below(6) : numbers.below(400);
        mpz_class truncated;
        mpz_tdiv_q_2exp(truncated.get_mpz_t(), a.get_mpz_t(), shift);
        const Number x(a);
        LimbBuffer<3> out;
        arithmetic::assign_shifted_left(out, x.view(), shift);
        REQUIRE(holds(out, a << shift));
        arithmetic::assign_shifted_right(out, x.view(), shift);
        REQUIRE(holds(out, truncated));
        out.assign(x.view());
        arithmetic::assign_shifted_left(out, out.view(), shift);
        REQUIRE(holds(out, a << shift));
        out.assign(x.view());
        arithmetic::assign_shifted_right(out, out.view(), shift);
        REQUIRE(holds(out, truncated));
    }
}
