// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/traits.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"

#include <cleave/algebra/product.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

using namespace cleave;
using support::property;

namespace {

using AllNumbers = backends::Join<backends::Numbers, std::tuple<WideInteger, BasicInteger<2>>>;

/// A value that every number can hold once: an integer for rings.
template <class N>
Fraction draw_wide() {
    const Integer num = generators::draw_wide_integer(20);
    if (!number_traits<N>::is_field) return {num, 1};
    const Integer den = generators::draw_wide_integer(20);
    return make_fraction(num, den.is_zero() ? Integer(1) : den);
}

template <class N>
void check_fractions() {
    using T = number_traits<N>;
    const Fraction f = draw_wide<N>();
    const N x = generators::from_value<N>(f);
    RC_ASSERT(T::to_fraction(x) == f);
    RC_ASSERT(T::sign(x) == f.num.sign());
    RC_ASSERT(sign_of(x) == f.num.sign());
    RC_ASSERT(T::bit_length(x) ==
              (T::is_field ? std::max(f.num.bit_length(), f.den.bit_length()) : f.num.bit_length()));

    const Fraction g = draw_wide<N>();
    const N y = generators::from_value<N>(g);
    // a/b against c/d is a d against c b.
    const Integer left = f.num * g.den;
    const Integer right = g.num * f.den;
    RC_ASSERT(bool(x == y) == (left == right));
    RC_ASSERT(bool(x < y) == (left < right));
    const N difference = x - y;
    RC_ASSERT(T::sign(difference) == Integer(left - right).sign());
    RC_ASSERT(T::to_fraction(difference) == make_fraction(left - right, f.den * g.den));
    RC_ASSERT(convert_number<N>(convert_number<Rational>(x)) == x);
}

/// Values small enough for the products of three to fit a fixed width.
template <class N>
void check_products() {
    using T = number_traits<N>;
    const N a = generators::number<N>();
    const N b = generators::number<N>();
    const N c = generators::number<N>();
    const N ab = a * b;
    const N sum = ab + c;
    const N difference = c - ab;
    N r = c;
    add_product(r, a, b);
    RC_ASSERT(r == sum);
    r = c;
    sub_product(r, a, b);
    RC_ASSERT(r == difference);
    RC_ASSERT(product<N>(a, b) == ab);
    if (T::sign(b) != Sign::zero) {
        const N quotient = T::exact_divide(ab, b);
        RC_ASSERT(quotient == a);
    }

    // A common divisor, the greatest, and not negative.
    const N g = T::gcd(a, b);
    const Fraction x = T::to_fraction(a);
    const Fraction y = T::to_fraction(b);
    RC_ASSERT(T::sign(g) == (x.num.is_zero() && y.num.is_zero() ? Sign::zero : Sign::plus));
    RC_ASSERT(T::gcd(b, a) == g);
    if (T::sign(g) == Sign::zero) return;
    const Fraction p = T::to_fraction(T::exact_divide(a, g));
    const Fraction q = T::to_fraction(T::exact_divide(b, g));
    RC_ASSERT(p.den.is_one());
    RC_ASSERT(q.den.is_one());
    RC_ASSERT(gcd(p.num, q.num).is_one());
}

template <class N>
void check_doubles() {
    using T = number_traits<N>;
    const double drawn = generators::draw_finite_double();
    const double x = T::is_field ? drawn : std::trunc(drawn);
    const N exact = T::from_double(x);
    RC_ASSERT(to_double(exact) == x);
    RC_ASSERT(T::enclosure(exact).lower() == x);
    RC_ASSERT(T::enclosure(exact).upper() == x);

    const Fraction f = draw_wide<N>();
    const N value = generators::from_value<N>(f);
    RC_ASSERT(T::to_double(value) == ratio_to_double(f.num, f.den));
    const double below = ratio_to_double(f.num, f.den, Rounding::down);
    const double above = ratio_to_double(f.num, f.den, Rounding::up);
    RC_ASSERT(T::to_double(value, Rounding::down) == below);
    RC_ASSERT(T::to_double(value, Rounding::up) == above);
    const Interval enclosure = T::enclosure(value);
    if (std::isfinite(below) && std::isfinite(above)) {
        RC_ASSERT(enclosure.lower() == below);
        RC_ASSERT(enclosure.upper() == above);
    } else {
        RC_ASSERT(enclosure.is_whole());
    }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("traits: values go in and out as fractions, compare and subtract as these do", "", AllNumbers) {
    property("wide numbers", [] { check_fractions<TestType>(); });
}

TEMPLATE_LIST_TEST_CASE("traits: products, exact quotients and greatest common divisors fit together", "", AllNumbers) {
    property("small numbers mostly", [] { check_products<TestType>(); });
}

TEMPLATE_LIST_TEST_CASE("traits: doubles come in exactly and go out correctly rounded in every direction", "",
                        AllNumbers) {
    property("any finite double, any value", [] { check_doubles<TestType>(); });
}

TEMPLATE_LIST_TEST_CASE("traits: what is no number of the type is refused", "", AllNumbers) {
    using T = number_traits<TestType>;
    CHECK_THROWS_AS(T::from_double(std::numeric_limits<double>::infinity()), NumberError);
    CHECK_THROWS_AS(T::from_double(std::numeric_limits<double>::quiet_NaN()), NumberError);
    CHECK_THROWS_AS(T::from_fraction(1, 0), NumberError);
    if constexpr (T::is_field) {
        CHECK(T::to_fraction(T::from_double(-0.75)) == Fraction{-3, 4});
    } else {
        CHECK_THROWS_AS(T::from_double(0.5), NumberError);
        CHECK_THROWS_AS(convert_number<TestType>(number_traits<Rational>::from_fraction(1, 3)), NumberError);
    }
}

TEMPLATE_LIST_TEST_CASE("traits: a fraction in any terms becomes the same value in lowest ones", "", AllNumbers) {
    using T = number_traits<TestType>;
    using F = number_traits<typename T::field_type>;
    CHECK(F::to_fraction(T::from_fraction(2, 4)) == Fraction{1, 2});
    CHECK(F::to_fraction(T::from_fraction(6, -4)) == Fraction{-3, 2});
    CHECK(F::to_fraction(T::from_fraction(0, -4)) == Fraction{0, 1});
    CHECK(bool(T::from_fraction(-3, -9) == T::from_fraction(1, 3)));
    CHECK(ExactField<typename T::field_type>);
}

TEST_CASE("traits: any number converts to any other that can hold it") {
    const Rational third = number_traits<Rational>::from_fraction(1, 3);
    CHECK(convert_number<archetype::Field>(third).value() == third);
    CHECK(convert_number<Integer>(Rational(12)) == 12);
    CHECK(convert_number<FixedInt<128>>(Integer(-5)).to_string() == "-5");
    CHECK_THROWS_AS(convert_number<FixedInt<64>>(Integer(Integer(1) << 64)), NumberError);
    CHECK_THROWS_AS(convert_number<Integer>(third), NumberError);
}

TEST_CASE("traits: a fraction is made in lowest terms with a positive denominator") {
    CHECK(make_fraction(6, -9) == Fraction{-2, 3});
    CHECK(make_fraction(0, -9) == Fraction{0, 1});
    CHECK(make_fraction(-5, -1) == Fraction{5, 1});
    CHECK_THROWS_AS(make_fraction(1, 0), NumberError);
}
