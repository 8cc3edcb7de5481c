// SPDX-License-Identifier: Apache-2.0
/// Boost's own big numbers: `cpp_int` a ring, `cpp_rational` a field. Opt-in: needs Boost.Multiprecision's headers
/// only.
#ifndef CLEAVE_NUMBER_BOOST_CPP_HPP
#define CLEAVE_NUMBER_BOOST_CPP_HPP

#include <cleave/number/cpp_int_limbs.hpp>
#include <cleave/number/traits.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

template <>
struct number_traits<boost::multiprecision::cpp_int> : number_traits_defaults<boost::multiprecision::cpp_int> {
    using cpp_int = boost::multiprecision::cpp_int;

    static constexpr bool is_field = false;
    using field_type = boost::multiprecision::cpp_rational;

    [[nodiscard]] static Sign sign(const cpp_int& x) { return sign_of_value(x.sign()); }
    [[nodiscard]] static cpp_int exact_divide(const cpp_int& a, const cpp_int& b) { return a / b; }
    [[nodiscard]] static Fraction to_fraction(const cpp_int& x) { return {cpp_int_limbs::to_integer(x), 1}; }
    [[nodiscard]] static cpp_int from_integer(const Integer& x) { return cpp_int_limbs::from_integer(x); }

    [[nodiscard]] static cpp_int gcd(const cpp_int& a, const cpp_int& b) { return boost::multiprecision::gcd(a, b); }
    [[nodiscard]] static std::size_t bit_length(const cpp_int& x) {
        if (x.is_zero()) return 0;
        const cpp_int magnitude = abs(x);
        return static_cast<std::size_t>(msb(magnitude)) + 1;
    }
};

template <>
struct number_traits<boost::multiprecision::cpp_rational>
    : number_traits_defaults<boost::multiprecision::cpp_rational> {
    using cpp_int = boost::multiprecision::cpp_int;
    using cpp_rational = boost::multiprecision::cpp_rational;

    static constexpr bool is_field = true;
    using field_type = cpp_rational;

    [[nodiscard]] static Sign sign(const cpp_rational& x) { return sign_of_value(x.sign()); }
    [[nodiscard]] static cpp_rational exact_divide(const cpp_rational& a, const cpp_rational& b) { return a / b; }
    [[nodiscard]] static Fraction to_fraction(const cpp_rational& x) {
        const cpp_int num = numerator(x);
        const cpp_int den = denominator(x);
        return {cpp_int_limbs::to_integer(num), cpp_int_limbs::to_integer(den)};
    }
    [[nodiscard]] static cpp_rational from_integer(const Integer& x) {
        return cpp_rational(cpp_int_limbs::from_integer(x));
    }
    [[nodiscard]] static cpp_rational from_fraction(const Integer& num, const Integer& den) {
        if (den.is_zero()) throw NumberError("a fraction with denominator zero is not a number");
        // Some versions of Boost take every negative denominator for one that cannot be negated.
        const bool negative = den.sign() == Sign::minus;
        return negative ? cpp_rational(cpp_int_limbs::from_integer(-num), cpp_int_limbs::from_integer(-den))
                        : cpp_rational(cpp_int_limbs::from_integer(num), cpp_int_limbs::from_integer(den));
    }
};

CLEAVE_END_NAMESPACE

#endif
