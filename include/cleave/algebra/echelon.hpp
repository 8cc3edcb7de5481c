// SPDX-License-Identifier: Apache-2.0
/// Fraction-free elimination: row echelon form, rank and null space of a matrix over any exact ring.
///
/// One-step elimination after Bareiss, "Sylvester's identity and multistep integer-preserving Gaussian elimination",
/// Mathematics of Computation 22 (1968): with a_kk the pivot and p the pivot before it,
///
///     a_ij <- (a_kk a_ij - a_ik a_kj) / p
///
/// divides without remainder, and every entry that ever appears is a minor of the matrix. Columns without a pivot are
/// skipped, which changes only which minors appear.
#ifndef CLEAVE_ALGEBRA_ECHELON_HPP
#define CLEAVE_ALGEBRA_ECHELON_HPP

#include <cleave/algebra/matrix.hpp>
#include <cleave/base/contract.hpp>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A matrix of R in row echelon form, with what is needed to recover minors from it. In row k < rank() the first entry
/// that is not zero is in column `pivot_column(k)`; it is, up to the sign of the row exchanges, the minor of the rows
/// used so far and of the pivot columns up to this one.
template <ExactRing R>
class Echelon {
public:
    /// Eliminates the rows x columns matrix with the entries `entry(i, j)`.
    /// Cost: rows * columns * rank products and half as many exact divisions; products have twice the bits of the
    /// minors, so a fixed width needs room for that.
    template <class Entry>
    Echelon(int rows, int columns, Entry&& entry) : rows_(rows), columns_(columns) {
        entries_.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < columns; ++j) entries_.emplace_back(entry(i, j));
        }
        for (int column = 0; column < columns_ && rank() < rows_; ++column) eliminate(column);
    }

    [[nodiscard]] int rows() const noexcept { return rows_; }
    [[nodiscard]] int columns() const noexcept { return columns_; }
    [[nodiscard]] int rank() const noexcept { return static_cast<int>(pivot_columns_.size()); }
    [[nodiscard]] int pivot_column(int k) const { return pivot_columns_[static_cast<std::size_t>(k)]; }

    /// Whether the number of row exchanges was odd.
    [[nodiscard]] bool odd() const noexcept { return odd_; }

    [[nodiscard]] const R& operator()(int i, int j) const { return entries_[index(i, j)]; }

    /// The last pivot: up to sign, the minor of all pivot columns. Requires: rank() > 0.
    [[nodiscard]] const R& last_pivot() const { return (*this)(rank() - 1, pivot_column(rank() - 1)); }

    /// The null vector whose entry in the free column `free` is `last_pivot()` and which is zero in the other free
    /// columns. `result` is any indexable sequence of columns() numbers R.
    /// Requires: rank() > 0 and `free` is not a pivot column.
    template <class Sequence>
    void null_vector(int free, Sequence& result) const {
        for (int j = 0; j < columns_; ++j) result[static_cast<std::size_t>(j)] = R(0);
        result[static_cast<std::size_t>(free)] = last_pivot();
        // By Cramer's rule each entry is a minor again, so the divisions of the back substitution leave no remainder.
        for (int k = rank() - 1; k >= 0; --k) {
            const int pivot = pivot_column(k);
            R sum(0);
            for (int j = pivot + 1; j < columns_; ++j) {
                const R& x = result[static_cast<std::size_t>(j)];
                if (number_traits<R>::sign(x) != Sign::zero) sub_product(sum, (*this)(k, j), x);
            }
            result[static_cast<std::size_t>(pivot)] = number_traits<R>::exact_divide(sum, (*this)(k, pivot));
        }
    }

private:
    [[nodiscard]] std::size_t index(int i, int j) const noexcept {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(j);
    }

    void eliminate(int column) {
        const int k = rank();
        int pivot = k;
        while (pivot < rows_ && number_traits<R>::sign(entries_[index(pivot, column)]) == Sign::zero) ++pivot;
        if (pivot == rows_) return;
        if (pivot != k) {
            odd_ = !odd_;
            for (int j = 0; j < columns_; ++j) std::swap(entries_[index(pivot, j)], entries_[index(k, j)]);
        }
        const R& head = entries_[index(k, column)];
        for (int i = k + 1; i < rows_; ++i) {
            R& first = entries_[index(i, column)];
            for (int j = column + 1; j < columns_; ++j) {
                R& x = entries_[index(i, j)];
                R next = product<R>(head, x);
                sub_product(next, first, entries_[index(k, j)]);
                if (k == 0) {
                    x = std::move(next);
                } else {
                    x = number_traits<R>::exact_divide(next, last_pivot());
                }
            }
            first = R(0);
        }
        pivot_columns_.push_back(column);
    }

    int rows_;
    int columns_;
    std::vector<R> entries_;
    std::vector<int> pivot_columns_;
    bool odd_ = false;
};

/// The echelon form of a matrix, computed in R (by default the type of its entries).
template <class R = void, MatrixLike M>
[[nodiscard]] Echelon<SumType<R, typename M::value_type>> row_echelon(const M& m) {
    return Echelon<SumType<R, typename M::value_type>>(
        M::rows, M::columns, [&m](int i, int j) -> const typename M::value_type& { return m(i, j); });
}

/// The number of linearly independent rows.
template <class R = void, MatrixLike M>
[[nodiscard]] int rank(const M& m) {
    return row_echelon<R>(m).rank();
}

/// The number of linearly independent vectors among any number of them (0 of none).
template <class R = void, ExactRing N, std::size_t D>
[[nodiscard]] int rank(std::span<const std::array<N, D>> rows) {
    return Echelon<SumType<R, N>>(static_cast<int>(rows.size()), static_cast<int>(D),
                                  [rows](int i, int j) -> const N& {
                                      return rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
                                  })
        .rank();
}

/// A basis of the vectors v with m v = 0: columns - rank of them, one for each column without a pivot, in that order.
template <class R = void, MatrixLike M>
[[nodiscard]] std::vector<Vector<M::columns, SumType<R, typename M::value_type>>> nullspace(const M& m) {
    using Wide = SumType<R, typename M::value_type>;
    const Echelon<Wide> echelon = row_echelon<R>(m);
    std::vector<Vector<M::columns, Wide>> basis;
    int k = 0;
    for (int column = 0; column < M::columns; ++column) {
        if (k < echelon.rank() && echelon.pivot_column(k) == column) {
            ++k;
            continue;
        }
        Vector<M::columns, Wide>& v = basis.emplace_back();
        if (echelon.rank() > 0) {
            echelon.null_vector(column, v);
        } else {
            for (int j = 0; j < M::columns; ++j) v[static_cast<std::size_t>(j)] = Wide(j == column ? 1 : 0);
        }
    }
    return basis;
}

CLEAVE_END_NAMESPACE

#endif
