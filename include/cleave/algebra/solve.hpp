// SPDX-License-Identifier: Apache-2.0
/// Square linear systems without fractions: solutions as numerators over one denominator, inverses as adjugates.
#ifndef CLEAVE_ALGEBRA_SOLVE_HPP
#define CLEAVE_ALGEBRA_SOLVE_HPP

#include <cleave/algebra/determinant.hpp>
#include <cleave/algebra/minors.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// x_i = numerator_i / denominator, the denominator positive. Not reduced: it is Cramer's rule as it stands.
template <int D, ExactRing R>
struct Solution {
    Vector<D, R> numerator;
    R denominator;
};

namespace detail {

/// The matrix [m | b], not copied.
template <SquareMatrix M>
struct Augmented {
    using value_type = typename M::value_type;
    static constexpr int rows = M::rows;
    static constexpr int columns = M::rows + 1;

    const M& left;
    const Vector<rows, value_type>& right;

    [[nodiscard]] const value_type& operator()(int i, int j) const {
        return j < rows ? left(i, j) : right[static_cast<std::size_t>(i)];
    }
};

/// A square matrix without one of its rows, not copied.
template <SquareMatrix M>
struct WithoutRow {
    using value_type = typename M::value_type;
    static constexpr int rows = M::rows - 1;
    static constexpr int columns = M::columns;

    const M& all;
    int omitted;

    [[nodiscard]] const value_type& operator()(int i, int j) const { return all(i < omitted ? i : i + 1, j); }
};

}  // namespace detail

/// The solution of m x = b, or nullopt where m is singular.
/// Cost: that of `minors` of a D x (D + 1) matrix. Entries of the result have the bits of D x D determinants.
template <class R = void, SquareMatrix M>
[[nodiscard]] std::optional<Solution<M::rows, SumType<R, typename M::value_type>>> solve(
    const M& m, const Vector<M::rows, typename M::value_type>& b) {
    using Wide = SumType<R, typename M::value_type>;
    constexpr int D = M::rows;
    // (x, -1) is a null vector of [m | b].
    Vector<D + 1, Wide> v = minors<R>(detail::Augmented<M>{m, b});
    const Sign sign = number_traits<Wide>::sign(v[D]);
    if (sign == Sign::zero) return std::nullopt;
    std::optional<Solution<D, Wide>> result(std::in_place);
    for (std::size_t i = 0; i < static_cast<std::size_t>(D); ++i) {
        if (sign == Sign::plus) v[i] = -v[i];
        result->numerator[i] = std::move(v[i]);
    }
    if (sign == Sign::minus) v[D] = -v[D];
    result->denominator = std::move(v[D]);
    return result;
}

/// The adjugate: m * adjugate(m) == adjugate(m) * m == determinant(m) * identity. It exists for singular m too, where
/// the product is zero.
/// Cost: D times that of `minors` of a (D - 1) x D matrix.
template <class R = void, SquareMatrix M>
[[nodiscard]] Matrix<M::rows, M::rows, SumType<R, typename M::value_type>> adjugate(const M& m) {
    using Wide = SumType<R, typename M::value_type>;
    constexpr int D = M::rows;
    Matrix<D, D, Wide> result;
    if constexpr (D == 1) {
        result(0, 0) = Wide(1);
    } else {
        // The minors without row i are, up to (-1)^i, the cofactors of that row: column i of the adjugate.
        for (int i = 0; i < D; ++i) {
            Vector<D, Wide> cofactors = minors<R>(detail::WithoutRow<M>{m, i});
            if (i % 2 != 0) negate_in_place(cofactors);
            for (int j = 0; j < D; ++j) result(j, i) = std::move(cofactors[static_cast<std::size_t>(j)]);
        }
    }
    return result;
}

CLEAVE_END_NAMESPACE

#endif
