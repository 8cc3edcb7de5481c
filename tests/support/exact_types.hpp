// SPDX-License-Identifier: Apache-2.0
/// The number types that one test body of geometry and clip runs over, and rationals for what is expected.
#ifndef CLEAVE_TESTS_SUPPORT_EXACT_TYPES_HPP
#define CLEAVE_TESTS_SUPPORT_EXACT_TYPES_HPP

#include "support/backends.hpp"

#include <cleave/number/builtin.hpp>
#include <cleave/number/rational.hpp>

#include <tuple>

/// A ring of ours, one with expression templates, and a field. For `TEMPLATE_LIST_TEST_CASE`. Every backend obeys the
/// same laws in tests/unit/number and tests/unit/algebra, and computes the same results in tests/property/agreement_*;
/// here each type costs seconds of compiling.
using ExactTypes = std::tuple<cleave::Integer, mpz_class, cleave::Rational>;

/// A ring and a field: for tests that take long to compile.
using RingAndField = std::tuple<cleave::Integer, cleave::Rational>;

/// numerator / denominator.
inline cleave::Rational rational(int numerator, int denominator = 1) {
    return cleave::number_traits<cleave::Rational>::from_fraction(numerator, denominator);
}

/// The same in the field of fractions of N.
template <class N>
typename cleave::number_traits<N>::field_type fraction_of(int numerator, int denominator = 1) {
    return cleave::number_traits<typename cleave::number_traits<N>::field_type>::from_fraction(numerator, denominator);
}

#endif
