// SPDX-License-Identifier: Apache-2.0
/// Exact numbers and what makes them fast: the lowest floor beside `execution`.
///
/// | header             | holds                                                                                      |
/// |--------------------|--------------------------------------------------------------------------------------------|
/// | number/sign        | `Sign`: minus, zero, plus                                                                  |
/// | number/concepts    | `ExactRing`, `ExactField`: what a number must offer                                        |
/// | number/traits      | `number_traits<N>`, `Fraction`: what it must offer beyond operators; how to plug in yours  |
/// | number/integer     | `Integer`, `BasicInteger<InlineLimbs>`: any size, on the stack while small                 |
/// | number/fixed_int   | `FixedInt<Bits>`: a width chosen by the caller, overflow throws                            |
/// | number/rational    | `Rational`: GMP's or Boost's fractions                                                     |
/// | number/builtin     | the library's own integers as rings                                                        |
/// | number/double      | doubles to integers exactly, and back correctly rounded                                    |
/// | number/interval    | `Interval`: doubles that enclose a real number                                             |
/// | number/filter      | the approximate answer where it is certain, else the exact one                             |
/// | number/modular     | residues modulo primes: cheap witnesses of equality                                        |
/// | number/text        | decimals and `p/q`, in and out                                                             |
///
/// Opt-in, not included here: number/gmp (`mpz_class`, `mpq_class`), number/boost_cpp (`cpp_int`, `cpp_rational`),
/// number/boost_gmp (`mpz_int`, `mpq_rational`).
#ifndef CLEAVE_NUMBER_HPP
#define CLEAVE_NUMBER_HPP

#include <cleave/number/builtin.hpp>
#include <cleave/number/concepts.hpp>
#include <cleave/number/double.hpp>
#include <cleave/number/double_double.hpp>
#include <cleave/number/filter.hpp>
#include <cleave/number/fixed_digits.hpp>
#include <cleave/number/fixed_int.hpp>
#include <cleave/number/fixed_int_determinant.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/interval.hpp>
#include <cleave/number/modular.hpp>
#include <cleave/number/rational.hpp>
#include <cleave/number/sign.hpp>
#include <cleave/number/text.hpp>
#include <cleave/number/traits.hpp>

#endif
