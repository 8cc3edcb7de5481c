// SPDX-License-Identifier: Apache-2.0
/// The library's own integers as numbers: `BasicInteger<L>` and `FixedInt<Bits>`, rings whose fractions are `Rational`.
///
/// A `FixedInt` throws NumberError where a result does not fit, so a value is always right. Built-in integers are
/// no rings: they overflow without a word.
#ifndef CLEAVE_NUMBER_BUILTIN_HPP
#define CLEAVE_NUMBER_BUILTIN_HPP

#include <cleave/number/fixed_int.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/rational.hpp>
#include <cleave/number/traits.hpp>

#include <cstddef>
#include <string>

CLEAVE_BEGIN_NAMESPACE

template <unsigned InlineLimbs>
struct number_traits<BasicInteger<InlineLimbs>> : number_traits_defaults<BasicInteger<InlineLimbs>> {
    using Number = BasicInteger<InlineLimbs>;

    static constexpr bool is_field = false;
    using field_type = Rational;

    [[nodiscard]] static Sign sign(const Number& x) noexcept { return x.sign(); }
    [[nodiscard]] static Number exact_divide(const Number& a, const Number& b) { return cleave::exact_divide(a, b); }
    [[nodiscard]] static Fraction to_fraction(const Number& x) { return {Integer(x), 1}; }
    [[nodiscard]] static Number from_integer(const Integer& x) { return Number(x); }

    [[nodiscard]] static Number gcd(const Number& a, const Number& b) { return cleave::gcd(a, b); }
    [[nodiscard]] static std::size_t bit_length(const Number& x) noexcept { return x.bit_length(); }
    [[nodiscard]] static double to_double(const Number& x, Rounding rounding = Rounding::nearest) {
        return round_limbs(x.view(), rounding);
    }
    template <unsigned K, unsigned M>
    static void add_product(Number& r, const BasicInteger<K>& a, const BasicInteger<M>& b) {
        cleave::add_product(r, a, b);
    }
    template <unsigned K, unsigned M>
    static void sub_product(Number& r, const BasicInteger<K>& a, const BasicInteger<M>& b) {
        cleave::sub_product(r, a, b);
    }
};

template <unsigned Bits>
struct number_traits<FixedInt<Bits>> : number_traits_defaults<FixedInt<Bits>> {
    using Number = FixedInt<Bits>;

    static constexpr bool is_field = false;
    using field_type = Rational;

    [[nodiscard]] static constexpr Sign sign(const Number& x) noexcept { return x.sign(); }
    [[nodiscard]] static Number exact_divide(const Number& a, const Number& b) {
        return Number(cleave::exact_divide(a.to_integer(), b.to_integer()));
    }
    [[nodiscard]] static Fraction to_fraction(const Number& x) { return {Integer(x.to_integer()), 1}; }
    [[nodiscard]] static Number from_integer(const Integer& x) { return Number(x); }

    [[nodiscard]] static Number gcd(const Number& a, const Number& b) {
        return Number(cleave::gcd(a.to_integer(), b.to_integer()));
    }
    [[nodiscard]] static std::size_t bit_length(const Number& x) { return x.to_integer().bit_length(); }
    [[nodiscard]] static double to_double(const Number& x, Rounding rounding = Rounding::nearest) {
        return round_limbs(x.to_integer().view(), rounding);
    }
    template <unsigned A, unsigned B>
    [[nodiscard]] static constexpr Number product(const FixedInt<A>& a, const FixedInt<B>& b) {
        return Number(multiply(a, b));
    }
};

CLEAVE_END_NAMESPACE

#endif
