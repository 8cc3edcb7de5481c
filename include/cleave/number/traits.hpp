// SPDX-License-Identifier: Apache-2.0
/// `number_traits<N>`: what the library needs of a number beyond its operators, and how a type of yours opts in.
///
/// Specialise it (in namespace cleave) and derive from `number_traits_defaults<N>`, which supplies the second half:
///
/// | compulsory member       | result          | meaning                                                            |
/// |-------------------------|-----------------|--------------------------------------------------------------------|
/// | `is_field`              | constant bool   | whether `a / b` is exact for every b != 0                          |
/// | `field_type`            | type            | N for a field, else the type of fractions of N                     |
/// | `sign(a)`               | `Sign`          | the sign of the value                                              |
/// | `exact_divide(a, b)`    | `N`             | q with q * b == a. Requires: b != 0 and q exists                   |
/// | `to_fraction(a)`        | `Fraction`      | lowest terms, positive denominator                                 |
/// | `from_integer(i)`       | `N`             | the value of an `Integer`; NumberError where N has no room for it  |
///
/// | member with a default   | result          | meaning; the default goes by `to_fraction`                         |
/// |-------------------------|-----------------|--------------------------------------------------------------------|
/// | `from_fraction(n, d)`   | `field_type`    | n / d for `Integer`s with any common factor; NumberError if d == 0 |
/// | `gcd(a, b)`             | `N`             | the greatest common divisor, never negative; gcd(0, 0) = 0. In a   |
/// |                         |                 | field: the largest g with both a / g and b / g integers            |
/// | `bit_length(a)`         | `std::size_t`   | least n with |num| < 2^n and den < 2^n, in lowest terms; 0 for 0   |
/// |                         |                 | in a ring without fractions                                        |
/// | `from_double(x)`        | `N`             | exactly x; NumberError for an infinity, a NaN, or a fraction where |
/// |                         |                 | N has none                                                         |
/// | `to_double(a, r)`       | `double`        | the correctly rounded value; r is a `Rounding`, nearest by default |
/// | `enclosure(a)`          | `Interval`      | the tightest interval of doubles around the value                  |
///
/// | optional member         | effect, where it exists                                                              |
/// |-------------------------|--------------------------------------------------------------------------------------|
/// | `add_product(r, a, b)`  | r += a * b without a temporary number; `algebra/product.hpp` uses it                 |
/// | `sub_product(r, a, b)`  | r -= a * b likewise                                                                  |
/// | `product(a, b)`         | a * b as N, also for narrower a and b whose own product would overflow; likewise     |
/// | `to_text(a)`            | "p/q" or "p" faster than by an `Integer`'s digits; `number/text.hpp` uses it         |
///
/// The semantic demands are in number/concepts.hpp.
#ifndef CLEAVE_NUMBER_TRAITS_HPP
#define CLEAVE_NUMBER_TRAITS_HPP

#include <cleave/base/error.hpp>
#include <cleave/number/concepts.hpp>
#include <cleave/number/double.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/interval.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// A rational number as two integers: lowest terms, positive denominator. It carries values from one number type to
/// another and into text; it does no arithmetic.
struct Fraction {
    Integer num = 0;
    Integer den = 1;

    friend bool operator==(const Fraction& a, const Fraction& b) { return a.num == b.num && a.den == b.den; }
};

/// num / den in lowest terms. Throws: NumberError if `den` is zero. Cost: one gcd, two exact divisions.
[[nodiscard]] inline Fraction make_fraction(Integer num, Integer den) {
    if (den.is_zero()) throw NumberError("a fraction with denominator zero is not a number");
    const Integer g = gcd(num, den);
    if (!g.is_one()) {
        num = exact_divide(num, g);
        den = exact_divide(den, g);
    }
    if (den.sign() == Sign::minus) {
        num.negate();
        den.negate();
    }
    return {std::move(num), std::move(den)};
}

/// |x| with its sign, as the nearest double or the next one in the given direction.
[[nodiscard]] inline double round_limbs(LimbView x, Rounding direction) {
    return x.size == 0 ? 0.0 : rounding::round<double>(rounding::leading(x), x.negative(), direction);
}

/// num / den likewise. Requires: den is not zero.
[[nodiscard]] inline double round_limbs(LimbView num, LimbView den, Rounding direction) {
    return rounding::ratio<double>(num, den, direction);
}

/// The second table above, for any number with the members of the first.
template <class N>
struct number_traits_defaults {
    /// n / d, reduced. A field must hide it: a fraction is what the field is for.
    template <class T = number_traits<N>>
    [[nodiscard]] static typename T::field_type from_fraction(const Integer& num, const Integer& den) {
        static_assert(!T::is_field, "number_traits of a field must define from_fraction");
        return number_traits<typename T::field_type>::from_fraction(num, den);
    }

    [[nodiscard]] static N gcd(const N& a, const N& b) {
        using T = number_traits<N>;
        const Fraction x = T::to_fraction(a);
        const Fraction y = T::to_fraction(b);
        if constexpr (T::is_field) {
            // gcd(n/d, p/q) = gcd(n, p) / lcm(d, q), for fractions in lowest terms.
            if (x.num.is_zero() && y.num.is_zero()) return N(0);
            return T::from_fraction(cleave::gcd(x.num, y.num), exact_divide(x.den, cleave::gcd(x.den, y.den)) * y.den);
        } else {
            return T::from_integer(cleave::gcd(x.num, y.num));
        }
    }

    [[nodiscard]] static std::size_t bit_length(const N& a) {
        const Fraction x = number_traits<N>::to_fraction(a);
        if constexpr (number_traits<N>::is_field) {
            return std::max(x.num.bit_length(), x.den.bit_length());
        } else {
            return x.num.bit_length();
        }
    }

    [[nodiscard]] static N from_double(double x) {
        using T = number_traits<N>;
        const DoubleParts parts = decompose(x);
        if (parts.exponent >= 0)
            return T::from_integer(Integer::scaled(parts.mantissa, static_cast<std::size_t>(parts.exponent)));
        if constexpr (T::is_field) {
            return T::from_fraction(Integer(parts.mantissa),
                                    Integer::scaled(1, static_cast<std::size_t>(-parts.exponent)));
        } else {
            throw NumberError("the double " + std::to_string(x) +
                              " has a fractional part, which a ring of integers cannot hold; use a field");
        }
    }

    [[nodiscard]] static double to_double(const N& a, Rounding rounding = Rounding::nearest) {
        const Fraction x = number_traits<N>::to_fraction(a);
        return x.den.is_one() ? round_limbs(x.num.view(), rounding) : round_limbs(x.num.view(), x.den.view(), rounding);
    }

    [[nodiscard]] static Interval enclosure(const N& a) {
        using T = number_traits<N>;
        return Interval(T::to_double(a, Rounding::down), T::to_double(a, Rounding::up));
    }
};

/// The sign of an exact number.
template <ExactRing N>
[[nodiscard]] Sign sign_of(const N& x) {
    return number_traits<N>::sign(x);
}

/// The double nearest to an exact number, ties to even; an infinity beyond the largest.
template <ExactRing N>
[[nodiscard]] double to_double(const N& x) {
    return number_traits<N>::to_double(x);
}

/// The value of one exact number in another exact type.
/// Throws: NumberError if `To` cannot hold it (a fraction in a ring of integers, an integer too wide).
/// Cost: copies; the gcd that a fraction needs was paid when `from` was made canonical, but a `To` may pay it again.
template <ExactRing To, ExactRing From>
[[nodiscard]] To convert_number(const From& from) {
    const Fraction x = number_traits<From>::to_fraction(from);
    if constexpr (number_traits<To>::is_field) {
        return number_traits<To>::from_fraction(x.num, x.den);
    } else {
        if (!x.den.is_one()) throw NumberError("a fraction does not fit a ring of integers; use a field");
        return number_traits<To>::from_integer(x.num);
    }
}

CLEAVE_END_NAMESPACE

#endif
