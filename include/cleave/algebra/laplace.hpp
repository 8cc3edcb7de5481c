// SPDX-License-Identifier: Apache-2.0
/// Division-free minors: Laplace's expansion along the last row, with every smaller minor computed once and shared.
#ifndef CLEAVE_ALGEBRA_LAPLACE_HPP
#define CLEAVE_ALGEBRA_LAPLACE_HPP

#include <cleave/algebra/matrix.hpp>

#include <bit>
#include <cstddef>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// For every set of k <= rows columns, the minor of the first k rows and these columns; the set is the index's bits, so
/// entry 0 is the empty minor 1 and entry 0b101 the one of the first two rows and columns 0 and 2. Sets of more than
/// `rows` columns have no minor: their entries mean nothing.
///
/// Needs no division and no number wider than the minors, so it is the form for fixed widths.
/// Cost: at most columns * 2^(columns - 1) products; 2^columns numbers of memory.
template <class R = void, MatrixLike M>
[[nodiscard]] std::vector<SumType<R, typename M::value_type>> laplace_minors(const M& m) {
    using Wide = SumType<R, typename M::value_type>;
    static_assert(M::columns <= 20, "use the echelon form for large matrices");
    const unsigned sets = 1u << M::columns;
    std::vector<Wide> minor(sets);
    minor[0] = Wide(1);
    // A subset of a set is a smaller number, so every smaller minor is there when it is needed.
    for (unsigned set = 1; set < sets; ++set) {
        const int row = std::popcount(set) - 1;
        if (row >= M::rows) continue;
        Wide sum(0);
        bool minus = row % 2 != 0;  // the sign of entry (row, p) of a square matrix of row + 1 rows, at p = 0
        for (unsigned rest = set; rest != 0; rest &= rest - 1) {
            const int column = std::countr_zero(rest);
            const unsigned others = set & ~(1u << column);
            if (minus) {
                sub_product(sum, minor[others], m(row, column));
            } else {
                add_product(sum, minor[others], m(row, column));
            }
            minus = !minus;
        }
        minor[set] = sum;
    }
    return minor;
}

CLEAVE_END_NAMESPACE

#endif
