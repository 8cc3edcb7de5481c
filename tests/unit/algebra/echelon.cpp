// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/echelon.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/counting.hpp"
#include "support/generators.hpp"

#include <cleave/algebra/laplace.hpp>

#include <bit>
#include <span>
#include <vector>

using namespace cleave;
using support::property;

namespace {

/// The largest k with a k x k minor that is not zero, by trying them all: rows are chosen by bits too.
template <int Rows, int Columns, class N>
int rank_by_minors(const Matrix<Rows, Columns, N>& m) {
    int best = 0;
    for (unsigned chosen = 1; chosen < (1u << Rows); ++chosen) {
        // The chosen rows on top, so that Laplace's first minors are theirs.
        Matrix<Rows, Columns, N> sorted = m;
        std::size_t top = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(Rows); ++i) {
            if ((chosen >> i & 1) != 0) sorted.row[top++] = m.row[i];
        }
        const std::vector<N> minors = laplace_minors(sorted);
        for (unsigned set = 1; set < minors.size(); ++set) {
            const int size = std::popcount(set);
            if (size == static_cast<int>(top) && number_traits<N>::sign(minors[set]) != Sign::zero)
                best = std::max(best, size);
        }
    }
    return best;
}

template <int Rows, int Columns, class N>
void check_laws() {
    const Matrix<Rows, Columns, N> m = generators::matrix<Rows, Columns, N>();
    const Echelon<N> echelon = row_echelon(m);
    RC_ASSERT(echelon.rank() == rank_by_minors(m));
    for (int i = 0; i < Rows; ++i) {
        const int pivot = i < echelon.rank() ? echelon.pivot_column(i) : Columns;
        for (int j = 0; j < pivot; ++j) RC_ASSERT(number_traits<N>::sign(echelon(i, j)) == Sign::zero);
        if (pivot < Columns) RC_ASSERT(number_traits<N>::sign(echelon(i, pivot)) != Sign::zero);
    }

    const std::vector<Vector<Columns, N>> basis = nullspace(m);
    RC_ASSERT(static_cast<int>(basis.size()) == Columns - echelon.rank());
    for (const Vector<Columns, N>& v : basis) RC_ASSERT(is_zero(multiply(m, v)));
    RC_ASSERT(rank(std::span<const Vector<Columns, N>>(basis)) == static_cast<int>(basis.size()));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("echelon: rank is that of the minors, and the null space is null, independent and complete", "",
                        backends::Numbers) {
    property("3 x 4", [] { check_laws<3, 4, TestType>(); });
}

TEST_CASE("echelon: the same for a long and for a square matrix") {
    property("4 x 2", [] { check_laws<4, 2, Integer>(); });
    property("2 x 5", [] { check_laws<2, 5, Integer>(); });
    property("4 x 4", [] { check_laws<4, 4, Integer>(); });
}

TEST_CASE("echelon: the rank of any number of vectors") {
    std::vector<Vector<3, Integer>> rows;
    CHECK(rank(std::span<const Vector<3, Integer>>(rows)) == 0);
    rows.push_back({0, 0, 0});
    CHECK(rank(std::span<const Vector<3, Integer>>(rows)) == 0);
    rows.push_back({0, 2, 4});
    rows.push_back({0, 3, 6});
    CHECK(rank(std::span<const Vector<3, Integer>>(rows)) == 1);
    rows.push_back({1, 1, 1});
    CHECK(rank(std::span<const Vector<3, Integer>>(rows)) == 2);
    rows.push_back({1, 1, 2});
    rows.push_back({5, 1, 2});
    CHECK(rank(std::span<const Vector<3, Integer>>(rows)) == 3);
}

TEST_CASE("echelon: elimination grows no number beyond a product of two minors") {
    Matrix<6, 6, counting::Number> m;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) m(i, j) = counting::Number((i * 37 + j * 101 + i * j * j * 53) % 1021 - 510);
    }
    counting::counts() = {};
    const int r = row_echelon(m).rank();
    CHECK(r == 6);
    // 5 x 5 minors of 9-bit entries are below 48 * 2^45 < 2^51 (Hadamard), their products and sums of two below 2^103.
    CHECK(counting::counts().largest_bits <= 103);
    CHECK(counting::counts().products == 2 * (25 + 16 + 9 + 4 + 1));
    CHECK(counting::counts().divisions == 16 + 9 + 4 + 1);
}
