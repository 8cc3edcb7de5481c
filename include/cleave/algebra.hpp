// SPDX-License-Identifier: Apache-2.0
/// Exact linear algebra in any small dimension, over any `ExactRing`: the formulas that geometry is made of.
///
/// | header              | holds                                                                                     |
/// |---------------------|-------------------------------------------------------------------------------------------|
/// | algebra/product     | sums of products, fused where the number can                                              |
/// | algebra/vector      | `Vector<D, N>`, `dot`, `proportionality`                                                  |
/// | algebra/primitive   | the shortest integer vector in a direction                                                |
/// | algebra/matrix      | `Matrix<Rows, Columns, N>`, `rows_of` (a view), products                                  |
/// | algebra/minors      | the D + 1 maximal minors of a D x (D + 1) matrix: planes through points, points on planes |
/// | algebra/determinant | determinants of any size                                                                  |
/// | algebra/solve       | linear systems with one denominator, adjugates                                            |
/// | algebra/echelon     | fraction-free elimination, rank, null space                                               |
/// | algebra/laplace     | division-free expansion with shared minors                                                |
///
/// A matrix of numbers N may be evaluated in another number R that products of N convert to (`minors<R>(m)`); without
/// R, in N. Nothing is divided except where the quotient is known to be exact, so a field is never needed.
#ifndef CLEAVE_ALGEBRA_HPP
#define CLEAVE_ALGEBRA_HPP

#include <cleave/algebra/determinant.hpp>
#include <cleave/algebra/echelon.hpp>
#include <cleave/algebra/laplace.hpp>
#include <cleave/algebra/matrix.hpp>
#include <cleave/algebra/minors.hpp>
#include <cleave/algebra/primitive.hpp>
#include <cleave/algebra/product.hpp>
#include <cleave/algebra/solve.hpp>
#include <cleave/algebra/vector.hpp>

#endif
