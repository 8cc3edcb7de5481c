// SPDX-License-Identifier: Apache-2.0
/// Random exact numbers, vectors and matrices, drawn in the body of a property. Small integers are the rule, so that
/// equal entries, zero minors and coincident planes are frequent; now and then a number is wide.
#ifndef CLEAVE_TESTS_SUPPORT_GENERATORS_HPP
#define CLEAVE_TESTS_SUPPORT_GENERATORS_HPP

#include "support/property.hpp"

#include <cleave/algebra/matrix.hpp>
#include <cleave/number/builtin.hpp>
#include <cleave/number/traits.hpp>

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

// How a counterexample is shown. Catch finds these too.
template <unsigned InlineLimbs>
std::ostream& operator<<(std::ostream& out, const BasicInteger<InlineLimbs>& x) {
    return out << x.to_string();
}
inline std::ostream& operator<<(std::ostream& out, const Fraction& x) {
    return out << x.num << '/' << x.den;
}

CLEAVE_END_NAMESPACE

namespace generators {

// The draws are compiled once, in generators.cpp. One type for every backend and size: each type that rapidcheck draws
// costs seconds of compilation.

/// Any number of up to about `limbs` limbs, with long runs of equal bits at times.
[[nodiscard]] cleave::Integer draw_wide_integer(int limbs = 4);

/// -3 .. 3 mostly, zero twice as often as the others, a number of up to about `limbs` limbs now and then.
[[nodiscard]] cleave::Integer draw_integer(int limbs = 4);

/// How wide the entries of matrices may be, in limbs, so that determinants fit.
template <class N>
inline constexpr int widest_limbs = 4;
template <unsigned Bits>
inline constexpr int widest_limbs<cleave::FixedInt<Bits>> = Bits / 2048;

/// A fraction with small numerator and denominator mostly, a wide one now and then; lowest terms.
[[nodiscard]] cleave::Fraction draw_fraction();

/// `count` fractions, or integers of up to `limbs` limbs.
[[nodiscard]] std::vector<cleave::Fraction> draw_fractions(std::size_t count, bool fractions, int limbs);

/// For each of `count` rows: negative, or the index of the row it is made from.
[[nodiscard]] std::vector<int> draw_repeats(int count);

/// A finite double: small integers and simple binary fractions mostly, any bit pattern otherwise.
[[nodiscard]] double draw_finite_double();

/// A number of N from its value.
template <cleave::ExactRing N>
[[nodiscard]] N from_value(const cleave::Fraction& x) {
    using T = cleave::number_traits<N>;
    if constexpr (T::is_field) {
        return T::from_fraction(x.num, x.den);
    } else {
        return T::from_integer(x.num);
    }
}

/// D numbers: fractions where N has them, integers elsewhere.
template <int D, cleave::ExactRing N>
[[nodiscard]] cleave::Vector<D, N> vector() {
    constexpr auto size = static_cast<std::size_t>(D);
    const std::vector<cleave::Fraction> drawn =
        draw_fractions(size, cleave::number_traits<N>::is_field, widest_limbs<N>);
    cleave::Vector<D, N> v;
    for (std::size_t i = 0; i < size; ++i) v[i] = from_value<N>(drawn[i]);
    return v;
}

/// A number: a fraction where N has them, an integer elsewhere.
template <cleave::ExactRing N>
[[nodiscard]] N number() {
    return vector<1, N>()[0];
}

/// A matrix; one row in three is made from another one or two, so that every rank occurs.
template <int Rows, int Columns, cleave::ExactRing N>
[[nodiscard]] cleave::Matrix<Rows, Columns, N> matrix() {
    cleave::Matrix<Rows, Columns, N> m;
    for (auto& row : m.row) row = vector<Columns, N>();
    const std::vector<int> repeats = draw_repeats(Rows);
    for (int i = 0; i < Rows; ++i) {
        const int other = repeats[static_cast<std::size_t>(i)];
        if (other < 0 || other == i) continue;
        for (int j = 0; j < Columns; ++j) {
            m(i, j) = m(other, j);
            m(i, j) -= m((other + 1) % Rows, j);
        }
    }
    return m;
}

}  // namespace generators

#endif
