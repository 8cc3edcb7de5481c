// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/double_double.hpp>
//
#include <cleave/number/double.hpp>
#include <cleave/number/integer.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

using namespace cleave;
using support::Dice;

namespace {

constexpr int least = -500;  // all numbers below are multiples of 2^least

/// Exactly, times 2^-least.
WideInteger scaled(double x) {
    const DoubleParts parts = decompose(x);
    return parts.mantissa == 0 ? WideInteger()
                               : WideInteger::scaled(parts.mantissa, static_cast<std::size_t>(parts.exponent - least));
}

WideInteger scaled(const DoubleDouble& x) {
    WideInteger sum = scaled(x.hi);
    sum += scaled(x.lo);
    return sum;
}

/// Whether |computed - exact| <= 2^-100 |exact|.
bool is_close(WideInteger computed, const WideInteger& exact) {
    computed -= exact;
    if (computed.sign() == Sign::minus) computed.negate();
    WideInteger bound = exact;
    if (bound.sign() == Sign::minus) bound.negate();
    computed <<= 100;
    bound -= computed;
    return bound.sign() != Sign::minus;
}

double draw(Dice& dice) {
    const double x = double(dice.between(-(1 << 29), 1 << 29)) * 0x1p30 + double(dice.between(-(1 << 29), 1 << 29));
    return std::ldexp(x, dice.between(-60, 10));
}

/// A normalised pair, as close to cancelling others as they come.
DoubleDouble draw_pair(Dice& dice) {
    return DoubleDouble{draw(dice), 0} + DoubleDouble{std::ldexp(draw(dice), -60), 0};
}

}  // namespace

TEST_CASE("double-double: sums and products are within their bound, cancellation included") {
    Dice dice(1);
    for (int n = 0; n < 20'000; ++n) {
        const DoubleDouble a = draw_pair(dice);
        const DoubleDouble b =
            n % 3 == 0 ? DoubleDouble{-a.hi, 0} + DoubleDouble{std::ldexp(draw(dice), -50), 0} : draw_pair(dice);
        WideInteger sum = scaled(a);
        sum += scaled(b);
        CHECK(is_close(scaled(a + b), sum));
        WideInteger difference = scaled(a);
        difference -= scaled(b);
        CHECK(is_close(scaled(a - b), difference));
        WideInteger product;
        add_product(product, scaled(a), scaled(b));
        WideInteger computed = scaled(a * b);
        computed <<= static_cast<std::size_t>(-least);  // the product is scaled twice
        CHECK(is_close(computed, product));
    }
}

TEST_CASE("double-double: a quotient times the divisor is the dividend") {
    Dice dice(2);
    for (int n = 0; n < 20'000; ++n) {
        const DoubleDouble a = draw_pair(dice);
        const DoubleDouble b = draw_pair(dice);
        if (b.hi == 0) continue;
        WideInteger product;
        add_product(product, scaled(a / b), scaled(b));
        WideInteger dividend = scaled(a);
        dividend <<= static_cast<std::size_t>(-least);
        CHECK(is_close(product, dividend));
    }
}

TEST_CASE("double-double: small integers are exact") {
    for (int a = -20; a <= 20; ++a)
        for (int b = -20; b <= 20; ++b) {
            const DoubleDouble x{double(a), 0}, y{double(b), 0};
            CHECK((x + y).hi == a + b);
            CHECK((x * y).hi == a * b);
            CHECK((x * y).lo == 0);
            if (b != 0 && a % b == 0) CHECK((x / y).hi == a / b);
        }
}
