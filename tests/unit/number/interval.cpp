// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/interval.hpp>

#include "support/catch.hpp"
#include "unit/number/oracle.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

using namespace cleave;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

bool encloses(const Interval& i, const mpq_class& q) {
    return i.is_whole() || (mpq_class(i.lower()) <= q && q <= mpq_class(i.upper()));
}

/// A finite double: small integers, neighbours of them, subnormals, huge ones, noise.
double finite(oracle::Numbers& numbers) {
    for (;;) {
        double x = 0;
        switch (numbers.below(6)) {
            case 0:
                x = static_cast<double>(numbers.below(9)) - 4.0;
                break;
            case 1:
                x = std::nextafter(static_cast<double>(numbers.below(9)) - 4.0, infinity);
                break;
            case 2:
                x = std::bit_cast<double>(numbers.word() & 0x800f'ffff'ffff'ffffU);
                break;
            case 3:
                x = std::bit_cast<double>(numbers.word() | 0x7fc0'0000'0000'0000U);
                break;
            case 4:
                x = static_cast<double>(static_cast<std::int64_t>(numbers.word())) * 0x1p-60;
                break;
            default:
                x = std::bit_cast<double>(numbers.word());
        }
        if (std::isfinite(x)) return x;
    }
}

Interval interval(oracle::Numbers& numbers) {
    const double a = finite(numbers);
    const double b = numbers.below(3) == 0 ? a : finite(numbers);
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace

TEST_CASE("interval: neighbours are those of nextafter") {
    for (const double x : {0.0, -0.0, 1.0, -1.0, least, -least, largest, -largest, 0x1p-1022, -0x1p-1022, 0.1}) {
        CHECK(next_above(x) == std::nextafter(x, infinity));
        CHECK(next_below(x) == std::nextafter(x, -infinity));
    }
}

TEST_CASE("interval: every operation encloses the exact result at the corners and inside") {
    oracle::Numbers numbers(11);
    std::size_t answered = 0;
    for (std::size_t i = 0; i < scaled(20000); ++i) {
        const Interval a = interval(numbers);
        const Interval b = interval(numbers);
        const Interval sum = a + b;
        const Interval difference = a - b;
        const Interval product = a * b;
        const Interval quotient = a / b;
        if (!product.is_whole()) ++answered;
        const double inside_a = a.lower() / 2 + a.upper() / 2;
        const double inside_b = b.lower() / 2 + b.upper() / 2;
        for (const double x : {a.lower(), a.upper(), inside_a}) {
            for (const double y : {b.lower(), b.upper(), inside_b}) {
                if (!a.contains(x) || !b.contains(y)) continue;
                const mpq_class p(x);
                const mpq_class q(y);
                REQUIRE(encloses(sum, p + q));
                REQUIRE(encloses(difference, p - q));
                REQUIRE(encloses(product, p * q));
                if (q != 0) REQUIRE(encloses(quotient, p / q));
                REQUIRE(encloses(-a, -p));
            }
        }
    }
    CHECK(answered > scaled(20000) / 4);
}

TEST_CASE("interval: sums are as tight as directed rounding, so exact sums stay points") {
    CHECK(Interval(0.5) + Interval(0.25) == Interval(0.75));
    CHECK(Interval(3) - Interval(3) == Interval(0));
    CHECK((Interval(3) - Interval(3)).sign() == Sign::zero);
    const Interval tenth = Interval(1.0) + Interval(0x1p-60);
    CHECK(tenth.lower() == 1.0);
    CHECK(tenth.upper() == next_above(1.0));
    CHECK(Interval(least) - Interval(least) == Interval(0));
}

TEST_CASE("interval: zero times anything finite is exactly zero") {
    CHECK((Interval(0) * Interval(-5.0, 1e300)).sign() == Sign::zero);
    CHECK((Interval(0) * Interval::whole()).is_whole());
    CHECK((Interval(0) / Interval(3.0)).sign() == Sign::zero);
}

TEST_CASE("interval: underflow never becomes a zero or a wrong sign") {
    const Interval tiny = Interval(least) * Interval(0.5);
    CHECK(tiny.lower() <= 0.0);
    CHECK(tiny.upper() >= least);
    CHECK(tiny.sign() == std::nullopt);
    CHECK((Interval(least) / Interval(3.0)).sign() == std::nullopt);
}

TEST_CASE("interval: overflow and NaN abstain, and abstention spreads") {
    const Interval big(largest);
    CHECK((big + big).is_whole());
    CHECK((-big - big).is_whole());
    CHECK((big * big).is_whole());
    CHECK((big * Interval(-2.0)).is_whole());
    CHECK((Interval(1.0) / Interval(least)).is_whole());
    CHECK((big * big - big * big).is_whole());
    CHECK((Interval::whole() + Interval(1)).is_whole());
    CHECK((Interval::whole() * Interval(-1)).is_whole());
    CHECK((Interval(1) / Interval::whole()).is_whole());
    CHECK((Interval::whole() / Interval(1)).is_whole());
    CHECK((-Interval::whole()).is_whole());
    CHECK(Interval::whole().sign() == std::nullopt);
    CHECK(Interval(std::numeric_limits<double>::quiet_NaN()).is_whole());
    CHECK(Interval(infinity).is_whole());
    CHECK(Interval(0.0, infinity).is_whole());
    CHECK_FALSE(Interval(largest).is_whole());
}

TEST_CASE("interval: division by an interval around zero abstains") {
    CHECK((Interval(1) / Interval(-1.0, 1.0)).is_whole());
    CHECK((Interval(1) / Interval(0.0, 1.0)).is_whole());
    CHECK((Interval(1) / Interval(-1.0, 0.0)).is_whole());
    CHECK((Interval(1) / Interval(0)).is_whole());
    CHECK((Interval(1) / Interval(2)).contains(0.5));
}

TEST_CASE("interval: the sign is given only where all members have it") {
    CHECK(Interval(1.0, 2.0).sign() == Sign::plus);
    CHECK(Interval(-2.0, -1.0).sign() == Sign::minus);
    CHECK(Interval(0.0, 1.0).sign() == std::nullopt);
    CHECK(Interval(-1.0, 0.0).sign() == std::nullopt);
    CHECK(Interval(-0.0, 0.0).sign() == Sign::zero);
}

TEST_CASE("interval: exact integers and ratios are enclosed by neighbouring doubles") {
    oracle::Numbers numbers(12);
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        const mpz_class num = numbers.number(5);
        mpz_class den = numbers.number(4);
        if (den == 0) den = 7;
        const Interval x = Interval::enclosing(oracle::from_mpz<6>(num));
        REQUIRE(encloses(x, mpq_class(num)));
        REQUIRE((x.is_point() || next_above(x.lower()) == x.upper()));
        mpq_class q(num, den);
        q.canonicalize();
        const Interval y = Interval::enclosing_ratio(oracle::from_mpz<6>(num), oracle::from_mpz<6>(den));
        REQUIRE(encloses(y, q));
        REQUIRE((y.is_point() || next_above(y.lower()) == y.upper()));
    }
    CHECK(Interval::enclosing(Integer(1), 1024).is_whole());
    CHECK(Interval::enclosing(Integer(5), -1) == Interval(2.5));
}

TEST_CASE("interval: a determinant written once gives the exact sign or none") {
    const auto determinant = [](const auto& a, const auto& b, const auto& c, const auto& d) { return a * d - b * c; };
    oracle::Numbers numbers(13);
    std::size_t certain = 0;
    for (std::size_t i = 0; i < scaled(5000); ++i) {
        std::array<double, 4> x{};
        for (double& v : x) v = finite(numbers);
        if (i % 3 == 0) x = {x[0], x[1], 3 * x[0], 3 * x[1]};  // nearly or exactly singular
        if (!std::isfinite(x[2]) || !std::isfinite(x[3])) continue;
        const auto approximate = determinant(Interval(x[0]), Interval(x[1]), Interval(x[2]), Interval(x[3])).sign();
        const mpq_class exact = mpq_class(x[0]) * mpq_class(x[3]) - mpq_class(x[1]) * mpq_class(x[2]);
        if (!approximate) continue;
        ++certain;
        REQUIRE(*approximate == sign_of_value(sgn(exact)));
    }
    CHECK(certain > scaled(5000) / 8);
}
