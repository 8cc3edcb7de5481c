// SPDX-License-Identifier: Apache-2.0
/// `BasicInteger`: integers of any size, exact always, allocation-free while they fit inside the object.
///
/// The engine's predicates are polynomials in integers of a few limbs. Sign-magnitude limbs of variable count cost what
/// the value needs, not what the type could hold: small values in a type with room for large ones stay cheap.
#ifndef CLEAVE_NUMBER_BASIC_INTEGER_HPP
#define CLEAVE_NUMBER_BASIC_INTEGER_HPP

#include <cleave/number/integer_arithmetic.hpp>
#include <cleave/number/limbs_text.hpp>
#include <cleave/number/sign.hpp>

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// An integer of any size. Up to `InlineLimbs` 64-bit limbs live inside the object, more on the heap.
///
/// Ring: + - * and unary minus, == and <=>, construction from built-in integers. There is no operator/ because a ring
/// has none: see `divide` and `exact_divide`. Operations on two inline sizes give the larger one. Equal values are
/// equal, whatever their inline sizes. A moved-from integer is zero. Distinct objects may be used from different
/// threads, and one const object from many.
template <unsigned InlineLimbs>
class BasicInteger {
public:
    static constexpr unsigned inline_limbs = InlineLimbs;

    /// Zero.
    BasicInteger() noexcept = default;

    /// The value of a built-in integer.
    template <BuiltinInteger T>
    BasicInteger(T value) noexcept {  // implicit: every such value is an integer
        using Magnitude = std::conditional_t<(sizeof(T) > sizeof(Limb)), UInt128, Limb>;
        const bool negative = value < T(0);
        auto magnitude = static_cast<Magnitude>(value);
        if (negative) magnitude = Magnitude(0) - magnitude;
        set(magnitude, negative);
    }

    /// The same value with another inline size; implicit where it cannot allocate more than its source did.
    template <unsigned M>
    requires(M != InlineLimbs) explicit(M > InlineLimbs) BasicInteger(const BasicInteger<M>& other)
        : limbs_(other.view()) {}

    template <unsigned M>
    requires(M != InlineLimbs) BasicInteger& operator=(const BasicInteger<M>& other) {
        limbs_.assign(other.view());
        return *this;
    }

    /// mantissa * 2^shift.
    [[nodiscard]] static BasicInteger scaled(std::int64_t mantissa, std::size_t shift) {
        BasicInteger r(mantissa);
        r <<= shift;
        return r;
    }

    /// The number with this magnitude (little-endian, leading zeros allowed), negative where `sign` is minus.
    /// Requires: the magnitude is zero iff `sign` is (a zero magnitude gives zero in any case).
    [[nodiscard]] static BasicInteger from_limbs(Sign sign, std::span<const Limb> magnitude) {
        const std::size_t n = limbs::normalised_size(magnitude.data(), magnitude.size());
        CLEAVE_REQUIRES(n == 0 || sign != Sign::zero);
        BasicInteger r;
        r.limbs_.reserve(n, 0);
        limbs::copy(r.limbs_.data(), magnitude.data(), n);
        r.limbs_.set_size(n, sign == Sign::minus);
        return r;
    }

    /// Decimal digits with an optional sign in front. Throws: NumberError if `text` is anything else.
    [[nodiscard]] static BasicInteger from_string(std::string_view text) {
        std::string_view digits = text;
        const bool negative = digits.starts_with('-');
        if (negative || digits.starts_with('+')) digits.remove_prefix(1);
        std::vector<Limb> magnitude;
        if (!limbs::from_decimal(digits, magnitude))
            throw NumberError("not a decimal integer: '" + std::string(text.substr(0, 80)) + "'");
        return from_limbs(magnitude.empty() ? Sign::zero : (negative ? Sign::minus : Sign::plus), magnitude);
    }

    /// Decimal digits, with '-' in front of a negative number. Cost: quadratic, about 15 ms for 100,000 digits.
    [[nodiscard]] std::string to_string() const {
        std::string digits = limbs::to_decimal(limbs_.data(), limbs_.count());
        return limbs_.signed_size() < 0 ? "-" + digits : digits;
    }

    [[nodiscard]] Sign sign() const noexcept { return sign_of_value(limbs_.signed_size()); }
    [[nodiscard]] bool is_zero() const noexcept { return limbs_.signed_size() == 0; }
    [[nodiscard]] bool is_odd() const noexcept { return !is_zero() && (limbs_.data()[0] & 1) != 0; }
    [[nodiscard]] bool is_one() const noexcept { return limbs_.signed_size() == 1 && limbs_.data()[0] == 1; }

    /// The least n with |x| < 2^n.
    [[nodiscard]] std::size_t bit_length() const noexcept { return limbs::bit_length(limbs_.data(), limbs_.count()); }

    /// The largest n with 2^n dividing x; 0 for zero.
    [[nodiscard]] std::size_t trailing_zeros() const noexcept {
        return is_zero() ? 0 : limbs::trailing_zeros(limbs_.data());
    }

    /// The magnitude, little-endian, without leading zeros. Valid until the number changes.
    [[nodiscard]] std::span<const Limb> limbs() const noexcept { return {limbs_.data(), limbs_.count()}; }

    /// Sign and magnitude together, for the routines of `integer_arithmetic.hpp`.
    [[nodiscard]] LimbView view() const noexcept { return limbs_.view(); }

    [[nodiscard]] bool fits_int64() const noexcept {
        if (limbs_.count() > 1) return false;
        return is_zero() || limbs_.data()[0] <= (Limb(1) << 63) - (limbs_.signed_size() > 0 ? 1 : 0);
    }

    /// Requires: fits_int64().
    [[nodiscard]] std::int64_t to_int64() const {
        CLEAVE_REQUIRES(fits_int64());
        if (is_zero()) return 0;
        const Limb magnitude = limbs_.data()[0];
        return static_cast<std::int64_t>(limbs_.signed_size() < 0 ? Limb(0) - magnitude : magnitude);
    }

    /// The residue modulo 2^61 - 1, in [0, 2^61 - 1).
    [[nodiscard]] std::uint64_t modulo_61() const noexcept {
        const std::uint64_t r = limbs::modulo_61(limbs_.data(), limbs_.count());
        return limbs_.signed_size() < 0 && r != 0 ? ((std::uint64_t(1) << 61) - 1) - r : r;
    }

    /// A hash of the value: the same for every inline size, run and machine.
    [[nodiscard]] std::size_t hash() const noexcept {
        std::uint64_t h = static_cast<std::uint64_t>(limbs_.signed_size()) * 0x9e3779b97f4a7c15U;
        for (const Limb limb : limbs()) {
            h = (h ^ limb) * 0xd6e8feb86659fd93U;
            h ^= h >> 32;
        }
        return static_cast<std::size_t>(h);
    }

    /// Changes the sign in place.
    void negate() noexcept { limbs_.flip_sign(); }

    BasicInteger operator-() const& {
        BasicInteger r(*this);
        r.negate();
        return r;
    }
    BasicInteger operator-() && noexcept {
        negate();
        return std::move(*this);
    }
    BasicInteger operator+() const { return *this; }

    template <unsigned M>
    BasicInteger& operator+=(const BasicInteger<M>& b) {
        arithmetic::assign_sum(limbs_, view(), b.view());
        return *this;
    }
    template <unsigned M>
    BasicInteger& operator-=(const BasicInteger<M>& b) {
        arithmetic::assign_sum(limbs_, view(), b.view().negated());
        return *this;
    }
    template <unsigned M>
    BasicInteger& operator*=(const BasicInteger<M>& b) {
        arithmetic::assign_product(limbs_, view(), b.view());
        return *this;
    }
    template <BuiltinInteger T>
    BasicInteger& operator+=(T b) {
        return *this += BasicInteger(b);
    }
    template <BuiltinInteger T>
    BasicInteger& operator-=(T b) {
        return *this -= BasicInteger(b);
    }
    template <BuiltinInteger T>
    BasicInteger& operator*=(T b) {
        return *this *= BasicInteger(b);
    }
    BasicInteger& operator<<=(std::size_t shift) {
        arithmetic::assign_shifted_left(limbs_, view(), shift);
        return *this;
    }
    /// Divides by 2^shift and truncates toward zero.
    BasicInteger& operator>>=(std::size_t shift) {
        arithmetic::assign_shifted_right(limbs_, view(), shift);
        return *this;
    }

    friend BasicInteger operator+(const BasicInteger& a, const BasicInteger& b) {
        BasicInteger r;
        arithmetic::assign_sum(r.limbs_, a.view(), b.view());
        return r;
    }
    friend BasicInteger operator-(const BasicInteger& a, const BasicInteger& b) {
        BasicInteger r;
        arithmetic::assign_sum(r.limbs_, a.view(), b.view().negated());
        return r;
    }
    friend BasicInteger operator*(const BasicInteger& a, const BasicInteger& b) {
        BasicInteger r;
        arithmetic::assign_product(r.limbs_, a.view(), b.view());
        return r;
    }
    friend BasicInteger operator<<(const BasicInteger& a, std::size_t shift) {
        BasicInteger r;
        arithmetic::assign_shifted_left(r.limbs_, a.view(), shift);
        return r;
    }
    /// a / 2^shift truncated toward zero (so (-1) >> 1 is 0, unlike a built-in's -1).
    friend BasicInteger operator>>(const BasicInteger& a, std::size_t shift) {
        BasicInteger r;
        arithmetic::assign_shifted_right(r.limbs_, a.view(), shift);
        return r;
    }
    friend bool operator==(const BasicInteger& a, const BasicInteger& b) noexcept {
        return arithmetic::equal(a.view(), b.view());
    }
    friend std::strong_ordering operator<=>(const BasicInteger& a, const BasicInteger& b) noexcept {
        return arithmetic::compare(a.view(), b.view());
    }

    /// For the free functions that fill a number in place.
    [[nodiscard]] LimbBuffer<InlineLimbs>& buffer() noexcept { return limbs_; }

private:
    void set(Limb magnitude, bool negative) noexcept {
        limbs_.data()[0] = magnitude;
        limbs_.set_size(magnitude == 0 ? 0 : 1, negative);
    }
    void set(UInt128 magnitude, bool negative) noexcept {
        limbs_.data()[0] = static_cast<Limb>(magnitude);
        limbs_.data()[1] = static_cast<Limb>(magnitude >> limbs::bits);
        limbs_.set_size_normalised(2, negative);
    }

    LimbBuffer<InlineLimbs> limbs_;
};

/// Stored integers: plane coefficients, homogeneous coordinates. 56 bytes, no allocation up to 384 bits.
using Integer = BasicInteger<6>;

/// Temporaries of exact predicates: no allocation up to 1536 bits.
using WideInteger = BasicInteger<24>;

/// The inline size of a result of operands with K and M inline limbs.
template <unsigned K, unsigned M>
using WiderInteger = BasicInteger<(K > M ? K : M)>;

template <unsigned K, unsigned M>
requires(K != M) WiderInteger<K, M>
operator+(const BasicInteger<K>& a, const BasicInteger<M>& b) {
    WiderInteger<K, M> r;
    arithmetic::assign_sum(r.buffer(), a.view(), b.view());
    return r;
}

template <unsigned K, unsigned M>
requires(K != M) WiderInteger<K, M>
operator-(const BasicInteger<K>& a, const BasicInteger<M>& b) {
    WiderInteger<K, M> r;
    arithmetic::assign_sum(r.buffer(), a.view(), b.view().negated());
    return r;
}

template <unsigned K, unsigned M>
requires(K != M) WiderInteger<K, M>
operator*(const BasicInteger<K>& a, const BasicInteger<M>& b) {
    WiderInteger<K, M> r;
    arithmetic::assign_product(r.buffer(), a.view(), b.view());
    return r;
}

template <unsigned K, unsigned M>
requires(K != M) bool operator==(const BasicInteger<K>& a, const BasicInteger<M>& b) noexcept {
    return arithmetic::equal(a.view(), b.view());
}

template <unsigned K, unsigned M>
requires(K != M) std::strong_ordering operator<=>(const BasicInteger<K>& a, const BasicInteger<M>& b) noexcept {
    return arithmetic::compare(a.view(), b.view());
}

CLEAVE_END_NAMESPACE

template <unsigned K>
struct std::hash<cleave::BasicInteger<K>> {
    [[nodiscard]] std::size_t operator()(const cleave::BasicInteger<K>& x) const noexcept { return x.hash(); }
};

#endif
