// SPDX-License-Identifier: Apache-2.0
/// The library's own integers as numbers: `BasicInteger<L>`, a ring whose fractions are `Rational`.
#ifndef CLEAVE_NUMBER_BUILTIN_HPP
#define CLEAVE_NUMBER_BUILTIN_HPP

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

CLEAVE_END_NAMESPACE

#endif
