// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/determinant.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/counting.hpp"
#include "support/generators.hpp"

#include <array>
#include <utility>

using namespace cleave;
using support::property;

namespace {

template <int D, class N>
void check_laws() {
    using M = Matrix<D, D, N>;
    const M a = generators::matrix<D, D, N>();
    const M b = generators::matrix<D, D, N>();
    const N det_a = determinant(a);
    RC_ASSERT(det_a == determinant_laplace(a));
    RC_ASSERT(det_a == determinant_bareiss(a));
    RC_ASSERT(det_a == determinant(transpose(a)));
    RC_ASSERT((number_traits<N>::sign(det_a) == Sign::zero) == (rank(a) < D));

    const N det_b = determinant(b);
    const N expected = det_a * det_b;
    RC_ASSERT(determinant(multiply(a, b)) == expected);

    const N factor = generators::number<N>();
    M scaled = a;
    scaled.row[0] = scale(factor, a.row[0]);
    const N scaled_det = factor * det_a;
    RC_ASSERT(determinant(scaled) == scaled_det);

    if constexpr (D > 1) {
        M swapped = a;
        std::swap(swapped.row[0], swapped.row[D - 1]);
        const N negated = -det_a;
        RC_ASSERT(determinant(swapped) == negated);
        M sheared = a;
        sheared.row[1] = add(a.row[1], scale(factor, a.row[0]));
        RC_ASSERT(determinant(sheared) == det_a);
    }
}

template <int D>
counting::Counts counts_of_determinant() {
    Matrix<D, D, counting::Number> m;
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) m(i, j) = counting::Number(1 + i * i + j * (i + 2));
    }
    counting::counts() = {};
    static_cast<void>(determinant(m));
    return counting::counts();
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("determinant: three forms agree; it multiplies, alternates and is linear in a row", "",
                        backends::Numbers) {
    property("D = 3", [] { check_laws<3, TestType>(); });
}

TEST_CASE("determinant: the same in other dimensions") {
    property("D = 1", [] { check_laws<1, Integer>(); });
    property("D = 2", [] { check_laws<2, Integer>(); });
    property("D = 4", [] { check_laws<4, Integer>(); });
    property("D = 4, fractions", [] { check_laws<4, Rational>(); });
    property("D = 5", [] { check_laws<5, Integer>(); });
    property("D = 5, fractions", [] { check_laws<5, Rational>(); });
    property("D = 7", [] { check_laws<7, Integer>(); });
}

TEMPLATE_LIST_TEST_CASE("determinant: of the identity is one, of powers the product of differences", "",
                        backends::Numbers) {
    using N = TestType;
    CHECK(determinant(identity_matrix<1, N>()) == N(1));
    CHECK(determinant(identity_matrix<4, N>()) == N(1));
    CHECK(determinant(identity_matrix<8, N>()) == N(1));
    // Vandermonde's matrix of -1, 2, 3, 5, -4.
    const std::array<int, 5> nodes{-1, 2, 3, 5, -4};
    Matrix<5, 5, N> m;
    for (int i = 0; i < 5; ++i) {
        m(i, 0) = N(1);
        for (int j = 1; j < 5; ++j) m(i, j) = m(i, j - 1) * N(nodes[static_cast<std::size_t>(i)]);
    }
    CHECK(determinant(m) == N(3 * 4 * 6 * -3 * 1 * 3 * -6 * 2 * -7 * -9));
}

TEST_CASE("determinant: the documented numbers of products are right") {
    CHECK(counts_of_determinant<2>().products == 2);
    CHECK(counts_of_determinant<3>().products == 9);
    CHECK(counts_of_determinant<4>().products == 28);
    CHECK(counts_of_determinant<6>().divisions == 0);
    CHECK(counts_of_determinant<7>().divisions != 0);
}
