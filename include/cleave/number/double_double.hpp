// SPDX-License-Identifier: Apache-2.0
/// Unevaluated sums of two doubles: about 100 correct bits at ten times the cost of a double.
#ifndef CLEAVE_NUMBER_DOUBLE_DOUBLE_HPP
#define CLEAVE_NUMBER_DOUBLE_DOUBLE_HPP

#include <cleave/base/config.hpp>

#include <bit>
#include <cmath>
#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

/// hi + lo, with hi the double nearest to the sum [Dekker-1971].
///
/// Error bounds, u = 2^-53, barring overflow and underflow: a sum is within 3 u^2 (1 + 5 u) of the exact one,
/// relatively; a product within 7 u^2 + 2^-106, a quotient within 20 u^2 [Joldes-Muller-Popescu-2017]. All are below
/// `error` = 2^-100, which leaves room for an operand that is itself rounded to two doubles (2^-106). The bounds hold
/// whether or not the compiler contracts products and sums.
struct DoubleDouble {
    double hi = 0;
    double lo = 0;

    static constexpr double error = 0x1p-100;

    friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) noexcept {
        const DoubleDouble s = two_sum(a.hi, b.hi);
        const DoubleDouble t = two_sum(a.lo, b.lo);
        const DoubleDouble v = fast_two_sum(s.hi, s.lo + t.hi);
        return fast_two_sum(v.hi, t.lo + v.lo);
    }
    friend DoubleDouble operator-(DoubleDouble a) noexcept { return {-a.hi, -a.lo}; }
    friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) noexcept { return a + -b; }

    friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) noexcept {
        const DoubleDouble p = two_product(a.hi, b.hi);
        return fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
    }

    /// Requires: b is not zero.
    friend DoubleDouble operator/(DoubleDouble a, DoubleDouble b) noexcept {
        const double q = a.hi / b.hi;
        const DoubleDouble rest = a - b * DoubleDouble{q, 0};
        return fast_two_sum(q, rest.hi / b.hi);
    }

private:
    static DoubleDouble two_sum(double a, double b) noexcept {
        const double s = a + b;
        const double of_b = s - a;
        return {s, (a - (s - of_b)) + (b - of_b)};
    }

    /// Requires: |a| >= |b| or a = 0.
    static DoubleDouble fast_two_sum(double a, double b) noexcept {
        const double s = a + b;
        return {s, b - (s - a)};
    }

    /// The upper 26 bits.
    static double upper(double x) noexcept {
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~((std::uint64_t(1) << 27U) - 1));
    }

    /// Off by 2^-106 |a b| at most: the product of the two lower halves may have 54 bits.
    static DoubleDouble two_product(double a, double b) noexcept {
        const double p = a * b;
#ifdef FP_FAST_FMA
        return {p, std::fma(a, b, -p)};
#else
        const double a1 = upper(a), a2 = a - a1;
        const double b1 = upper(b), b2 = b - b1;
        return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
#endif
    }
};

CLEAVE_END_NAMESPACE

#endif
