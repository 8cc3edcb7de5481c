// SPDX-License-Identifier: Apache-2.0
#include <cleave/number/text.hpp>

#include "support/backends.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"

#include <array>
#include <cfloat>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace cleave;
using support::property;

namespace {

Integer ten_to(int exponent) {
    Integer r = 1;
    for (int i = 0; i < exponent; ++i) r *= Integer(10);
    return r;
}

/// value - text, where the text is a decimal.
Fraction difference(const Fraction& value, const std::string& text) {
    const Fraction x = parse_fraction(text);
    return make_fraction(value.num * x.den - x.num * value.den, value.den * x.den);
}

/// The decimal digits of the mantissa of a decimal, from the first one that is not zero.
std::string significant_digits(std::string_view text) {
    std::string digits;
    for (const char c : text.substr(0, text.find('e'))) {
        if ('0' <= c && c <= '9' && !(digits.empty() && c == '0')) digits += c;
    }
    return digits;
}

/// Whether `text` is `value` rounded to `digits` significant digits, ties to even: from the definition.
bool is_rounded(const Fraction& value, const std::string& text, int digits) {
    if (value.num.is_zero()) return text == "0";
    const std::string mantissa = significant_digits(text);
    if (mantissa.size() != static_cast<std::size_t>(digits)) return false;
    // The unit of the last digit: text = mantissa * unit.
    const Fraction shown = parse_fraction(text);
    const Integer m = Integer::from_string(mantissa);
    const Fraction unit = make_fraction(abs(shown.num), shown.den * m);
    // |value - text| against unit / 2.
    const Fraction error = difference(value, text);
    const Integer left = abs(error.num) * unit.den * Integer(2);
    const Integer right = unit.num * error.den;
    // Below a power of ten the unit is ten times smaller.
    if (m == ten_to(digits - 1) && error.num.sign() != Sign::zero && error.num.sign() != shown.num.sign())
        return left * Integer(10) <= right;
    return left < right || (left == right && !m.is_odd());
}

template <class N>
void check_round_trip() {
    using T = number_traits<N>;
    const Fraction f = T::is_field ? generators::draw_fraction() : Fraction{generators::draw_integer(), 1};
    const N x = generators::from_value<N>(f);
    RC_ASSERT(to_text(x) == to_text(f));
    RC_ASSERT(parse_number<N>(to_text(x)) == x);
    if (const std::optional<std::string> decimal = to_exact_decimal(x)) RC_ASSERT(parse_number<N>(*decimal) == x);
    RC_ASSERT(is_rounded(f, to_decimal(x, 5), 5));
}

std::string message_of(std::string_view text) {
    try {
        static_cast<void>(parse_fraction(text));
    } catch (const NumberError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("text: what is written is read back", "", backends::Numbers) {
    property("as p/q, as a finite decimal, and rounded", [] { check_round_trip<TestType>(); });
}

TEST_CASE("text: decimals and fractions are read exactly") {
    using Case = std::pair<const char*, Fraction>;
    const std::vector<Case> cases{
        {"0", {0, 1}},     {"-0", {0, 1}},     {"7", {7, 1}},     {"+7", {7, 1}},           {"-7", {-7, 1}},
        {"007", {7, 1}},   {"5.", {5, 1}},     {"+.5", {1, 2}},   {"-0.125", {-1, 8}},      {"-1.25e-3", {-1, 800}},
        {"1E2", {100, 1}}, {"1e+2", {100, 1}}, {"2.50", {5, 2}},  {"22/7", {22, 7}},        {"6/-4", {-3, 2}},
        {"-6/-4", {3, 2}}, {"1.5/4", {3, 8}},  {"3/0.5", {6, 1}}, {"1e2/1e-2", {10000, 1}}, {"0e5", {0, 1}},
        {"0.1", {1, 10}},  {"12/18", {2, 3}},  {"0/5", {0, 1}},
    };
    for (const Case& c : cases) {
        INFO(c.first);
        CHECK(parse_fraction(c.first) == c.second);
        CHECK(parse_number<Rational>(c.first) == generators::from_value<Rational>(c.second));
        CHECK(parse_double(c.first) == ratio_to_double(c.second.num, c.second.den));
    }
    CHECK(parse_fraction("1e300").num == ten_to(300));
    CHECK(parse_number<Integer>("25e-1/0.5") == 5);
}

TEST_CASE("text: what is no number is refused and quoted") {
    for (const char* text : {"",      ".",   "+",   "-",     "-.",   "e5",    "1e",    "1e+", "1e5.", "--1", "+-1",
                             "1.2.3", "1 ",  " 1",  "1,5",   "0x10", "inf",   "-inf",  "nan", "1/",   "/1",  "1//2",
                             "1/2/3", "1/0", "0/0", "1/0e7", "five", "1e5e5", "1_000", "1/-", "1f"}) {
        INFO(text);
        CHECK(message_of(text).find("'" + std::string(text) + "'") != std::string::npos);
        CHECK_THROWS_AS(parse_double(text), NumberError);
        CHECK_THROWS_AS(parse_number<Rational>(text), NumberError);
    }
    CHECK_THROWS_AS(parse_number<Integer>("1/2"), NumberError);
    CHECK_THROWS_AS(parse_number<FixedInt<64>>("9223372036854775808"), NumberError);
    CHECK(message_of(std::string(1000, 'x')).size() < 200);
}

TEST_CASE("text: an absurd exponent is refused before it is computed") {
    for (const char* text :
         {"1e999999999", "1e-999999999", "1/1e999999999", "1e100001", "0e100001", "1e99999999999999999999"}) {
        INFO(text);
        CHECK(message_of(text).find("exponent") != std::string::npos);
    }
    CHECK(parse_fraction("1e100000").num.bit_length() == 332193);
    CHECK(parse_fraction("1e-100000").den.bit_length() == 332193);
    CHECK(parse_double("1e-99999999999999999999") == 0.0);
    CHECK_THROWS_AS(parse_double("1e99999999999999999999"), NumberError);
}

TEST_CASE("text: a decimal becomes the nearest double, ties to even") {
    CHECK(parse_double("0.1") == 0.1);
    CHECK(parse_double("-2.5e-3") == -2.5e-3);
    CHECK(parse_double("1/3") == 1.0 / 3.0);
    // 2^53 + 1 lies between two doubles; a digit far behind the point decides.
    CHECK(parse_double("9007199254740993") == 9007199254740992.0);
    CHECK(parse_double("9007199254740993." + std::string(500, '0') + "1") == 9007199254740994.0);
    CHECK(parse_double("9007199254740995") == 9007199254740996.0);
    // The least subnormal and its half, which goes to even: to zero.
    CHECK(parse_double("4.9406564584124654e-324") == std::numeric_limits<double>::denorm_min());
    CHECK(parse_double("2.4703282292062327e-324") == 0.0);
    CHECK(parse_double("2.4703282292062328e-324") == std::numeric_limits<double>::denorm_min());
    CHECK(!std::signbit(parse_double("-1e-400")));
    CHECK(!std::signbit(parse_double("-0")));
    CHECK(parse_double("1.7976931348623157e308") == DBL_MAX);
    CHECK(parse_double("1.7976931348623158e308") == DBL_MAX);  // below the largest number plus half its last unit
    CHECK_THROWS_AS(parse_double("1.7976931348623159e308"), NumberError);
    CHECK_THROWS_AS(parse_double("-1e309/1"), NumberError);
    // The exponent alone does not tell on which side of the range a number is.
    const std::string zeros(400, '0');
    CHECK(parse_double("0." + zeros + "1e50") == 0.0);
    CHECK(parse_double("0." + zeros + "1e401") == 1.0);
    CHECK(parse_double("1" + zeros + "e-400") == 1.0);
    CHECK(parse_double("0." + zeros + "1") == 0.0);
    CHECK_THROWS_AS(parse_double("1" + zeros + "e-5"), NumberError);
    CHECK_THROWS_AS(parse_double("1" + zeros), NumberError);

    property("as the exact value rounded once", [] {
        const Integer mantissa = generators::draw_wide_integer(2);
        const int exponent = support::draw_int(-345, 300);
        std::string text = mantissa.to_string();
        text.insert(text.size() - 1, ".");
        text += "e" + std::to_string(exponent);
        const Fraction exact = parse_fraction(text);
        const double expected = ratio_to_double(exact.num, exact.den);
        RC_PRE(std::isfinite(expected));
        RC_ASSERT(parse_double(text) == expected);
    });
}

TEST_CASE("text: a fraction is a finite decimal iff its denominator has no primes but 2 and 5") {
    const auto exact = [](int num, int den) { return to_exact_decimal(make_fraction(num, den)).value_or("none"); };
    CHECK(exact(0, 1) == "0");
    CHECK(exact(-12, 1) == "-12");
    CHECK(exact(1, 8) == "0.125");
    CHECK(exact(-1, 800) == "-0.00125");
    CHECK(exact(7, 5) == "1.4");
    CHECK(exact(1, 3125) == "0.00032");
    CHECK(exact(100, 1) == "100");
    CHECK(exact(1, 3) == "none");
    CHECK(exact(1, 6) == "none");
    CHECK(exact(1, 15625 * 7) == "none");
    CHECK(to_exact_decimal(Rational(0.1)) == "0.1000000000000000055511151231257827021181583404541015625");
    const Fraction least = number_traits<Rational>::to_fraction(Rational(std::numeric_limits<double>::denorm_min()));
    CHECK(to_exact_decimal(least).value().size() == 1076);
    // Each power of five, and its neighbours: the count of fives is found, not guessed.
    Integer power = 1;
    for (int fives = 0; fives <= 200; ++fives) {
        const std::optional<std::string> decimal = to_exact_decimal(Fraction{1, power});
        REQUIRE(decimal.has_value());
        REQUIRE(parse_fraction(*decimal) == Fraction{1, power});
        REQUIRE(!to_exact_decimal(Fraction{1, power + Integer(2)}).has_value());
        power *= Integer(5);
    }
}

TEST_CASE("text: a value is rounded to significant digits, ties to even") {
    const auto rounded = [](const char* text, int digits) { return to_decimal(parse_fraction(text), digits); };
    CHECK(rounded("0", 40) == "0");
    CHECK(rounded("22/7", 40) == "3.142857142857142857142857142857142857143");
    CHECK(rounded("-1/3", 5) == "-0.33333");
    CHECK(rounded("2/3", 1) == "0.7");
    CHECK(rounded("0.125", 2) == "0.12");
    CHECK(rounded("0.135", 2) == "0.14");
    CHECK(rounded("0.1250000001", 2) == "0.13");
    CHECK(rounded("9.995", 3) == "10.0");
    CHECK(rounded("9.985", 3) == "9.98");
    CHECK(rounded("99.96", 3) == "100");
    CHECK(rounded("999.6", 3) == "1.00e3");
    CHECK(rounded("1234", 4) == "1234");
    CHECK(rounded("1234", 6) == "1234.00");
    CHECK(rounded("12345", 4) == "1.234e4");
    CHECK(rounded("12345", 1) == "1e4");
    CHECK(rounded("1e300", 3) == "1.00e300");
    CHECK(rounded("1.5e-7", 2) == "0.00000015");
    CHECK(rounded("1.5e-8", 2) == "1.5e-8");
    CHECK(rounded("9.99e-8", 1) == "0.0000001");

    property("by the definition", [] {
        const Fraction x = generators::draw_fraction();
        const int digits = support::draw_int(1, 45);
        RC_ASSERT(is_rounded(x, to_decimal(x, digits), digits));
    });
}

TEST_CASE("text: huge fractions are rounded from their leading bits, and exactly where these do not decide") {
    // A numerator and denominator of 100,000 bits, coprime or not, whose quotient is q or just beside it.
    const Integer huge = (Integer(1) << 100'000) - Integer(1);
    const auto text = [&huge](const char* quotient, int nudge, int digits) {
        const Fraction q = parse_fraction(quotient);
        const Fraction x{q.num * huge + Integer(nudge), q.den * huge};
        return to_decimal(x, digits);
    };
    CHECK(text("22/7", 0, 20) == "3.1428571428571428571");
    CHECK(text("22/7", 1, 20) == "3.1428571428571428571");
    // Ties, and one part in 2^100000 above and below them.
    CHECK(text("0.125", 0, 2) == "0.12");
    CHECK(text("0.125", 1, 2) == "0.13");
    CHECK(text("0.125", -1, 2) == "0.12");
    CHECK(text("0.135", 0, 2) == "0.14");
    CHECK(text("0.135", -1, 2) == "0.13");
    // Powers of ten, and just below them.
    CHECK(text("1000", 0, 5) == "1000.0");
    CHECK(text("1000", -1, 5) == "1000.0");
    CHECK(text("999.995", -1, 5) == "999.99");
    CHECK(text("999.995", 1, 5) == "1000.0");
    // A quotient far from one.
    CHECK(text("3e-40", 1, 3) == "3.00e-40");
    CHECK(text("7/3e500", -1, 10) == "2.333333333e-500");
    property("as the quotient of small ones", [huge] {
        const Fraction x = generators::draw_fraction();
        RC_PRE(x.num.sign() != Sign::zero);
        const int digits = support::draw_int(1, 20);
        RC_ASSERT(to_decimal(Fraction{x.num * huge, x.den * huge}, digits) == to_decimal(x, digits));
    });
}
