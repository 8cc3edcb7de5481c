// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/fixed_int_determinant.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

using namespace cleave;

namespace {

using Row = std::array<mpz_class, 4>;
using Rows = std::array<Row, 4>;

/// By cofactors of the first row, so that it shares nothing with what it checks.
mpz_class determinant(const Rows& a) {
    const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) {
        return mpz_class(a[1][i] * (a[2][j] * a[3][k] - a[2][k] * a[3][j]) -
                         a[1][j] * (a[2][i] * a[3][k] - a[2][k] * a[3][i]) +
                         a[1][k] * (a[2][i] * a[3][j] - a[2][j] * a[3][i]));
    };
    return a[0][0] * minor(1, 2, 3) - a[0][1] * minor(0, 2, 3) + a[0][2] * minor(0, 1, 3) - a[0][3] * minor(0, 1, 2);
}

/// The number of comparisons; ten million where CLEAVE_LONG_TESTS is set.
std::size_t comparisons() {
    const char* text = std::getenv("CLEAVE_LONG_TESTS");
    return text == nullptr || *text == '\0' ? scaled(100'000) : 10'000'000;
}

template <unsigned NormalBits, unsigned OffsetBits>
struct Check {
    using Determinant = PlaneDeterminant<NormalBits, OffsetBits>;
    std::size_t compared = 0;
    std::size_t zeros = 0;
    std::size_t wrong = 0;

    void compare(const Rows& rows) {
        std::array<typename Determinant::Plane, 4> planes;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 3; ++j)
                planes[i].normal[j] = typename Determinant::Normal(oracle::from_mpz<6>(rows[i][j]));
            planes[i].offset = typename Determinant::Offset(oracle::from_mpz<6>(rows[i][3]));
        }
        const Sign exact = oracle::sign(determinant(rows));
        ++compared;
        if (exact == Sign::zero) ++zeros;
        if (Determinant::sign(planes) != exact) ++wrong;
    }
};

/// A plane through three points with coordinates below 2^b in absolute value.
Row plane_through(const std::array<std::array<mpz_class, 3>, 3>& p) {
    std::array<mpz_class, 3> u;
    std::array<mpz_class, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
        u[i] = p[1][i] - p[0][i];
        v[i] = p[2][i] - p[0][i];
    }
    Row r;
    r[0] = u[1] * v[2] - u[2] * v[1];
    r[1] = u[2] * v[0] - u[0] * v[2];
    r[2] = u[0] * v[1] - u[1] * v[0];
    r[3] = -(r[0] * p[0][0] + r[1] * p[0][1] + r[2] * p[0][2]);
    return r;
}

std::array<mpz_class, 3> point(oracle::Numbers& numbers, std::size_t bits) {
    std::array<mpz_class, 3> p;
    for (mpz_class& x : p) x = numbers.of_bits(numbers.below(bits + 1));
    return p;
}

/// Planes through grid points: four random ones, three that share a point with the fourth moved by little or nothing,
/// and linear combinations. b is the grid's bits.
Rows planes(oracle::Numbers& numbers, std::size_t b, std::size_t kind) {
    Rows rows;
    if (kind % 4 == 0) {
        for (Row& r : rows) r = plane_through({point(numbers, b), point(numbers, b), point(numbers, b)});
        return rows;
    }
    // All four through one point: the determinant is zero. Then the last one is moved by a unit, in one place.
    const auto common = point(numbers, b);
    for (Row& r : rows) r = plane_through({common, point(numbers, b), point(numbers, b)});
    if (kind % 4 == 2) rows[3][3] += numbers.below(2) == 0 ? 1 : -1;
    if (kind % 4 == 3) rows[3][numbers.below(3)] += numbers.below(2) == 0 ? 1 : -1;
    return rows;
}

}  // namespace

TEST_CASE("fixed_int_determinant: signs agree with GMP on random and nearly degenerate planes") {
    // One call in three by width: 256 bits (grid of 27 bits), 1039 bits (114), and a narrow one.
    oracle::Numbers numbers(31);
    Check<56, 83> grid27;
    Check<230, 344> grid114;
    Check<26, 38> grid12;
    const std::size_t count = comparisons();
    for (std::size_t i = 0; i < count; ++i) {
        switch (i % 3) {
            case 0:
                grid27.compare(planes(numbers, 27, i / 3));
                break;
            case 1:
                grid114.compare(planes(numbers, 114, i / 3));
                break;
            default:
                grid12.compare(planes(numbers, 12, i / 3));
                break;
        }
    }
    const std::size_t compared = grid27.compared + grid114.compared + grid12.compared;
    const std::size_t zeros = grid27.zeros + grid114.zeros + grid12.zeros;
    std::printf("determinants compared with GMP: %zu (%zu zero), wrong signs: %zu\n", compared, zeros,
                grid27.wrong + grid114.wrong + grid12.wrong);
    CHECK(compared == count);
    CHECK(zeros > count / 8);
    CHECK(zeros < count / 2);
    CHECK(grid27.wrong == 0);
    CHECK(grid114.wrong == 0);
    CHECK(grid12.wrong == 0);
}

TEST_CASE("fixed_int_determinant: the largest determinants that the bounds allow") {
    // Hadamard's matrix of order 4 times the largest entries, with every choice of row signs.
    const int hadamard[4][4] = {{1, 1, 1, 1}, {1, -1, 1, -1}, {1, 1, -1, -1}, {1, -1, -1, 1}};
    const mpz_class n = oracle::power_of_two(56) - 1;
    const mpz_class c = oracle::power_of_two(83) - 1;
    for (unsigned signs = 0; signs < 16; ++signs) {
        Rows rows;
        std::array<PlaneDeterminant<56, 83>::Plane, 4> planes;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                rows[i][j] = (j < 3 ? n : c) * hadamard[i][j] * ((signs >> i & 1) != 0 ? -1 : 1);
                if (j < 3)
                    planes[i].normal[j] = FixedDigits<56>(oracle::from_mpz<6>(rows[i][j]));
                else
                    planes[i].offset = FixedDigits<83>(oracle::from_mpz<6>(rows[i][j]));
            }
        }
        const mpz_class exact = determinant(rows);
        CHECK(abs(exact) == 16 * n * n * n * c);
        CHECK(oracle::to_mpz(PlaneDeterminant<56, 83>::determinant(planes).to_fixed().to_integer()) == exact);
        CHECK(PlaneDeterminant<56, 83>::sign(planes) == oracle::sign(exact));
    }
}

TEST_CASE("fixed_int_determinant: an entry beyond its bound is refused when the plane is made") {
    CHECK_THROWS_AS(FixedDigits<56>(Integer::scaled(1, 56)), NumberError);
    CHECK_THROWS_AS(FixedDigits<83>(Integer::scaled(-1, 300)), NumberError);
    CHECK_NOTHROW(FixedDigits<56>(Integer::scaled(1, 56) - 1));
}
