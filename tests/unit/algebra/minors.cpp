// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/minors.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/counting.hpp"
#include "support/generators.hpp"

#include <cleave/algebra/determinant.hpp>

#include <array>

using namespace cleave;
using support::property;

namespace {

/// `row` above the rows of m.
template <int D, class N>
Matrix<D + 1, D + 1, N> with_row_on_top(const Vector<D + 1, N>& row, const Matrix<D, D + 1, N>& m) {
    Matrix<D + 1, D + 1, N> r;
    r.row[0] = row;
    for (int i = 0; i < D; ++i) r.row[static_cast<std::size_t>(i) + 1] = m.row[static_cast<std::size_t>(i)];
    return r;
}

template <int D, class N>
void check_laws() {
    const auto m = generators::matrix<D, D + 1, N>();
    const auto r = generators::vector<D + 1, N>();
    const Vector<D + 1, N> v = minors(m);
    RC_ASSERT(v == minors_laplace(m));
    RC_ASSERT(v == minors_bareiss(m));
    RC_ASSERT(is_zero(multiply(m, v)));
    RC_ASSERT(dot(r, v) == determinant_laplace(with_row_on_top(r, m)));
    RC_ASSERT(is_zero(v) == (rank(m) < D));
}

template <int D>
counting::Counts counts_of_minors() {
    Matrix<D, D + 1, counting::Number> m;
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j <= D; ++j) m(i, j) = counting::Number(1 + i * i + j * (i + 2));
    }
    counting::counts() = {};
    static_cast<void>(minors(m));
    return counting::counts();
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("minors: unrolled, Laplace and Bareiss agree, and mean what they say", "", backends::Numbers) {
    property("D = 3", [] { check_laws<3, TestType>(); });
}

TEST_CASE("minors: the same in other dimensions") {
    property("D = 1", [] { check_laws<1, Integer>(); });
    property("D = 2", [] { check_laws<2, Integer>(); });
    property("D = 4", [] { check_laws<4, Integer>(); });
    property("D = 4, fractions", [] { check_laws<4, Rational>(); });
    property("D = 5", [] { check_laws<5, Integer>(); });
    property("D = 5, fractions", [] { check_laws<5, Rational>(); });
    property("D = 6, the last without division", [] { check_laws<6, FixedInt<2048>>(); });
    property("D = 7", [] { check_laws<7, Integer>(); });
}

TEST_CASE("minors: of two rows it is the cross product, of one row the row turned") {
    const Vector<3, Integer> x{1, 0, 0};
    const Vector<3, Integer> y{0, 1, 0};
    CHECK(minors(rows_of(x, y)) == Vector<3, Integer>{0, 0, 1});
    CHECK(minors(rows_of(y, x)) == Vector<3, Integer>{0, 0, -1});
    CHECK(minors(Matrix<1, 2, Integer>{{{{3, 5}}}}) == Vector<2, Integer>{5, -3});
}

TEST_CASE("minors: of three points it is the plane through them, of three planes the point on them") {
    // Points (x w, y w, z w, w) of the plane x + 2 y + 3 z = 6.
    const Vector<4, Integer> a{6, 0, 0, 1};
    const Vector<4, Integer> b{0, 6, 0, 2};
    const Vector<4, Integer> c{0, 0, 2, 1};
    const Vector<4, Integer> plane = minors(rows_of(a, b, c));
    CHECK(proportionality(plane, Vector<4, Integer>{1, 2, 3, -6}) == Sign::plus);
    // Planes x = 1/2, y = 2/3, z = -5.
    const Vector<4, Integer> point = minors(
        rows_of(Vector<4, Integer>{2, 0, 0, -1}, Vector<4, Integer>{0, 3, 0, -2}, Vector<4, Integer>{0, 0, 1, 5}));
    CHECK(proportionality(point, Vector<4, Integer>{3, 4, -30, 6}) == Sign::minus);
}

TEST_CASE("minors: entries of one type are evaluated in a wider one") {
    Vector<4, FixedInt<64>> a{};
    Vector<4, FixedInt<64>> b{};
    Vector<4, FixedInt<64>> c{};
    const FixedInt<64> large = (std::int64_t(1) << 62) + 1;
    a[0] = b[1] = c[2] = large;
    a[3] = b[3] = c[3] = 1;
    const Vector<4, FixedInt<256>> v = minors<FixedInt<256>>(rows_of(a, b, c));
    const FixedInt<256> square = FixedInt<256>(large) * FixedInt<256>(large);
    CHECK(v == Vector<4, FixedInt<256>>{square, square, square, -(square * FixedInt<256>(large))});
    CHECK_THROWS_AS(minors(rows_of(a, b, c)), NumberError);

    const auto to_wide = [](const Vector<4, FixedInt<64>>& x) {
        return Vector<4, Integer>{Integer(x[0].to_integer()), Integer(x[1].to_integer()), Integer(x[2].to_integer()),
                                  Integer(x[3].to_integer())};
    };
    const Vector<4, WideInteger> w = minors<WideInteger>(rows_of(to_wide(a), to_wide(b), to_wide(c)));
    for (std::size_t i = 0; i < 4; ++i) CHECK(w[i] == v[i].to_integer());
}

TEST_CASE("minors: the documented numbers of products are right, and nothing is divided") {
    const std::array<counting::Counts, 5> counts{counts_of_minors<1>(), counts_of_minors<2>(), counts_of_minors<3>(),
                                                 counts_of_minors<4>(), counts_of_minors<5>()};
    CHECK(counts[0].products == 0);
    CHECK(counts[1].products == 6);
    CHECK(counts[2].products == 24);
    CHECK(counts[3].products == 70);
    for (const counting::Counts& c : counts) CHECK(c.divisions == 0);
    for (std::size_t i = 0; i < 4; ++i) CHECK(counts[i].copies <= 1);  // D = 1 copies an entry
}
