// SPDX-License-Identifier: Apache-2.0
/// `FixedInt<Bits>`: two's complement integers of a width fixed at compile time, on the stack, without branches.
///
/// Two ways to compute with them. As a ring (`+ - *`, one width), every result that does not fit throws, so a value is
/// always right. By the *mixed-width* functions below, every operand keeps its own width and the caller states the
/// width of the result; where a bound proves that the final value fits, intermediate wrap-around is harmless and
/// nothing is checked. The second is what predicates on small grids are made of.
#ifndef CLEAVE_NUMBER_FIXED_INT_HPP
#define CLEAVE_NUMBER_FIXED_INT_HPP

#include <cleave/base/error.hpp>
#include <cleave/number/basic_integer.hpp>
#include <cleave/number/sign.hpp>

#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

CLEAVE_BEGIN_NAMESPACE

/// An integer in [-2^(Bits-1), 2^(Bits-1)).
///
/// Ring operators throw NumberError where the result does not fit. Trivially copyable; usable in constant expressions.
/// At most 8192 bits; a product forms both operands' bits together, so the ring's * needs Bits <= 4096.
template <unsigned Bits>
class FixedInt {
    static_assert(Bits % limbs::bits == 0 && Bits >= limbs::bits && Bits <= 8192, "whole limbs, from 64 to 8192 bits");

public:
    static constexpr unsigned bits = Bits;
    static constexpr std::size_t limb_count = Bits / limbs::bits;
    using Limbs = std::array<Limb, limb_count>;

    /// Zero.
    constexpr FixedInt() noexcept = default;

    /// The value of a built-in integer. Throws: NumberError if it does not fit.
    template <BuiltinInteger T>
    constexpr FixedInt(T value) {  // implicit: the ring's own map from the integers
        const bool negative = value < T(0);
        const Limb fill = negative ? ~Limb(0) : 0;
        limbs_.fill(fill);
        limbs_[0] = static_cast<Limb>(value);
        bool fits = true;
        if constexpr (sizeof(T) > sizeof(Limb)) {
            const auto high = static_cast<Limb>(static_cast<UInt128>(value) >> limbs::bits);
            if constexpr (limb_count > 1)
                limbs_[1] = high;
            else
                fits = high == fill;
        }
        // An unsigned value may have set the sign bit.
        if (!fits || is_negative() != negative) throw_overflow();
    }

    /// The same value, wider.
    template <unsigned M>
    requires(M < Bits) constexpr FixedInt(const FixedInt<M>& x) noexcept {
        limbs_.fill(x.is_negative() ? ~Limb(0) : 0);
        for (std::size_t i = 0; i < FixedInt<M>::limb_count; ++i) limbs_[i] = x.limbs()[i];
    }

    /// The same value, narrower. Throws: NumberError if it does not fit.
    template <unsigned M>
    requires(M > Bits) explicit constexpr FixedInt(const FixedInt<M>& x) : FixedInt(wrap(x)) {
        if (!x.template fits<Bits>()) throw_overflow();
    }

    /// Throws: NumberError if the value does not fit.
    template <unsigned K>
    explicit FixedInt(const BasicInteger<K>& x) {
        const LimbView view = x.view();
        const std::size_t n = view.count();
        if (n > limb_count) throw_overflow();
        for (std::size_t i = 0; i < n; ++i) limbs_[i] = view.limbs[i];
        if (view.negative()) limbs::negate(limbs_.data(), limb_count);
        // A magnitude of 2^(Bits-1) or more leaves the wrong sign, save for -2^(Bits-1) itself.
        if (is_negative() != view.negative()) throw_overflow();
    }

    /// The value modulo 2^Bits: keeps the low limbs of a longer number, unchecked.
    template <unsigned M>
    [[nodiscard]] static constexpr FixedInt wrap(const FixedInt<M>& x) noexcept {
        FixedInt r;
        const Limb fill = x.is_negative() ? ~Limb(0) : 0;
        for (std::size_t i = 0; i < limb_count; ++i) r.limbs_[i] = i < FixedInt<M>::limb_count ? x.limbs()[i] : fill;
        return r;
    }

    /// From two's complement limbs, least first.
    [[nodiscard]] static constexpr FixedInt from_limbs(const Limbs& limbs) noexcept {
        FixedInt r;
        r.limbs_ = limbs;
        return r;
    }

    /// Decimal digits with an optional sign. Throws: NumberError if `text` is anything else or does not fit.
    [[nodiscard]] static FixedInt from_string(std::string_view text) {
        return FixedInt(BasicInteger<limb_count + 1>::from_string(text));
    }

    /// Two's complement limbs, least first.
    [[nodiscard]] constexpr const Limbs& limbs() const noexcept { return limbs_; }

    [[nodiscard]] constexpr bool is_negative() const noexcept {
        return (limbs_[limb_count - 1] >> (limbs::bits - 1)) != 0;
    }
    [[nodiscard]] constexpr bool is_zero() const noexcept {
        Limb any = 0;
        for (const Limb limb : limbs_) any |= limb;
        return any == 0;
    }
    [[nodiscard]] constexpr Sign sign() const noexcept {
        return is_negative() ? Sign::minus : (is_zero() ? Sign::zero : Sign::plus);
    }

    /// Whether the value is in the range of FixedInt<M>.
    template <unsigned M>
    [[nodiscard]] constexpr bool fits() const noexcept {
        constexpr std::size_t kept = FixedInt<M>::limb_count;
        if constexpr (kept < limb_count) {
            const Limb fill = (limbs_[kept - 1] >> (limbs::bits - 1)) != 0 ? ~Limb(0) : 0;
            Limb wrong = 0;
            for (std::size_t i = kept; i < limb_count; ++i) wrong |= limbs_[i] ^ fill;
            return wrong == 0;
        }
        return true;
    }

    /// The value with variable length.
    [[nodiscard]] BasicInteger<(limb_count < 2 ? 2U : limb_count)> to_integer() const {
        Limbs magnitude = limbs_;
        if (is_negative()) limbs::negate(magnitude.data(), limb_count);
        return BasicInteger<(limb_count < 2 ? 2U : limb_count)>::from_limbs(sign(), magnitude);
    }

    /// Decimal digits, with '-' in front of a negative number.
    [[nodiscard]] std::string to_string() const { return to_integer().to_string(); }

    constexpr FixedInt operator+() const noexcept { return *this; }
    constexpr FixedInt operator-() const {
        FixedInt r = *this;
        limbs::negate(r.limbs_.data(), limb_count);
        if (is_negative() && r.is_negative()) throw_overflow();  // only the least number is its own negative
        return r;
    }
    constexpr FixedInt& operator+=(const FixedInt& b) {
        const bool same_sign = is_negative() == b.is_negative();  // read first: b may be *this
        unsigned char carry = 0;
        for (std::size_t i = 0; i < limb_count; ++i) limbs_[i] = limbs::add_carry(limbs_[i], b.limbs_[i], carry);
        // Two negative operands always carry out of the top, two others never do: the carry is their common sign.
        if (same_sign && is_negative() != (carry != 0)) throw_overflow();
        return *this;
    }
    constexpr FixedInt& operator-=(const FixedInt& b) {
        const bool negative = is_negative();
        const bool b_negative = b.is_negative();
        unsigned char borrow = 0;
        for (std::size_t i = 0; i < limb_count; ++i) limbs_[i] = limbs::subtract_borrow(limbs_[i], b.limbs_[i], borrow);
        if (negative != b_negative && is_negative() != negative) throw_overflow();
        return *this;
    }
    constexpr FixedInt& operator*=(const FixedInt& b);

    friend constexpr FixedInt operator+(FixedInt a, const FixedInt& b) { return a += b; }
    friend constexpr FixedInt operator-(FixedInt a, const FixedInt& b) { return a -= b; }
    friend constexpr FixedInt operator*(FixedInt a, const FixedInt& b) { return a *= b; }

    friend constexpr bool operator==(const FixedInt& a, const FixedInt& b) noexcept { return a.limbs_ == b.limbs_; }
    friend constexpr std::strong_ordering operator<=>(const FixedInt& a, const FixedInt& b) noexcept {
        if (a.is_negative() != b.is_negative())
            return a.is_negative() ? std::strong_ordering::less : std::strong_ordering::greater;
        return limbs::compare(a.limbs_.data(), b.limbs_.data(), limb_count) <=> 0;
    }

    /// For the mixed-width functions.
    [[nodiscard]] constexpr Limb* data() noexcept { return limbs_.data(); }

private:
    [[noreturn]] static void throw_overflow() {
        throw NumberError("a result does not fit " + std::to_string(Bits) +
                          " bits: use a wider FixedInt, or Integer, which has no limit");
    }

    Limbs limbs_{};
};

/// a + b modulo 2^W. Exact if |a + b| < 2^(W-1); operands of any widths.
template <unsigned W, unsigned A, unsigned B>
[[nodiscard]] constexpr FixedInt<W> wrapping_sum(const FixedInt<A>& a, const FixedInt<B>& b) noexcept {
    FixedInt<W> r = FixedInt<W>::wrap(a);
    const FixedInt<W> addend = FixedInt<W>::wrap(b);
    unsigned char carry = 0;
    for (std::size_t i = 0; i < FixedInt<W>::limb_count; ++i)
        r.data()[i] = limbs::add_carry(r.limbs()[i], addend.limbs()[i], carry);
    return r;
}

/// a - b modulo 2^W. Exact if |a - b| < 2^(W-1); operands of any widths.
template <unsigned W, unsigned A, unsigned B>
[[nodiscard]] constexpr FixedInt<W> wrapping_difference(const FixedInt<A>& a, const FixedInt<B>& b) noexcept {
    FixedInt<W> r = FixedInt<W>::wrap(a);
    const FixedInt<W> subtrahend = FixedInt<W>::wrap(b);
    unsigned char borrow = 0;
    for (std::size_t i = 0; i < FixedInt<W>::limb_count; ++i)
        r.data()[i] = limbs::subtract_borrow(r.limbs()[i], subtrahend.limbs()[i], borrow);
    return r;
}

/// a * b modulo 2^W. Exact if |a * b| < 2^(W-1). Requires: W <= A + B.
/// Cost: a limb product for each pair of limbs that reaches below 2^W.
template <unsigned W, unsigned A, unsigned B>
[[nodiscard]] constexpr FixedInt<W> wrapping_product(const FixedInt<A>& a, const FixedInt<B>& b) noexcept {
    static_assert(W <= A + B, "a product of A and B bits needs no more than A + B");
    constexpr std::size_t w = FixedInt<W>::limb_count;
    constexpr std::size_t n = FixedInt<A>::limb_count;
    constexpr std::size_t m = FixedInt<B>::limb_count;
    FixedInt<W> r;
    Limb* out = r.data();
    const Limb* x = a.limbs().data();
    const Limb* y = b.limbs().data();
    if constexpr (n == 1 && m == 1) {
        const Int128 product = Int128(static_cast<std::int64_t>(x[0])) * static_cast<std::int64_t>(y[0]);
        out[0] = static_cast<Limb>(product);
        if constexpr (w > 1) out[1] = static_cast<Limb>(product >> limbs::bits);
        return r;
    } else {
        // As unsigned numbers first.
        for (std::size_t j = 0; j < m && j < w; ++j) {
            Limb carry = 0;
            for (std::size_t i = 0; i < n && i + j < w; ++i) {
                const UInt128 t = UInt128(x[i]) * y[j] + out[i + j] + carry;
                out[i + j] = static_cast<Limb>(t);
                carry = static_cast<Limb>(t >> limbs::bits);
            }
            if (n + j < w) out[n + j] = carry;
        }
        // A negative a was read as a + 2^A, which added b 2^A to the product; likewise b.
        const Limb a_mask = a.is_negative() ? ~Limb(0) : 0;
        const Limb b_mask = b.is_negative() ? ~Limb(0) : 0;
        unsigned char borrow = 0;
        for (std::size_t j = 0; j < m && n + j < w; ++j)
            out[n + j] = limbs::subtract_borrow(out[n + j], y[j] & a_mask, borrow);
        borrow = 0;
        for (std::size_t i = 0; i < n && m + i < w; ++i)
            out[m + i] = limbs::subtract_borrow(out[m + i], x[i] & b_mask, borrow);
        return r;
    }
}

/// The exact product, as wide as both operands together.
template <unsigned A, unsigned B>
[[nodiscard]] constexpr FixedInt<A + B> multiply(const FixedInt<A>& a, const FixedInt<B>& b) noexcept {
    return wrapping_product<A + B>(a, b);
}

/// The exact sum, one limb wider than the wider operand.
template <unsigned A, unsigned B>
[[nodiscard]] constexpr auto exact_sum(const FixedInt<A>& a, const FixedInt<B>& b) noexcept {
    return wrapping_sum<(A > B ? A : B) + limbs::bits>(a, b);
}

/// The exact difference, one limb wider than the wider operand.
template <unsigned A, unsigned B>
[[nodiscard]] constexpr auto exact_difference(const FixedInt<A>& a, const FixedInt<B>& b) noexcept {
    return wrapping_difference<(A > B ? A : B) + limbs::bits>(a, b);
}

/// The same value in W bits. Requires: W is at least the width of x.
template <unsigned W, unsigned A>
[[nodiscard]] constexpr FixedInt<W> widen(const FixedInt<A>& x) noexcept {
    static_assert(W >= A, "widening only; `wrap` and the checked constructor narrow");
    return FixedInt<W>::wrap(x);
}

template <unsigned Bits>
constexpr FixedInt<Bits>& FixedInt<Bits>::operator*=(const FixedInt& b) {
    return *this = FixedInt(multiply(*this, b));
}

/// |x|. Throws: NumberError for the least number, whose absolute value does not fit.
template <unsigned Bits>
[[nodiscard]] constexpr FixedInt<Bits> abs(const FixedInt<Bits>& x) {
    return x.is_negative() ? -x : x;
}

/// Decimal digits, with '-' in front of a negative number.
template <unsigned Bits>
[[nodiscard]] std::string to_string(const FixedInt<Bits>& x) {
    return x.to_string();
}

CLEAVE_END_NAMESPACE

template <unsigned Bits>
struct std::hash<cleave::FixedInt<Bits>> {
    [[nodiscard]] std::size_t operator()(const cleave::FixedInt<Bits>& x) const noexcept {
        return x.to_integer().hash();
    }
};

#endif
