// SPDX-License-Identifier: Apache-2.0
/// `Rational`: the field in which coordinates, measures and centroids leave the library.
///
/// GMP's `mpq_class` where GMP may be used (CLEAVE_HAS_GMP), else Boost's `cpp_rational` (CLEAVE_HAS_BOOST); see
/// base/config.hpp. All files of a program must agree: define CLEAVE_NO_GMP in every one of them or in none.
#ifndef CLEAVE_NUMBER_RATIONAL_HPP
#define CLEAVE_NUMBER_RATIONAL_HPP

#include <cleave/base/config.hpp>

#if defined(CLEAVE_HAS_GMP)
#include <cleave/number/gmp.hpp>
#elif defined(CLEAVE_HAS_BOOST)
#include <cleave/number/boost_cpp.hpp>
#else
#error "cleave needs rational numbers: GMP with its C++ header (libgmp-dev) or Boost.Multiprecision (libboost-dev)"
#endif

CLEAVE_BEGIN_NAMESPACE

#if defined(CLEAVE_HAS_GMP)
using Rational = mpq_class;
#else
using Rational = boost::multiprecision::cpp_rational;
#endif

CLEAVE_END_NAMESPACE

#endif
