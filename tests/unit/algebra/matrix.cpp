// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/matrix.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"

using namespace cleave;
using support::property;

namespace {

template <class N>
void check_laws() {
    const Matrix<2, 3, N> a = generators::matrix<2, 3, N>();
    const Matrix<3, 4, N> b = generators::matrix<3, 4, N>();
    const Matrix<4, 2, N> c = generators::matrix<4, 2, N>();
    const Vector<4, N> v = generators::vector<4, N>();
    RC_ASSERT(multiply(multiply(a, b), c) == multiply(a, multiply(b, c)));
    RC_ASSERT(transpose(multiply(a, b)) == multiply(transpose(b), transpose(a)));
    RC_ASSERT(multiply(multiply(a, b), v) == multiply(a, multiply(b, v)));
    RC_ASSERT(multiply(a, identity_matrix<3, N>()) == a);
    RC_ASSERT(to_matrix(rows_of(a.row[0], a.row[1])) == a);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("matrix: products associate and transpose; a view of rows is the matrix of them", "",
                        backends::Numbers) {
    property("2 x 3, 3 x 4, 4 x 2", [] { check_laws<TestType>(); });
}

TEST_CASE("matrix: entries are read by row and column, and a view follows its rows") {
    Matrix<2, 3, Integer> m{{{{1, 2, 3}, {4, 5, 6}}}};
    CHECK(m(0, 2) == 3);
    CHECK(m(1, 0) == 4);
    const auto view = rows_of(m.row[1], m.row[0]);
    m(1, 0) = 7;
    CHECK(view(0, 0) == 7);
    CHECK(view(1, 0) == 1);
    CHECK(transpose(m)(0, 1) == 7);
}
