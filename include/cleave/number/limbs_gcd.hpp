// SPDX-License-Identifier: Apache-2.0
/// The greatest common divisor of limb arrays, binary and batched.
///
/// The binary algorithm's decisions for 31 halvings depend on the low 31 bits and, nearly always, on the leading 33
/// bits of two odd numbers. They are made on one limb each, without branches, and collected in a 2 x 2 matrix that is
/// then applied to the long numbers. A wrong decision (from leading bits that did not suffice) costs time but not
/// truth: the matrix has an odd determinant up to powers of two, so common odd divisors stay common divisors, and no
/// others arise. Source: T. Pornin, "Optimized binary GCD for modular inversion", Cryptology ePrint 2020/972, algorithm
/// 2, which also bounds the number of batches; here runs of zeros are taken at once.
#ifndef CLEAVE_NUMBER_LIMBS_GCD_HPP
#define CLEAVE_NUMBER_LIMBS_GCD_HPP

#include <cleave/number/limbs.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

namespace limbs {

/// The gcd of a number and an odd number.
[[nodiscard]] constexpr Limb gcd_odd(Limb a, Limb b) noexcept {
    if (a == 0) return b;
    a >>= std::countr_zero(a);
    while (a != b) {
        // (a, b) becomes (|a - b| without its twos, min(a, b)); the selection is arithmetic, the branch would be noise.
        const Limb difference = a - b;
        const Limb less = Limb(0) - Limb(a < b ? 1 : 0);
        b += difference & less;
        a = ((difference ^ less) - less) >> std::countr_zero(difference);
    }
    return b;
}

/// The gcd of two limbs; gcd(0, 0) = 0.
[[nodiscard]] constexpr Limb gcd(Limb a, Limb b) noexcept {
    if (a == 0 || b == 0) return a | b;
    const int twos = std::countr_zero(a | b);
    return gcd_odd(a, b >> std::countr_zero(b)) << twos;
}

/// Decisions of up to 31 halvings: a' = (f0 a + g0 b) / 2^31, b' = (f1 a + g1 b) / 2^31, up to signs.
struct GcdBatch {
    std::int64_t f0, g0, f1, g1;
};

/// Runs one batch on approximations: their low 31 bits are those of the numbers, their high 33 bits the leading ones of
/// both at the same position. Requires: b is odd.
[[nodiscard]] constexpr GcdBatch gcd_batch(Limb a, Limb b) noexcept {
    // Both entries of a row in one limb, f + g 2^32: sums and shifts act on both at once. |f| + |g| <= 2^31 for each
    // row, and no entry is -2^31, as the other row would then have to be parallel.
    Limb row0 = 1;
    Limb row1 = Limb(1) << 32;
    unsigned left = 31;
    auto twos = static_cast<unsigned>(std::countr_zero(a | (Limb(1) << left)));
    for (;;) {
        a >>= twos;
        row1 <<= twos;
        left -= twos;
        if (left == 0) break;
        const Limb difference = a - b;
        const Limb row_difference = row0 - row1;
        const Limb less = Limb(0) - Limb(a < b ? 1 : 0);
        twos = static_cast<unsigned>(std::countr_zero(difference | (Limb(1) << left)));  // need not wait for the sign
        b += difference & less;
        a = (difference ^ less) - less;
        row1 += row_difference & less;
        row0 = (row_difference ^ less) - less;
    }
    const auto low = [](Limb row) {
        constexpr std::int64_t bias = 0x7fff'ffff;
        return std::int64_t((row + Limb(bias)) & 0xffff'ffffU) - bias;
    };
    const auto high = [&](Limb row) { return static_cast<std::int64_t>(row - static_cast<Limb>(low(row))) >> 32; };
    return {low(row0), high(row0), low(row1), high(row1)};
}

/// |f a + g b| / 2^31 in `out`, over n limbs; `out` may be a or b only if the other is kept elsewhere.
/// Applies both rows in one pass, in place. Requires: both sums are multiples of 2^31.
constexpr void apply_gcd_batch(Limb* a, Limb* b, std::size_t n, const GcdBatch& m) noexcept {
    Int128 sum0 = 0;
    Int128 sum1 = 0;
    Limb previous0 = 0;
    Limb previous1 = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Int128 x = static_cast<Int128>(a[i]);
        const Int128 y = static_cast<Int128>(b[i]);
        sum0 += m.f0 * x + m.g0 * y;
        sum1 += m.f1 * x + m.g1 * y;
        const auto limb0 = static_cast<Limb>(sum0);
        const auto limb1 = static_cast<Limb>(sum1);
        if (i != 0) {
            a[i - 1] = (previous0 >> 31) | (limb0 << 33);
            b[i - 1] = (previous1 >> 31) | (limb1 << 33);
        }
        previous0 = limb0;
        previous1 = limb1;
        sum0 >>= bits;
        sum1 >>= bits;
    }
    const auto top0 = static_cast<Limb>(sum0);
    const auto top1 = static_cast<Limb>(sum1);
    a[n - 1] = (previous0 >> 31) | (top0 << 33);
    b[n - 1] = (previous1 >> 31) | (top1 << 33);
    // Signs are coin tosses, so no branch: x becomes (x xor s) - s for s = 0 or -1.
    const Limb sign0 = Limb(0) - (top0 >> (bits - 1));
    const Limb sign1 = Limb(0) - (top1 >> (bits - 1));
    unsigned char borrow0 = 0;
    unsigned char borrow1 = 0;
    for (std::size_t i = 0; i < n; ++i) {
        a[i] = subtract_borrow(a[i] ^ sign0, sign0, borrow0);
        b[i] = subtract_borrow(b[i] ^ sign1, sign1, borrow1);
    }
}

/// The gcd of two long numbers, in place. Requires: n >= 1; b is odd; both have n limbs, leading zeros allowed.
/// Returns: the number of limbs of the gcd, which is left in b. Cost: 2 n batches of n limbs.
constexpr std::size_t gcd_odd(Limb* a, Limb* b, std::size_t n) noexcept {
    for (;;) {
        while (n > 1 && (a[n - 1] | b[n - 1]) == 0) --n;
        if (n == 1) {
            b[0] = gcd_odd(a[0], b[0]);
            return 1;
        }
        // The leading 64 bits at the position of the longer one's leading bit.
        const auto shift = static_cast<unsigned>(std::countl_zero(a[n - 1] | b[n - 1]));
        const auto leading = [&](const Limb* x) {
            return shift == 0 ? x[n - 1] : (x[n - 1] << shift) | (x[n - 2] >> (bits - shift));
        };
        constexpr Limb low = (Limb(1) << 31) - 1;
        const Limb head_a = leading(a);
        if (head_a == 0 && normalised_size(a, n) == 0) return normalised_size(b, n);
        apply_gcd_batch(a, b, n, gcd_batch((head_a & ~low) | (a[0] & low), (leading(b) & ~low) | (b[0] & low)));
    }
}

}  // namespace limbs

CLEAVE_END_NAMESPACE

#endif
