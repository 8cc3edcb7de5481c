// SPDX-License-Identifier: Apache-2.0
/// Coordinates of any exact kind as rationals: the form in which the makers of shapes calculate.
#ifndef CLEAVE_SHAPE_RATIONAL_POINT_HPP
#define CLEAVE_SHAPE_RATIONAL_POINT_HPP

#include <cleave/geometry/coordinates.hpp>
#include <cleave/number/rational.hpp>

#include <array>
#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// A point with rational coordinates.
template <int D>
using RationalPoint = std::array<Rational, std::size_t(D)>;

/// The exact value of a coordinate. Throws: NumberError for a double that is infinite or NaN.
template <Coordinate X>
[[nodiscard]] Rational to_rational(const X& x) {
    const Fraction f = exact_fraction(x);
    return number_traits<Rational>::from_fraction(f.num, f.den);
}

/// The same for all coordinates of a point.
template <Coordinate X, std::size_t D>
[[nodiscard]] std::array<Rational, D> to_rational_point(const std::array<X, D>& x) {
    std::array<Rational, D> result;
    for (std::size_t i = 0; i < D; ++i) result[i] = to_rational(x[i]);
    return result;
}

CLEAVE_END_NAMESPACE

#endif
