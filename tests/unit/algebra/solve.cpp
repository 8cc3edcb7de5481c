// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/solve.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"

using namespace cleave;
using support::property;

namespace {

template <int D, class N>
void check_solution() {
    const Matrix<D, D, N> m = generators::matrix<D, D, N>();
    const Vector<D, N> b = generators::vector<D, N>();
    const auto solution = solve(m, b);
    const N det = determinant(m);
    RC_ASSERT(solution.has_value() == (number_traits<N>::sign(det) != Sign::zero));
    if (!solution) return;
    RC_ASSERT(number_traits<N>::sign(solution->denominator) == Sign::plus);
    RC_ASSERT(multiply(m, solution->numerator) == scale(solution->denominator, b));
    const N magnitude = number_traits<N>::sign(det) == Sign::plus ? N(det) : N(-det);
    RC_ASSERT(solution->denominator == magnitude);
}

template <int D, class N>
void check_adjugate() {
    const Matrix<D, D, N> m = generators::matrix<D, D, N>();
    const Matrix<D, D, N> inverse = adjugate(m);
    Matrix<D, D, N> expected = identity_matrix<D, N>();
    for (int i = 0; i < D; ++i) expected(i, i) = determinant(m);
    RC_ASSERT(multiply(m, inverse) == expected);
    RC_ASSERT(multiply(inverse, m) == expected);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("solve: Cramer's rule satisfies the system, and there is no answer iff it is singular", "",
                        backends::Numbers) {
    property("D = 3", [] { check_solution<3, TestType>(); });
}

TEMPLATE_LIST_TEST_CASE("solve: a matrix times its adjugate is its determinant", "", backends::Numbers) {
    property("D = 3", [] { check_adjugate<3, TestType>(); });
}

TEST_CASE("solve: the same in other dimensions") {
    property("solution, D = 2", [] { check_solution<2, Integer>(); });
    property("solution, D = 1", [] { check_solution<1, Integer>(); });
    property("solution, D = 4", [] { check_solution<4, Integer>(); });
    property("solution, D = 7", [] { check_solution<7, Integer>(); });
    property("adjugate, D = 2", [] { check_adjugate<2, Integer>(); });
    property("adjugate, D = 1", [] { check_adjugate<1, Integer>(); });
    property("adjugate, D = 4", [] { check_adjugate<4, Integer>(); });
    property("adjugate, D = 5", [] { check_adjugate<5, Integer>(); });
}

TEST_CASE("solve: two lines meet where they should, parallel ones nowhere") {
    // 2 x + y = 5 and x - 3 y = -8 meet in (1, 3).
    const auto p = solve(Matrix<2, 2, Integer>{{{{2, 1}, {1, -3}}}}, Vector<2, Integer>{5, -8});
    REQUIRE(p.has_value());
    CHECK(p->numerator == Vector<2, Integer>{7, 21});
    CHECK(p->denominator == 7);
    CHECK(!solve(Matrix<2, 2, Integer>{{{{2, 1}, {4, 2}}}}, Vector<2, Integer>{5, 10}).has_value());
}
