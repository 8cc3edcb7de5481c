// SPDX-License-Identifier: Apache-2.0
/// Numbers of any kind brought to one exact type: what the makers of points, planes and maps share.
#ifndef CLEAVE_GEOMETRY_COORDINATES_HPP
#define CLEAVE_GEOMETRY_COORDINATES_HPP

#include <cleave/algebra/vector.hpp>
#include <cleave/number/builtin.hpp>
#include <cleave/number/double.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/traits.hpp>

#include <concepts>
#include <cstddef>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// A coordinate as a user may write it: a built-in integer, a finite double, or any exact number. A double stands for
/// the rational that it is, not for the decimal that it was written as.
template <class X>
concept Coordinate = BuiltinInteger<X> || std::floating_point<X> || ExactRing<X>;

/// The exact value in lowest terms. Throws: NumberError for a double that is infinite or NaN.
template <Coordinate X>
[[nodiscard]] Fraction exact_fraction(const X& x) {
    if constexpr (BuiltinInteger<X>) {
        return Fraction{Integer(x), Integer(1)};
    } else if constexpr (std::floating_point<X>) {
        static_assert(sizeof(X) <= sizeof(double), "long double is not read");
        const DoubleParts parts = decompose(static_cast<double>(x));
        const auto shift = static_cast<std::size_t>(parts.exponent < 0 ? -parts.exponent : parts.exponent);
        if (parts.exponent >= 0) return Fraction{Integer::scaled(parts.mantissa, shift), Integer(1)};
        return Fraction{Integer(parts.mantissa), Integer::scaled(1, shift)};  // the mantissa is odd
    } else {
        return number_traits<X>::to_fraction(x);
    }
}

/// numerator / denominator in the field of fractions. Requires: the denominator is positive.
template <ExactRing N>
[[nodiscard]] typename number_traits<N>::field_type ratio(const N& numerator, const N& denominator) {
    if constexpr (number_traits<N>::is_field) {
        return N(numerator / denominator);
    } else {
        return number_traits<N>::from_fraction(number_traits<N>::to_fraction(numerator).num,
                                               number_traits<N>::to_fraction(denominator).num);
    }
}

/// Numbers x_i = numerators_i / denominator of one ring, the denominator positive.
template <ExactRing N, std::size_t K>
struct CommonDenominator {
    std::array<N, K> numerators;
    N denominator;
};

/// The given numbers over one denominator: the least one for a ring, 1 for a field (which needs none).
/// Throws: NumberError where a value does not fit N.
template <ExactRing N, Coordinate... X>
[[nodiscard]] CommonDenominator<N, sizeof...(X)> over_common_denominator(const X&... x) {
    constexpr std::size_t K = sizeof...(X);
    if constexpr (((std::same_as<X, N> || std::same_as<X, int>)&&...)) {
        return {{N(x)...}, N(1)};
    } else if constexpr (ExactField<N>) {
        const auto convert = [](const auto& value) -> N {
            const Fraction f = exact_fraction(value);
            return number_traits<N>::from_fraction(f.num, f.den);
        };
        return {{convert(x)...}, N(1)};
    } else {
        std::array<Fraction, K> values{exact_fraction(x)...};
        Integer least(1);
        for (const Fraction& f : values) least *= exact_divide(f.den, gcd(least, f.den));
        CommonDenominator<N, K> result;
        for (std::size_t i = 0; i < K; ++i) {
            Integer numerator = exact_divide(least, values[i].den);
            numerator *= values[i].num;
            result.numerators[i] = number_traits<N>::from_integer(numerator);
        }
        result.denominator = number_traits<N>::from_integer(least);
        return result;
    }
}

/// The same for an array.
template <ExactRing N, Coordinate X, std::size_t K>
[[nodiscard]] CommonDenominator<N, K> over_common_denominator(const std::array<X, K>& x) {
    return [&x]<std::size_t... I>(std::index_sequence<I...>) {
        return over_common_denominator<N>(x[I]...);
    }
    (std::make_index_sequence<K>());
}

CLEAVE_END_NAMESPACE

#endif
