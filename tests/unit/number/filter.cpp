// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/double.hpp>
#include <cleave/number/filter.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <array>
#include <cmath>
#include <limits>

using namespace cleave;

namespace {

template <std::size_t D>
Sign exact_sign(const std::array<mpq_class, D>& n, const mpq_class& c, const std::array<mpq_class, D>& x) {
    mpq_class sum = c;
    for (std::size_t i = 0; i < D; ++i) sum += n[i] * x[i];
    return sign_of_value(sgn(sum));
}

/// Random planes and points near them; every answer of the filter is compared with the exact sign.
template <std::size_t D>
void check_linear_form(std::uint64_t seed) {
    oracle::Numbers numbers(seed);
    std::size_t certain = 0;
    std::size_t abstained = 0;
    for (std::size_t i = 0; i < scaled(10000); ++i) {
        std::array<mpq_class, D> n;
        std::array<mpq_class, D> x;
        std::array<double, D> near_n{};
        std::array<double, D> near_x{};
        double error = 0;
        const std::size_t scale = numbers.below(90);
        mpq_class rest = 0;
        for (std::size_t k = 0; k < D; ++k) {
            const mpz_class coefficient = numbers.of_bits(numbers.below(160));
            n[k] = coefficient;
            near_n[k] = to_double(oracle::from_mpz<6>(coefficient));
            x[k] = mpq_class(numbers.of_bits(numbers.below(80)), oracle::power_of_two(scale));
            x[k].canonicalize();
            near_x[k] = x[k].get_d();  // truncated
            mpq_class off = abs(x[k] - mpq_class(near_x[k]));
            error = std::max(error, std::nextafter(off.get_d(), 1e300));
            rest += n[k] * x[k];
        }
        // An offset that leaves about nothing, a little, or anything.
        mpz_class offset(-rest);
        if (i % 4 == 1) offset += numbers.number(1);
        if (i % 4 == 2) offset += numbers.number(3);
        if (i % 4 == 3) offset += mpz_class(offset >> (numbers.below(120)));
        const double near_c = to_double(oracle::from_mpz<6>(offset));
        const auto sign = linear_form_sign<D>(near_n, near_c, near_x, error);
        if (!sign) {
            ++abstained;
            continue;
        }
        ++certain;
        REQUIRE(*sign == exact_sign<D>(n, offset, x));
    }
    // Both outcomes must be exercised, or the test shows nothing.
    CHECK(certain > scaled(10000) / 10);
    CHECK(abstained > scaled(10000) / 10);
}

}  // namespace

TEST_CASE("filter: the approximate answer is used where there is one") {
    const auto never = []() -> Sign { throw std::logic_error("the exact path was taken"); };
    CHECK(filtered_sign([] { return std::optional(Sign::minus); }, never) == Sign::minus);
}

TEST_CASE("filter: a filter that abstains leaves the decision to the exact answer") {
    int exact_calls = 0;
    const auto abstain = [] { return std::optional<Sign>(); };
    for (const Sign s : {Sign::minus, Sign::zero, Sign::plus}) {
        CHECK(filtered_sign(abstain, [&] {
                  ++exact_calls;
                  return s;
              }) == s);
    }
    CHECK(exact_calls == 3);
}

TEST_CASE("filter: without counting, counts stay zero") {
    static_cast<void>(filtered_sign([] { return std::optional<Sign>(); }, [] { return Sign::zero; }));
    CHECK(filter_counts().calls == 0);
    CHECK(filter_counts().failures == 0);
}

TEST_CASE("filter: a linear form's sign is right or absent") {
    check_linear_form<1>(21);
    check_linear_form<2>(22);
    check_linear_form<3>(23);
    check_linear_form<6>(24);
}

TEST_CASE("filter: a linear form that is exactly zero makes the filter abstain") {
    CHECK(linear_form_sign<2>({1.0, 1.0}, -3.0, {1.0, 2.0}, 0.0) == std::nullopt);
    CHECK(linear_form_sign<2>({0.0, 0.0}, 0.0, {1.0, 2.0}, 0.0) == std::nullopt);
}

TEST_CASE("filter: a linear form's point error is honoured") {
    CHECK(linear_form_sign<1>({1.0}, -1.0, {1.5}, 0.0) == Sign::plus);
    CHECK(linear_form_sign<1>({1.0}, -1.0, {0.5}, 0.25) == Sign::minus);
    CHECK(linear_form_sign<1>({1.0}, -1.0, {1.5}, 0.5) == std::nullopt);
}

TEST_CASE("filter: overflow, underflow and NaN make a linear form abstain") {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(linear_form_sign<1>({1e300}, 0.0, {1e300}, 0.0) == std::nullopt);
    CHECK(linear_form_sign<2>({1e300, -1e300}, 1.0, {1e300, 1e300}, 0.0) == std::nullopt);
    CHECK(linear_form_sign<1>({infinity}, 0.0, {1.0}, 0.0) == std::nullopt);
    CHECK(linear_form_sign<1>({infinity}, 0.0, {0.0}, 0.0) == std::nullopt);
    CHECK(linear_form_sign<1>({1.0}, nan, {1.0}, 0.0) == std::nullopt);
    CHECK(linear_form_sign<1>({1.0}, 1.0, {nan}, 0.0) == std::nullopt);
    CHECK(linear_form_sign<1>({1.0}, 1.0, {1.0}, infinity) == std::nullopt);
    CHECK(linear_form_sign<1>({1.0}, 1.0, {1.0}, nan) == std::nullopt);
    CHECK(linear_form_sign<1>({0x1p-600}, 0.0, {0x1p-500}, 0.0) == std::nullopt);
    CHECK(linear_form_sign<1>({0x1p-300}, 0.0, {0x1p-500}, 0.0) == Sign::plus);
}
