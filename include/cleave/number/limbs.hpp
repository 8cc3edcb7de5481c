// SPDX-License-Identifier: Apache-2.0
/// Routines on little-endian arrays of 64-bit limbs: addition, subtraction, products, shifts, comparison.
///
/// They know nothing of signs and own no memory; `BasicInteger` and `FixedInt` are built from them. An array is a
/// pointer and a count; "normalised" means that its top limb is not zero. Outputs may coincide with an input exactly
/// where the function says so, and never overlap one otherwise.
#ifndef CLEAVE_NUMBER_LIMBS_HPP
#define CLEAVE_NUMBER_LIMBS_HPP

#include <cleave/base/config.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// One digit of a long number, base 2^64.
using Limb = std::uint64_t;

// The only two places that name the compilers' 128-bit integers.
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// The built-in integers, 128-bit ones included (whether `std::integral` holds for those depends on the language mode).
template <class T>
concept BuiltinInteger = std::integral<T> || std::same_as<T, Int128> || std::same_as<T, UInt128>;

namespace limbs {

inline constexpr unsigned bits = 64;

/// a + b + carry. `carry` is 0 or 1 and becomes the carry out.
[[nodiscard]] constexpr Limb add_carry(Limb a, Limb b, unsigned char& carry) noexcept {
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
    if (!std::is_constant_evaluated()) {
        unsigned long long sum = 0;
        carry = __builtin_ia32_addcarryx_u64(carry, a, b, &sum);
        return sum;
    }
#endif
    const UInt128 sum = UInt128(a) + b + carry;
    carry = static_cast<unsigned char>(sum >> bits);
    return static_cast<Limb>(sum);
}

/// a - b - borrow. `borrow` is 0 or 1 and becomes the borrow out.
[[nodiscard]] constexpr Limb subtract_borrow(Limb a, Limb b, unsigned char& borrow) noexcept {
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
    if (!std::is_constant_evaluated()) {
        unsigned long long difference = 0;
#if defined(__clang__)
        borrow = __builtin_ia32_subborrow_u64(borrow, a, b, &difference);
#else
        borrow = __builtin_ia32_sbb_u64(borrow, a, b, &difference);
#endif
        return difference;
    }
#endif
    const UInt128 difference = UInt128(a) - b - borrow;
    borrow = static_cast<unsigned char>((difference >> bits) & 1);
    return static_cast<Limb>(difference);
}

/// The count without leading zero limbs.
[[nodiscard]] constexpr std::size_t normalised_size(const Limb* a, std::size_t n) noexcept {
    while (n != 0 && a[n - 1] == 0) --n;
    return n;
}

/// Bits of a normalised number; 0 for zero.
[[nodiscard]] constexpr std::size_t bit_length(const Limb* a, std::size_t n) noexcept {
    return n == 0 ? 0 : n * bits - static_cast<std::size_t>(std::countl_zero(a[n - 1]));
}

/// The number of low zero bits. Requires: not zero.
[[nodiscard]] constexpr std::size_t trailing_zeros(const Limb* a) noexcept {
    std::size_t i = 0;
    while (a[i] == 0) ++i;
    return i * bits + static_cast<std::size_t>(std::countr_zero(a[i]));
}

/// Copies n limbs upward, so `out` may lie below `a` in the same array.
constexpr void copy(Limb* out, const Limb* a, std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) out[i] = a[i];
}

/// -1, 0, 1 for two numbers of the same count.
[[nodiscard]] constexpr int compare(const Limb* a, const Limb* b, std::size_t n) noexcept {
    while (n-- != 0) {
        if (a[n] != b[n]) return a[n] < b[n] ? -1 : 1;
    }
    return 0;
}

/// -1, 0, 1 for two normalised numbers.
[[nodiscard]] constexpr int compare(const Limb* a, std::size_t n, const Limb* b, std::size_t m) noexcept {
    if (n != m) return n < m ? -1 : 1;
    return compare(a, b, n);
}

/// out = a + b over max(n, m) = n limbs. Requires: n >= m. `out` may be a or b. Returns: the carry out.
constexpr Limb add(Limb* out, const Limb* a, std::size_t n, const Limb* b, std::size_t m) noexcept {
    unsigned char carry = 0;
    std::size_t i = 0;
    for (; i < m; ++i) out[i] = add_carry(a[i], b[i], carry);
    for (; i < n && carry != 0; ++i) out[i] = add_carry(a[i], 0, carry);
    if (out != a) {
        for (; i < n; ++i) out[i] = a[i];
    }
    return carry;
}

/// out = a - b over n limbs. Requires: n >= m. `out` may be a or b. Returns: the borrow out, 0 iff a >= b.
constexpr Limb subtract(Limb* out, const Limb* a, std::size_t n, const Limb* b, std::size_t m) noexcept {
    unsigned char borrow = 0;
    std::size_t i = 0;
    for (; i < m; ++i) out[i] = subtract_borrow(a[i], b[i], borrow);
    for (; i < n && borrow != 0; ++i) out[i] = subtract_borrow(a[i], 0, borrow);
    if (out != a) {
        for (; i < n; ++i) out[i] = a[i];
    }
    return borrow;
}

/// Replaces a by 2^(64 n) - a.
constexpr void negate(Limb* a, std::size_t n) noexcept {
    unsigned char borrow = 0;
    for (std::size_t i = 0; i < n; ++i) a[i] = subtract_borrow(0, a[i], borrow);
}

/// out = a * b. `out` may be a. Returns: the limb carried out.
constexpr Limb multiply_by_limb(Limb* out, const Limb* a, std::size_t n, Limb b) noexcept {
    Limb carry = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const UInt128 t = UInt128(a[i]) * b + carry;
        out[i] = static_cast<Limb>(t);
        carry = static_cast<Limb>(t >> bits);
    }
    return carry;
}

/// out += a * b over n limbs. Returns: the limb carried out.
constexpr Limb add_multiple(Limb* out, const Limb* a, std::size_t n, Limb b) noexcept {
    Limb carry = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const UInt128 t = UInt128(a[i]) * b + out[i] + carry;  // at most (2^64-1)^2 + 2 (2^64-1) = 2^128 - 1
        out[i] = static_cast<Limb>(t);
        carry = static_cast<Limb>(t >> bits);
    }
    return carry;
}

/// out -= a * b over n limbs. Returns: the limb borrowed.
constexpr Limb subtract_multiple(Limb* out, const Limb* a, std::size_t n, Limb b) noexcept {
    Limb carry = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const UInt128 t = UInt128(a[i]) * b + carry;
        const Limb low = static_cast<Limb>(t);
        carry = static_cast<Limb>(t >> bits) + (out[i] < low ? 1 : 0);
        out[i] -= low;
    }
    return carry;
}

/// out = a * 2^shift, 0 < shift < 64, over n limbs from the top down, so `out` may be a or lie above it.
/// Returns: the bits shifted out.
constexpr Limb shift_left(Limb* out, const Limb* a, std::size_t n, unsigned shift) noexcept {
    if (n == 0) return 0;
    const unsigned rest = bits - shift;
    const Limb carried = a[n - 1] >> rest;
    for (std::size_t i = n - 1; i != 0; --i) out[i] = (a[i] << shift) | (a[i - 1] >> rest);
    out[0] = a[0] << shift;
    return carried;
}

/// out = floor(a / 2^shift), 0 < shift < 64, over n limbs from the bottom up, so `out` may be a or lie below it.
constexpr void shift_right(Limb* out, const Limb* a, std::size_t n, unsigned shift) noexcept {
    if (n == 0) return;
    const unsigned rest = bits - shift;
    for (std::size_t i = 0; i + 1 < n; ++i) out[i] = (a[i] >> shift) | (a[i + 1] << rest);
    out[n - 1] = a[n - 1] >> shift;
}

/// The residue modulo 2^61 - 1, in [0, 2^61 - 1).
[[nodiscard]] constexpr std::uint64_t modulo_61(const Limb* a, std::size_t n) noexcept {
    constexpr std::uint64_t p = (std::uint64_t(1) << 61) - 1;
    std::uint64_t r = 0;
    while (n-- != 0) {
        // r 2^64 + a = 8 r + a modulo p, and 8 r + a < 2^65: its two 61-bit digits add up to less than p + 16.
        const UInt128 t = (UInt128(r) << 3) + a[n];
        r = (static_cast<std::uint64_t>(t) & p) + static_cast<std::uint64_t>(t >> 61);
        if (r >= p) r -= p;
    }
    return r;
}

}  // namespace limbs

CLEAVE_END_NAMESPACE

#endif
