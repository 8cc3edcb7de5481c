// SPDX-License-Identifier: Apache-2.0
/// Determinants of any size: unrolled to 4 x 4, division-free to 6 x 6, fraction-free elimination beyond.
#ifndef CLEAVE_ALGEBRA_DETERMINANT_HPP
#define CLEAVE_ALGEBRA_DETERMINANT_HPP

#include <cleave/algebra/echelon.hpp>
#include <cleave/algebra/laplace.hpp>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// A matrix with as many rows as columns.
template <class M>
concept SquareMatrix = MatrixLike<M> && M::rows == M::columns;

/// The determinant by shared Laplace expansion. Cost: n * 2^(n - 1) products, no division.
template <class R = void, SquareMatrix M>
[[nodiscard]] SumType<R, typename M::value_type> determinant_laplace(const M& m) {
    return laplace_minors<R>(m).back();
}

/// The determinant by fraction-free elimination. Cost: about 2/3 n^3 products and n^3 / 3 exact divisions, of numbers
/// with twice the bits of the minors.
template <class R = void, SquareMatrix M>
[[nodiscard]] SumType<R, typename M::value_type> determinant_bareiss(const M& m) {
    using Wide = SumType<R, typename M::value_type>;
    const Echelon<Wide> echelon = row_echelon<R>(m);
    if (echelon.rank() < M::rows) return Wide(0);
    Wide r(echelon.last_pivot());
    if (echelon.odd()) r = -r;
    return r;
}

/// The determinant, in R (by default the type of the entries).
/// Cost: 2, 9 and 28 products for n = 2, 3, 4; above that see the two forms it chooses from.
template <class R = void, SquareMatrix M>
[[nodiscard]] SumType<R, typename M::value_type> determinant(const M& m) {
    using Wide = SumType<R, typename M::value_type>;
    constexpr int n = M::rows;
    if constexpr (n == 1) {
        return Wide(m(0, 0));
    } else if constexpr (n == 2) {
        return determinant_of_two<Wide>(m(0, 0), m(0, 1), m(1, 0), m(1, 1));
    } else if constexpr (n == 3) {
        // Minors of rows 1 and 2, named by their columns.
        const Wide m12 = determinant_of_two<Wide>(m(1, 1), m(1, 2), m(2, 1), m(2, 2));
        const Wide m02 = determinant_of_two<Wide>(m(1, 0), m(1, 2), m(2, 0), m(2, 2));
        const Wide m01 = determinant_of_two<Wide>(m(1, 0), m(1, 1), m(2, 0), m(2, 1));
        return alternating_sum(m(0, 0), m12, m(0, 1), m02, m(0, 2), m01);
    } else if constexpr (n == 4) {
        // Minors of rows 2 and 3, then of rows 1 to 3.
        const Wide m01 = determinant_of_two<Wide>(m(2, 0), m(2, 1), m(3, 0), m(3, 1));
        const Wide m02 = determinant_of_two<Wide>(m(2, 0), m(2, 2), m(3, 0), m(3, 2));
        const Wide m03 = determinant_of_two<Wide>(m(2, 0), m(2, 3), m(3, 0), m(3, 3));
        const Wide m12 = determinant_of_two<Wide>(m(2, 1), m(2, 2), m(3, 1), m(3, 2));
        const Wide m13 = determinant_of_two<Wide>(m(2, 1), m(2, 3), m(3, 1), m(3, 3));
        const Wide m23 = determinant_of_two<Wide>(m(2, 2), m(2, 3), m(3, 2), m(3, 3));
        const Wide m123 = alternating_sum(m(1, 1), m23, m(1, 2), m13, m(1, 3), m12);
        const Wide m023 = alternating_sum(m(1, 0), m23, m(1, 2), m03, m(1, 3), m02);
        const Wide m013 = alternating_sum(m(1, 0), m13, m(1, 1), m03, m(1, 3), m01);
        const Wide m012 = alternating_sum(m(1, 0), m12, m(1, 1), m02, m(1, 2), m01);
        return alternating_sum(m(0, 0), m123, m(0, 1), m023, m(0, 2), m013, m(0, 3), m012);
    } else if constexpr (n <= 6) {
        return determinant_laplace<R>(m);
    } else {
        return determinant_bareiss<R>(m);
    }
}

CLEAVE_END_NAMESPACE

#endif
