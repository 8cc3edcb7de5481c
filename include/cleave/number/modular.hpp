// SPDX-License-Identifier: Apache-2.0
/// Arithmetic modulo a prime of 61 or 62 bits: cheap witnesses of exact equality, hashes of rational values.
///
/// Two exact values that differ have different residues for all but a few primes, so a residue is a hash whose
/// operations commute with the ring's. Equal residues prove nothing: an exact comparison has the last word.
#ifndef CLEAVE_NUMBER_MODULAR_HPP
#define CLEAVE_NUMBER_MODULAR_HPP

#include <cleave/base/error.hpp>
#include <cleave/number/basic_integer.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The Mersenne prime 2^61 - 1: the library's first prime.
inline constexpr std::uint64_t first_prime = (std::uint64_t(1) << 61) - 1;

/// 2^62 - 57, the largest prime below 2^62: for values whose denominator vanishes modulo the first.
inline constexpr std::uint64_t second_prime = (std::uint64_t(1) << 62) - 57;

/// An element of the field of integers modulo P.
/// Requires: P is a prime 2^k - c with k <= 62 and c < 2^16, so that reduction is a fold of the high bits times c.
template <std::uint64_t P>
class Modular {
    static constexpr int k = std::bit_width(P);
    static constexpr std::uint64_t c = (std::uint64_t(1) << k) - P;
    static_assert(k >= 32 && k <= 62 && c < (1U << 16), "reduction folds the bits from k up, times a small c");

public:
    static constexpr std::uint64_t modulus = P;

    /// Zero.
    constexpr Modular() noexcept = default;

    /// The residue of a built-in integer, negative ones included.
    template <BuiltinInteger T>
    constexpr Modular(T value) noexcept {  // implicit: the ring's own map from the integers
        if (value < T(0))
            value_ = negated(reduce(UInt128(0) - static_cast<UInt128>(value)));
        else
            value_ = reduce(static_cast<UInt128>(value));
    }

    /// The residue of an integer of any size. Cost: one step a limb.
    template <unsigned K>
    explicit Modular(const BasicInteger<K>& x) noexcept {
        std::uint64_t r = 0;
        const LimbView view = x.view();
        for (std::size_t i = view.count(); i-- != 0;) r = reduce((UInt128(r) << limbs::bits) | view.limbs[i]);
        value_ = view.negative() ? negated(r) : r;
    }

    /// The representative in [0, P).
    [[nodiscard]] constexpr std::uint64_t value() const noexcept { return value_; }
    [[nodiscard]] constexpr bool is_zero() const noexcept { return value_ == 0; }

    constexpr Modular operator-() const noexcept { return raw(negated(value_)); }
    constexpr Modular operator+() const noexcept { return *this; }

    constexpr Modular& operator+=(Modular b) noexcept {
        value_ += b.value_;
        if (value_ >= P) value_ -= P;
        return *this;
    }
    constexpr Modular& operator-=(Modular b) noexcept {
        value_ = value_ >= b.value_ ? value_ - b.value_ : value_ + (P - b.value_);
        return *this;
    }
    constexpr Modular& operator*=(Modular b) noexcept {
        value_ = reduce_product(UInt128(value_) * b.value_);
        return *this;
    }
    /// Throws: NumberError if b is zero.
    constexpr Modular& operator/=(Modular b) { return *this *= b.inverse(); }

    friend constexpr Modular operator+(Modular a, Modular b) noexcept { return a += b; }
    friend constexpr Modular operator-(Modular a, Modular b) noexcept { return a -= b; }
    friend constexpr Modular operator*(Modular a, Modular b) noexcept { return a *= b; }
    friend constexpr Modular operator/(Modular a, Modular b) { return a /= b; }
    friend constexpr bool operator==(Modular a, Modular b) noexcept = default;

    /// This to the n-th power; the zeroth power is one. Cost: 14 products and five for every four bits of n.
    [[nodiscard]] constexpr Modular power(std::uint64_t n) const noexcept {
        Modular powers[16];
        powers[0] = raw(1);
        for (int i = 1; i < 16; ++i) powers[i] = powers[i - 1] * *this;
        const int top = n == 0 ? 0 : (static_cast<int>(std::bit_width(n)) - 1) / 4 * 4;
        Modular result = powers[n >> top];
        for (int shift = top - 4; shift >= 0; shift -= 4) {
            for (int i = 0; i < 4; ++i) result *= result;
            result *= powers[(n >> shift) & 15];
        }
        return result;
    }

    /// The multiplicative inverse, by Fermat's little theorem. Throws: NumberError for zero.
    /// Cost: about 90 products; a shift for powers of two and their negatives modulo 2^61-1, which is what the weights
    /// of points on axis-parallel planes at doubles are. See `invert_all` for many at once.
    [[nodiscard]] constexpr Modular inverse() const {
        if (is_zero()) throw NumberError("zero has no inverse modulo a prime");
        if constexpr (c == 1) {
            // 2^k = 1, so the inverse of 2^i is 2^(k-i).
            if (std::has_single_bit(value_)) return raw(inverse_of_bit(value_));
            if (std::has_single_bit(P - value_)) return raw(P - inverse_of_bit(P - value_));
        }
        return power(P - 2);
    }

private:
    static constexpr Modular raw(std::uint64_t value) noexcept {
        Modular r;
        r.value_ = value;
        return r;
    }

    static constexpr std::uint64_t negated(std::uint64_t value) noexcept { return value == 0 ? 0 : P - value; }

    static constexpr std::uint64_t inverse_of_bit(std::uint64_t bit) noexcept {
        const int i = std::countr_zero(bit);
        return i == 0 ? 1 : std::uint64_t(1) << (k - i);
    }

    /// x modulo P. Requires: x <= (P - 1)^2. For c = 1 both halves are at most P, so one fold and one subtraction do.
    static constexpr std::uint64_t reduce_product(UInt128 x) noexcept {
        if constexpr (c == 1) {
            const std::uint64_t r = (static_cast<std::uint64_t>(x) & P) + static_cast<std::uint64_t>(x >> k);
            return r >= P ? r - P : r;
        } else {
            return reduce(x);
        }
    }

    static constexpr std::uint64_t reduce(UInt128 x) noexcept {
        // 2^k = c modulo P. From 128 bits the folds leave at most 128 - k + 16 <= 112, then 96, then at most k + 1
        // bits; products start below 2^(2k) and are done after two.
        constexpr std::uint64_t mask = (std::uint64_t(1) << k) - 1;
        while ((x >> k) != 0) x = (x & mask) + (x >> k) * c;
        const auto r = static_cast<std::uint64_t>(x);
        return r >= P ? r - P : r;
    }

    std::uint64_t value_ = 0;
};

/// Residues modulo 2^61 - 1.
using Mod61 = Modular<first_prime>;

/// Residues modulo 2^62 - 57.
using Mod62 = Modular<second_prime>;

/// Replaces every element by its inverse and leaves zeros zero. Cost: three products an element and one inversion.
/// Source: P. L. Montgomery, "Speeding the Pollard and elliptic curve methods of factorization", Math. Comp. 48 (1987).
template <std::uint64_t P>
void invert_all(std::span<Modular<P>> elements) {
    std::vector<Modular<P>> before;  // before[i]: the product of the non-zero elements in front of i
    before.reserve(elements.size());
    Modular<P> product(1);
    for (const Modular<P>& x : elements) {
        before.push_back(product);
        if (!x.is_zero()) product *= x;
    }
    Modular<P> rest = product.inverse();
    for (std::size_t i = elements.size(); i-- != 0;) {
        if (elements[i].is_zero()) continue;
        const Modular<P> inverse = rest * before[i];
        rest *= elements[i];
        elements[i] = inverse;
    }
}

CLEAVE_END_NAMESPACE

template <std::uint64_t P>
struct std::hash<cleave::Modular<P>> {
    [[nodiscard]] std::size_t operator()(cleave::Modular<P> x) const noexcept {
        return static_cast<std::size_t>(x.value() * 0x9e3779b97f4a7c15U);
    }
};

#endif
