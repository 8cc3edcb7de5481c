// SPDX-License-Identifier: Apache-2.0
/// Division of limb arrays: by one limb, long (Knuth's algorithm D) and exact (from the low end).
///
/// Quotient digits come from precomputed reciprocals instead of the divide instruction:
/// N. Moller, T. Granlund, "Improved division by invariant integers", IEEE Trans. Computers 60 (2011), algorithms 2-6.
/// Exact division: T. Jebelean, "An algorithm for exact division", J. Symbolic Computation 15 (1993).
#ifndef CLEAVE_NUMBER_LIMBS_DIVISION_HPP
#define CLEAVE_NUMBER_LIMBS_DIVISION_HPP

#include <cleave/number/limbs.hpp>

CLEAVE_BEGIN_NAMESPACE

namespace limbs {

/// floor((2^128 - 1) / d) - 2^64. Requires: the top bit of d is set.
[[nodiscard]] constexpr Limb reciprocal(Limb d) noexcept {
    return static_cast<Limb>(((UInt128(~d) << bits) | ~Limb(0)) / d);
}

/// A quotient limb and a remainder of one limb.
struct LimbDivision {
    Limb quotient;
    Limb remainder;
};

/// (u1 2^64 + u0) / d. Requires: u1 < d, the top bit of d is set, v = reciprocal(d).
[[nodiscard]] constexpr LimbDivision divide_2_by_1(Limb u1, Limb u0, Limb d, Limb v) noexcept {
    const UInt128 q = UInt128(v) * u1 + ((UInt128(u1) << bits) | u0);
    Limb quotient = static_cast<Limb>(q >> bits) + 1;
    Limb remainder = u0 - quotient * d;
    if (remainder > static_cast<Limb>(q)) {
        --quotient;
        remainder += d;
    }
    if (remainder >= d) {
        ++quotient;
        remainder -= d;
    }
    return {quotient, remainder};
}

/// A divisor of one limb, prepared for many divisions.
class LimbDivisor {
public:
    /// Requires: d != 0.
    explicit constexpr LimbDivisor(Limb d) noexcept
        : shift_(static_cast<unsigned>(std::countl_zero(d))),
          normalised_(d << shift_),
          inverse_(reciprocal(normalised_)) {}

    /// quotient = floor(a / d) over n limbs; `quotient` may be a, or null where only the remainder matters.
    /// Returns: the remainder.
    constexpr Limb divide(Limb* quotient, const Limb* a, std::size_t n) const noexcept {
        if (n == 0) return 0;
        const unsigned rest = bits - shift_;
        Limb remainder = shift_ == 0 ? 0 : a[n - 1] >> rest;
        for (std::size_t i = n; i-- != 0;) {
            const Limb below = (shift_ == 0 || i == 0) ? 0 : a[i - 1] >> rest;
            const LimbDivision step = divide_2_by_1(remainder, (a[i] << shift_) | below, normalised_, inverse_);
            remainder = step.remainder;
            if (quotient != nullptr) quotient[i] = step.quotient;
        }
        return remainder >> shift_;
    }

private:
    unsigned shift_;
    Limb normalised_;
    Limb inverse_;
};

/// The reciprocal of d1 2^64 + d0 that divides three limbs by two. Requires: the top bit of d1 is set.
[[nodiscard]] constexpr Limb reciprocal(Limb d1, Limb d0) noexcept {
    Limb v = reciprocal(d1);
    Limb p = d1 * v + d0;
    if (p < d0) {
        --v;
        if (p >= d1) {
            --v;
            p -= d1;
        }
        p -= d1;
    }
    const UInt128 t = UInt128(v) * d0;
    p += static_cast<Limb>(t >> bits);
    if (p < static_cast<Limb>(t >> bits)) {
        --v;
        if (((UInt128(p) << bits) | static_cast<Limb>(t)) >= ((UInt128(d1) << bits) | d0)) --v;
    }
    return v;
}

/// floor((u2, u1, u0) / (d1, d0)). Requires: (u2, u1) < (d1, d0), the top bit of d1 is set, v = reciprocal(d1, d0).
[[nodiscard]] constexpr Limb divide_3_by_2(Limb u2, Limb u1, Limb u0, Limb d1, Limb d0, Limb v) noexcept {
    const UInt128 d = (UInt128(d1) << bits) | d0;
    const UInt128 q = UInt128(v) * u2 + ((UInt128(u2) << bits) | u1);
    Limb quotient = static_cast<Limb>(q >> bits);
    const Limb r1 = u1 - quotient * d1;
    UInt128 r = ((UInt128(r1) << bits) | u0) - UInt128(d0) * quotient - d;
    ++quotient;
    if (static_cast<Limb>(r >> bits) >= static_cast<Limb>(q)) {
        --quotient;
        r += d;
    }
    if (r >= d) ++quotient;
    return quotient;
}

/// Long division in place: u of n + 1 limbs by d of m limbs, Knuth's algorithm D. The quotient has n + 1 - m limbs
/// (may be null); u's low m limbs become the remainder, its others zero.
/// Requires: n >= m >= 2; the top bit of d is set; u's top m limbs are below d (a spare zero limb on top sees to it).
constexpr void divide_normalised(Limb* quotient, Limb* u, std::size_t n, const Limb* d, std::size_t m) noexcept {
    const Limb d1 = d[m - 1];
    const Limb d0 = d[m - 2];
    const Limb v = reciprocal(d1, d0);
    for (std::size_t j = n + 1 - m; j-- != 0;) {
        Limb* window = u + j;  // m + 1 limbs
        // Where the leading limbs agree, the digit is 2^64 - 1 or less by one; otherwise two limbs of d and three of u
        // give the digit or one too many.
        Limb digit = window[m] == d1 && window[m - 1] == d0
                         ? ~Limb(0)
                         : divide_3_by_2(window[m], window[m - 1], window[m - 2], d1, d0, v);
        const Limb borrowed = subtract_multiple(window, d, m, digit);
        const bool too_many = window[m] < borrowed;
        window[m] -= borrowed;
        if (too_many) {
            --digit;
            window[m] += add(window, window, m, d, m);
        }
        if (quotient != nullptr) quotient[j] = digit;
    }
}

/// The inverse of an odd limb modulo 2^64. Newton's step doubles the number of correct bits, starting from five.
[[nodiscard]] constexpr Limb inverse_modulo_limb(Limb odd) noexcept {
    Limb x = (3 * odd) ^ 2;
    x *= 2 - odd * x;
    x *= 2 - odd * x;
    x *= 2 - odd * x;
    x *= 2 - odd * x;
    return x;
}

/// quotient = a / d where d divides a. Works from the low limbs, one product a digit and no correction.
/// Requires: d is odd and divides a; q = n - m + 1 or n - m limbs are wanted. a's low q limbs are destroyed.
/// `quotient` may be a.
constexpr void divide_exactly(Limb* quotient, Limb* a, std::size_t q, const Limb* d, std::size_t m) noexcept {
    const Limb inverse = inverse_modulo_limb(d[0]);
    for (std::size_t i = 0; i < q; ++i) {
        const Limb digit = a[i] * inverse;
        const std::size_t span = m < q - i ? m : q - i;  // what lies above the quotient cannot matter modulo 2^(64 q)
        Limb borrowed = subtract_multiple(a + i, d, span, digit);
        for (std::size_t k = i + span; borrowed != 0 && k < q; ++k) {
            const Limb before = a[k];
            a[k] = before - borrowed;
            borrowed = before < borrowed ? 1 : 0;
        }
        quotient[i] = digit;
    }
}

}  // namespace limbs

CLEAVE_END_NAMESPACE

#endif
