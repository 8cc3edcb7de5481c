// SPDX-License-Identifier: Apache-2.0
/// Numbers by their residues modulo many primes, and which short fractions have given residues.
///
/// A fraction p/q is found again from its residue modulo M as a row of the Euclidean algorithm of M and the residue
/// [Wang-1981]: where 2 |p| q < M, p/q is a convergent. So where no row is short, no fraction is, and that is a proof.
#ifndef CLEAVE_QUERY_RESIDUE_SYSTEM_HPP
#define CLEAVE_QUERY_RESIDUE_SYSTEM_HPP

#include <cleave/base/contract.hpp>
#include <cleave/number/traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Arithmetic modulo a number 2^62 - c that is chosen at run time. Elements are in [0, modulus).
class PrimeField {
public:
    /// Requires: 0 < c < 2^16. `inverse` needs a prime modulus.
    explicit constexpr PrimeField(std::uint64_t c) : modulus_((std::uint64_t(1) << 62U) - c), c_(c) {}

    [[nodiscard]] constexpr std::uint64_t modulus() const noexcept { return modulus_; }

    [[nodiscard]] constexpr std::uint64_t add(std::uint64_t a, std::uint64_t b) const noexcept {
        const std::uint64_t s = a + b;
        return s >= modulus_ ? s - modulus_ : s;
    }
    [[nodiscard]] constexpr std::uint64_t negate(std::uint64_t a) const noexcept { return a == 0 ? 0 : modulus_ - a; }

    [[nodiscard]] constexpr std::uint64_t multiply(std::uint64_t a, std::uint64_t b) const noexcept {
        return reduce(UInt128(a) * b);
    }

    [[nodiscard]] constexpr std::uint64_t power(std::uint64_t a, std::uint64_t n) const noexcept {
        std::uint64_t result = 1;
        for (; n != 0; n >>= 1U) {
            if ((n & 1U) != 0) result = multiply(result, a);
            a = multiply(a, a);
        }
        return result;
    }

    /// By Fermat's little theorem. Requires: a prime modulus, a != 0.
    [[nodiscard]] constexpr std::uint64_t inverse(std::uint64_t a) const noexcept { return power(a, modulus_ - 2); }

    template <unsigned K>
    [[nodiscard]] std::uint64_t residue(const BasicInteger<K>& x) const noexcept {
        const LimbView view = x.view();
        std::uint64_t r = 0;
        for (std::size_t i = view.count(); i-- != 0;) r = reduce((UInt128(r) << 64U) | view.limbs[i]);
        return view.negative() ? negate(r) : r;
    }

    /// Whether the modulus is a prime: Miller and Rabin's test with the first twelve primes, which leaves no doubt
    /// below 3.18e23 [Sorenson-Webster-2017].
    [[nodiscard]] constexpr bool is_prime() const noexcept {
        if (modulus_ % 2 == 0) return false;
        std::uint64_t odd = modulus_ - 1;
        int twos = 0;
        for (; odd % 2 == 0; odd /= 2) ++twos;
        for (const std::uint64_t base : {2U, 3U, 5U, 7U, 11U, 13U, 17U, 19U, 23U, 29U, 31U, 37U}) {
            std::uint64_t x = power(base, odd);
            bool passes = x == 1 || x == modulus_ - 1;
            for (int i = 1; i < twos && !passes; ++i) {
                x = multiply(x, x);
                passes = x == modulus_ - 1;
            }
            if (!passes) return false;
        }
        return true;
    }

private:
    [[nodiscard]] constexpr std::uint64_t reduce(UInt128 x) const noexcept {
        // 2^62 = c: a fold takes away at least 46 bits until 62 or 63 are left.
        constexpr std::uint64_t low = (std::uint64_t(1) << 62U) - 1;
        while ((x >> 62U) != 0) x = (x & low) + (x >> 62U) * c_;
        const auto r = static_cast<std::uint64_t>(x);
        return r >= modulus_ ? r - modulus_ : r;
    }

    std::uint64_t modulus_;
    std::uint64_t c_;
};

/// Hands out the primes below 2^62, from the largest down.
class PrimeFields {
public:
    [[nodiscard]] PrimeField next() {
        do c_ += 2;
        while (!PrimeField(c_).is_prime());
        return PrimeField(c_);
    }

private:
    std::uint64_t c_ = static_cast<std::uint64_t>(-1);  // odd, wraps to 1
};

/// An integer known by its residues modulo more and more primes.
class ResidueSystem {
public:
    /// Adds the residue modulo a prime not given before.
    void add(const PrimeField& field, std::uint64_t residue) {
        // value + modulus * t is the residue, for t = (residue - value) / modulus.
        const std::uint64_t difference = field.add(residue, field.negate(field.residue(value_)));
        const std::uint64_t t = field.multiply(difference, field.inverse(field.residue(modulus_)));
        value_ += modulus_ * Integer(t);
        modulus_ *= Integer(field.modulus());
    }

    /// In [0, modulus()).
    [[nodiscard]] const Integer& value() const noexcept { return value_; }
    /// The product of the primes.
    [[nodiscard]] const Integer& modulus() const noexcept { return modulus_; }

    /// Whether there may be a fraction p/q in lowest terms with this residue and `accept(p, q)`, q > 0, |p| given
    /// without its sign. False is certain where `accept` is false for every p/q with 2 |p| q >= modulus().
    /// Cost: quadratic in the digits of the modulus.
    template <class Accept>
    [[nodiscard]] bool may_be_fraction(Accept&& accept) const {
        // Rows r = s modulus + t value; |t| ascends while r descends.
        Integer r0 = modulus_;
        Integer r1 = value_;
        Integer t0(0);
        Integer t1(1);
        for (;;) {
            if (accept(r1, abs(t1))) return true;
            if (r1.is_zero()) return false;
            IntegerDivision<Integer::inline_limbs> d = divide(r0, r1);
            sub_product(t0, d.quotient, t1);
            std::swap(t0, t1);
            r0 = std::move(r1);
            r1 = std::move(d.remainder);
        }
    }

private:
    Integer value_ = 0;
    Integer modulus_ = 1;
};

/// How many decimal digits |x| has; 1 for zero.
[[nodiscard]] inline std::size_t digit_count(const Integer& x) {
    if (x.is_zero()) return 1;
    // 2^(b-1) <= |x| < 2^b leaves one or two possibilities; log10(2) rounded down and up.
    const auto b = static_cast<double>(x.bit_length());
    const auto low = static_cast<std::size_t>(std::floor((b - 1) * 0.30102999566398114)) + 1;
    const auto high = static_cast<std::size_t>(std::floor(b * 0.30102999566398125)) + 1;
    return low == high ? low : abs(x).to_string().size();
}

/// The digits of a fraction written as p/q, or p where q is 1; signs do not count.
[[nodiscard]] inline std::size_t digit_count(const Integer& p, const Integer& q) {
    return digit_count(p) + (q.is_one() ? 0 : digit_count(q));
}

CLEAVE_END_NAMESPACE

#endif
