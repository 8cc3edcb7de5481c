// SPDX-License-Identifier: Apache-2.0
/// Small matrices of exact numbers, and views that make a matrix of rows stored elsewhere without copying them.
#ifndef CLEAVE_ALGEBRA_MATRIX_HPP
#define CLEAVE_ALGEBRA_MATRIX_HPP

#include <cleave/algebra/vector.hpp>

#include <array>
#include <concepts>
#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

// clang-format off
/// Anything with `M::rows` x `M::columns` entries of type `M::value_type`, read as `m(row, column)`, counted from 0.
template <class M>
concept MatrixLike = requires(const M& m, int i) {
    requires ExactRing<typename M::value_type>;
    { M::rows } -> std::convertible_to<int>;
    { M::columns } -> std::convertible_to<int>;
    { m(i, i) } -> std::same_as<const typename M::value_type&>;
};
// clang-format on

/// A matrix that owns its entries, stored row by row. An aggregate: `Matrix<2, 2, N>{{{{a, b}}, {{c, d}}}}`.
template <int Rows, int Columns, ExactRing N>
struct Matrix {
    static_assert(Rows > 0 && Columns > 0);

    using value_type = N;
    static constexpr int rows = Rows;
    static constexpr int columns = Columns;

    std::array<Vector<Columns, N>, static_cast<std::size_t>(Rows)> row;

    [[nodiscard]] const N& operator()(int i, int j) const {
        return row[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
    [[nodiscard]] N& operator()(int i, int j) { return row[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; }

    friend bool operator==(const Matrix& a, const Matrix& b) { return a.row == b.row; }
};

/// A matrix whose rows live elsewhere, for as long as they do.
template <int Rows, int Columns, ExactRing N>
struct RowsView {
    using value_type = N;
    static constexpr int rows = Rows;
    static constexpr int columns = Columns;

    std::array<const Vector<Columns, N>*, static_cast<std::size_t>(Rows)> row;

    [[nodiscard]] const N& operator()(int i, int j) const {
        return (*row[static_cast<std::size_t>(i)])[static_cast<std::size_t>(j)];
    }
};

/// The matrix with the given rows, not copied: `minors(rows_of(p, q, r))`.
template <ExactRing N, std::size_t C, class... Rest>
requires(std::same_as<Rest, std::array<N, C>>&&...)
    [[nodiscard]] RowsView<1 + static_cast<int>(sizeof...(Rest)), static_cast<int>(C), N> rows_of(
        const std::array<N, C>& first, const Rest&... rest) {
    return {{&first, &rest...}};
}

/// A copy of any matrix.
template <MatrixLike M>
[[nodiscard]] Matrix<M::rows, M::columns, typename M::value_type> to_matrix(const M& m) {
    Matrix<M::rows, M::columns, typename M::value_type> r;
    for (int i = 0; i < M::rows; ++i) {
        for (int j = 0; j < M::columns; ++j) r(i, j) = m(i, j);
    }
    return r;
}

/// Ones on the diagonal, zeros elsewhere.
template <int D, ExactRing N>
[[nodiscard]] Matrix<D, D, N> identity_matrix() {
    Matrix<D, D, N> r;
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) r(i, j) = N(i == j ? 1 : 0);
    }
    return r;
}

/// Rows and columns exchanged.
template <MatrixLike M>
[[nodiscard]] Matrix<M::columns, M::rows, typename M::value_type> transpose(const M& m) {
    Matrix<M::columns, M::rows, typename M::value_type> r;
    for (int i = 0; i < M::rows; ++i) {
        for (int j = 0; j < M::columns; ++j) r(j, i) = m(i, j);
    }
    return r;
}

/// The matrix product.
template <MatrixLike A, MatrixLike B>
requires(A::columns == B::rows && std::same_as<typename A::value_type, typename B::value_type>)
    [[nodiscard]] Matrix<A::rows, B::columns, typename A::value_type> multiply(const A& a, const B& b) {
    using N = typename A::value_type;
    Matrix<A::rows, B::columns, N> r;
    for (int i = 0; i < A::rows; ++i) {
        for (int j = 0; j < B::columns; ++j) {
            N sum = product<N>(a(i, 0), b(0, j));
            for (int k = 1; k < A::columns; ++k) add_product(sum, a(i, k), b(k, j));
            r(i, j) = sum;
        }
    }
    return r;
}

/// The product of a matrix and a column vector.
template <MatrixLike A>
[[nodiscard]] Vector<A::rows, typename A::value_type> multiply(const A& a,
                                                               const Vector<A::columns, typename A::value_type>& v) {
    using N = typename A::value_type;
    Vector<A::rows, N> r;
    for (int i = 0; i < A::rows; ++i) {
        N sum = product<N>(a(i, 0), v[0]);
        for (int k = 1; k < A::columns; ++k) add_product(sum, a(i, k), v[static_cast<std::size_t>(k)]);
        r[static_cast<std::size_t>(i)] = sum;
    }
    return r;
}

CLEAVE_END_NAMESPACE

#endif
