// SPDX-License-Identifier: Apache-2.0
/// `FixedDigits<Bits>`: signed integers of a fixed width in base 2^60, for sums of products without carries.
///
/// Two's complement limbs of 64 bits leave no room: every partial product needs a carry chain, and signs need
/// corrections. Digits of 60 bits in 64-bit words do. A product of two digits is below 2^120, so 128 of them add up in
/// one signed 128-bit accumulator, signs included, and one shift a digit finishes the whole sum. On predicates, which
/// are sums of products of bounded numbers, this is about twice as fast as full limbs although it has a few more
/// digits. (The idea is that of reduced-radix field arithmetic: D. J. Bernstein, "Curve25519", PKC 2006.)
#ifndef CLEAVE_NUMBER_FIXED_DIGITS_HPP
#define CLEAVE_NUMBER_FIXED_DIGITS_HPP

#include <cleave/base/error.hpp>
#include <cleave/number/fixed_int.hpp>
#include <cleave/number/sign.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// An integer x with |x| < 2^Bits. Its digits are in [0, 2^60), except the top one, which carries the sign.
template <unsigned Bits>
class FixedDigits {
    static_assert(Bits >= 1);

public:
    static constexpr unsigned radix_bits = 60;
    static constexpr unsigned bits = Bits;
    static constexpr std::size_t digit_count = (Bits + radix_bits - 1) / radix_bits;
    using Digits = std::array<std::int64_t, digit_count>;
    /// Two's complement of whole limbs that holds every value.
    using Fixed = FixedInt<(Bits + 1 + limbs::bits - 1) / limbs::bits * limbs::bits>;

    /// Zero.
    constexpr FixedDigits() noexcept = default;

    /// Throws: NumberError if |x| is 2^Bits or more.
    template <unsigned M>
    explicit constexpr FixedDigits(const FixedInt<M>& x) {
        if (!is_within(x))
            throw NumberError("a number does not fit the " + std::to_string(Bits) + " bits planned for it");
        for (std::size_t i = 0; i < digit_count; ++i) {
            const Limb digit = bits_from(x, i * radix_bits);
            digits_[i] = static_cast<std::int64_t>(i + 1 < digit_count ? digit & mask : digit);
        }
    }

    /// Throws: NumberError if |x| is 2^Bits or more.
    template <unsigned K>
    explicit FixedDigits(const BasicInteger<K>& x) : FixedDigits(Fixed(x)) {}

    /// From digits as described above, unchecked.
    [[nodiscard]] static constexpr FixedDigits from_digits(const Digits& digits) noexcept {
        FixedDigits r;
        r.digits_ = digits;
        return r;
    }

    [[nodiscard]] constexpr const Digits& digits() const noexcept { return digits_; }

    /// The digits below the top are not negative and weigh less than one in the top digit, which therefore has the sign
    /// unless it is zero.
    [[nodiscard]] constexpr Sign sign() const noexcept {
        const std::int64_t top = digits_[digit_count - 1];
        if (top < 0) return Sign::minus;
        std::int64_t any = top;
        for (std::size_t i = 0; i + 1 < digit_count; ++i) any |= digits_[i];
        return any == 0 ? Sign::zero : Sign::plus;
    }

    [[nodiscard]] constexpr Fixed to_fixed() const noexcept {
        Fixed r;
        for (std::size_t i = digit_count; i-- != 0;) {
            // r = r 2^60 + digit; the top digit comes first and is extended by its sign.
            const FixedInt<limbs::bits> digit(digits_[i]);
            Limb* out = r.data();
            for (std::size_t k = Fixed::limb_count; k-- != 0;)
                out[k] = (out[k] << radix_bits) | (k == 0 ? 0 : out[k - 1] >> (limbs::bits - radix_bits));
            r = wrapping_sum<Fixed::bits>(r, digit);
        }
        return r;
    }

private:
    static constexpr Limb mask = (Limb(1) << radix_bits) - 1;

    /// 64 bits of a number from a position on, sign-extended.
    template <unsigned M>
    [[nodiscard]] static constexpr Limb bits_from(const FixedInt<M>& x, std::size_t position) noexcept {
        const auto limb = [&](std::size_t i) {
            return i < FixedInt<M>::limb_count ? x.limbs()[i] : (x.is_negative() ? ~Limb(0) : Limb(0));
        };
        const std::size_t whole = position / limbs::bits;
        const std::size_t part = position % limbs::bits;
        return part == 0 ? limb(whole) : (limb(whole) >> part) | (limb(whole + 1) << (limbs::bits - part));
    }

    /// Whether |x| < 2^Bits: the bits from Bits on all equal the sign, and x is not -2^Bits.
    template <unsigned M>
    [[nodiscard]] static constexpr bool is_within(const FixedInt<M>& x) noexcept {
        const Limb fill = x.is_negative() ? ~Limb(0) : 0;
        for (std::size_t position = Bits; position < M; position += limbs::bits) {
            if (bits_from(x, position) != fill) return false;
        }
        if (!x.is_negative()) return true;
        for (std::size_t position = 0; position < Bits; position += limbs::bits) {
            const std::size_t rest = Bits - position;
            const Limb low = bits_from(x, position);
            if ((rest < limbs::bits ? low & ((Limb(1) << rest) - 1) : low) != 0) return true;
        }
        return false;
    }

    Digits digits_{};
};

/// A product to be added to, or subtracted from, a sum.
template <bool Negative, unsigned A, unsigned B>
struct ProductTerm {
    const FixedDigits<A>& a;
    const FixedDigits<B>& b;

    /// Adds the term's column c: all digit products of weight 2^(60 c).
    template <std::size_t C>
    constexpr void add_column(Int128& sum) const noexcept {
        constexpr std::size_t n = FixedDigits<A>::digit_count;
        constexpr std::size_t m = FixedDigits<B>::digit_count;
        constexpr std::size_t first = C < m ? 0 : C - m + 1;
        constexpr std::size_t last = C < n ? C + 1 : n;
        for (std::size_t i = first; i < last; ++i) {
            const Int128 product = Int128(a.digits()[i]) * b.digits()[C - i];
            if constexpr (Negative)
                sum -= product;
            else
                sum += product;
        }
    }

    static constexpr unsigned bits = A + B;
    static constexpr std::size_t columns = FixedDigits<A>::digit_count + FixedDigits<B>::digit_count - 1;
    static constexpr std::size_t depth = FixedDigits<A>::digit_count < FixedDigits<B>::digit_count
                                             ? FixedDigits<A>::digit_count
                                             : FixedDigits<B>::digit_count;
};

/// The term + a b of `sum_of_products`.
template <unsigned A, unsigned B>
[[nodiscard]] constexpr ProductTerm<false, A, B> plus_product(const FixedDigits<A>& a,
                                                              const FixedDigits<B>& b) noexcept {
    return {a, b};
}

/// The term - a b of `sum_of_products`.
template <unsigned A, unsigned B>
[[nodiscard]] constexpr ProductTerm<true, A, B> minus_product(const FixedDigits<A>& a,
                                                              const FixedDigits<B>& b) noexcept {
    return {a, b};
}

/// The exact sum of products, as in `sum_of_products<114>(plus_product(a, d), minus_product(b, c))`.
/// Requires: the sum is below 2^Bits in absolute value, and Bits is not below the bits of any product.
/// Cost: a multiplication for each pair of digits of each term, and a shift for each digit of the result.
template <unsigned Bits, class... Terms>
[[nodiscard]] constexpr FixedDigits<Bits> sum_of_products(const Terms&... terms) noexcept {
    using Result = FixedDigits<Bits>;
    static_assert(((Terms::bits <= Bits) && ...), "the result must have room for each product");
    static_assert(((Terms::columns <= Result::digit_count) && ...), "follows from the bits");
    // |digit| <= 2^60, so a column's products and the carry from below stay under 2^127.
    static_assert((Terms::depth + ...) < 127, "too many products in one column for a 128-bit accumulator");
    typename Result::Digits digits;
    Int128 sum = 0;
    const auto column = [&]<std::size_t C>(std::integral_constant<std::size_t, C>) {
        const auto add = [&](const auto& term) {
            if constexpr (C < std::remove_cvref_t<decltype(term)>::columns) term.template add_column<C>(sum);
        };
        (add(terms), ...);
        if constexpr (C + 1 < Result::digit_count) {
            digits[C] = static_cast<std::int64_t>(static_cast<Limb>(sum) & ((Limb(1) << Result::radix_bits) - 1));
            sum >>= Result::radix_bits;
        } else {
            digits[C] = static_cast<std::int64_t>(sum);
        }
    };
    [&]<std::size_t... C>(std::index_sequence<C...>) {
        (column(std::integral_constant<std::size_t, C>{}), ...);
    }
    (std::make_index_sequence<Result::digit_count>{});
    return Result::from_digits(digits);
}

CLEAVE_END_NAMESPACE

#endif
