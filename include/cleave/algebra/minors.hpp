// SPDX-License-Identifier: Apache-2.0
/// The vector of maximal minors of a D x (D + 1) matrix: the plane through D points, the point on D planes.
///
/// minors(M) has the entries
///
///     v_i = (-1)^i det(M without column i),    i = 0 .. D
///
/// so that M v = 0 (each row is orthogonal to v), and for any further row r, r . v is the determinant of the square
/// matrix with r above the rows of M (Laplace's expansion along its first row). v is zero exactly if the rows are
/// linearly dependent. For D = 2 it is the cross product of the rows.
///
/// A plane `n . x + c` is the vector (n, c) and a point the vector (x w, w), so both "the plane through D points" and
/// "the point on D planes" are this one function; orientation and the sign of the weight are matters of geometry.
/// If entries have b bits, entries of v have at most D b + log2(D!) bits; Hadamard's bound is a little smaller.
#ifndef CLEAVE_ALGEBRA_MINORS_HPP
#define CLEAVE_ALGEBRA_MINORS_HPP

#include <cleave/algebra/echelon.hpp>
#include <cleave/algebra/laplace.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A matrix with one column more than it has rows.
template <class M>
concept WideByOne = MatrixLike<M> && M::columns == M::rows + 1;

/// `minors` by shared Laplace expansion. Cost: about (D + 1) (2^D - 1) products, no division.
template <class R = void, WideByOne M>
[[nodiscard]] Vector<M::columns, SumType<R, typename M::value_type>> minors_laplace(const M& m) {
    using Wide = SumType<R, typename M::value_type>;
    std::vector<Wide> all = laplace_minors<R>(m);
    const std::size_t every_column = all.size() - 1;
    Vector<M::columns, Wide> v;
    for (int i = 0; i < M::columns; ++i) {
        Wide& minor = all[every_column & ~(std::size_t{1} << i)];
        if (i % 2 != 0) minor = -minor;
        v[static_cast<std::size_t>(i)] = std::move(minor);
    }
    return v;
}

/// `minors` by fraction-free elimination: the null vector of the matrix, scaled by its last pivot.
/// Cost: about 2/3 D^3 products and D^3 / 3 exact divisions, of numbers with twice the bits of the minors.
template <class R = void, WideByOne M>
[[nodiscard]] Vector<M::columns, SumType<R, typename M::value_type>> minors_bareiss(const M& m) {
    using Wide = SumType<R, typename M::value_type>;
    const Echelon<Wide> echelon = row_echelon<R>(m);
    Vector<M::columns, Wide> v;
    if (echelon.rank() < M::rows) {
        for (Wide& x : v) x = Wide(0);
        return v;
    }
    int free = 0;
    while (free < M::rows && echelon.pivot_column(free) == free) ++free;
    echelon.null_vector(free, v);
    // Entry `free` is now the last pivot, which is the minor without that column but for the row exchanges.
    if (echelon.odd() != (free % 2 != 0)) negate_in_place(v);
    return v;
}

namespace detail {

/// The place of {i, j}, i < j, among the pairs of 5 columns in lexicographic order.
constexpr std::size_t pair_of_five(int i, int j) {
    return static_cast<std::size_t>(i * (9 - i) / 2 + j - i - 1);
}

/// The minors of a 4 x 5 matrix from the 10 minors of its last two rows and the 10 of its last three.
template <ExactRing R, MatrixLike M>
[[nodiscard]] Vector<5, R> minors_of_four(const M& m) {
    std::array<R, 10> two;
    for (int i = 0; i < 5; ++i) {
        for (int j = i + 1; j < 5; ++j) {
            two[pair_of_five(i, j)] = determinant_of_two<R>(m(2, i), m(2, j), m(3, i), m(3, j));
        }
    }
    // Filed under the two columns left out: triples in lexicographic order are these pairs in reverse.
    std::array<R, 10> three;
    std::size_t place = three.size();
    for (int i = 0; i < 5; ++i) {
        for (int j = i + 1; j < 5; ++j) {
            for (int k = j + 1; k < 5; ++k) {
                three[--place] = alternating_sum(m(1, i), two[pair_of_five(j, k)], m(1, j), two[pair_of_five(i, k)],
                                                 m(1, k), two[pair_of_five(i, j)]);
            }
        }
    }
    const auto t = [&three](int i, int j) -> const R& { return three[pair_of_five(i, j)]; };
    return {alternating_sum(m(0, 1), t(0, 1), m(0, 2), t(0, 2), m(0, 3), t(0, 3), m(0, 4), t(0, 4)),
            negated_alternating_sum(m(0, 0), t(0, 1), m(0, 2), t(1, 2), m(0, 3), t(1, 3), m(0, 4), t(1, 4)),
            alternating_sum(m(0, 0), t(0, 2), m(0, 1), t(1, 2), m(0, 3), t(2, 3), m(0, 4), t(2, 4)),
            negated_alternating_sum(m(0, 0), t(0, 3), m(0, 1), t(1, 3), m(0, 2), t(2, 3), m(0, 4), t(3, 4)),
            alternating_sum(m(0, 0), t(0, 4), m(0, 1), t(1, 4), m(0, 2), t(2, 4), m(0, 3), t(3, 4))};
}

}  // namespace detail

/// The D + 1 maximal minors with alternating signs, in R (by default the type of the entries).
/// Cost: 0, 6, 24 and 70 products for D = 1, 2, 3, 4; above that see the two forms it chooses from.
template <class R = void, WideByOne M>
[[nodiscard]] Vector<M::columns, SumType<R, typename M::value_type>> minors(const M& m) {
    using Wide = SumType<R, typename M::value_type>;
    constexpr int D = M::rows;
    if constexpr (D == 1) {
        return {Wide(m(0, 1)), Wide(-m(0, 0))};
    } else if constexpr (D == 2) {
        return {determinant_of_two<Wide>(m(0, 1), m(0, 2), m(1, 1), m(1, 2)),
                determinant_of_two<Wide>(m(0, 2), m(0, 0), m(1, 2), m(1, 0)),
                determinant_of_two<Wide>(m(0, 0), m(0, 1), m(1, 0), m(1, 1))};
    } else if constexpr (D == 3) {
        // Minors of rows 1 and 2, named by their columns.
        const Wide m01 = determinant_of_two<Wide>(m(1, 0), m(1, 1), m(2, 0), m(2, 1));
        const Wide m02 = determinant_of_two<Wide>(m(1, 0), m(1, 2), m(2, 0), m(2, 2));
        const Wide m03 = determinant_of_two<Wide>(m(1, 0), m(1, 3), m(2, 0), m(2, 3));
        const Wide m12 = determinant_of_two<Wide>(m(1, 1), m(1, 2), m(2, 1), m(2, 2));
        const Wide m13 = determinant_of_two<Wide>(m(1, 1), m(1, 3), m(2, 1), m(2, 3));
        const Wide m23 = determinant_of_two<Wide>(m(1, 2), m(1, 3), m(2, 2), m(2, 3));
        return {alternating_sum(m(0, 1), m23, m(0, 2), m13, m(0, 3), m12),
                negated_alternating_sum(m(0, 0), m23, m(0, 2), m03, m(0, 3), m02),
                alternating_sum(m(0, 0), m13, m(0, 1), m03, m(0, 3), m01),
                negated_alternating_sum(m(0, 0), m12, m(0, 1), m02, m(0, 2), m01)};
    } else if constexpr (D == 4) {
        return detail::minors_of_four<Wide>(m);
    } else if constexpr (D <= 6) {
        return minors_laplace<R>(m);
    } else {
        return minors_bareiss<R>(m);
    }
}

CLEAVE_END_NAMESPACE

#endif
