// SPDX-License-Identifier: Apache-2.0
/// Exact numbers from text and as text: decimals, `p/q`, and decimals with a given number of correctly rounded digits.
///
///     number  = part [ "/" part ]                    "22/7", "-1.25e-3", "+.5", "1e300", "1.5/4"
///     part    = [ "+" | "-" ] digits [ exponent ]    digits: at least one, with at most one "." among or beside them
///     exponent = ( "e" | "E" ) [ "+" | "-" ] digits
///
/// Nothing else is a number: no spaces, no names, no hexadecimal. Text that is not a number throws NumberError with the
/// text in the message.
#ifndef CLEAVE_NUMBER_TEXT_HPP
#define CLEAVE_NUMBER_TEXT_HPP

#include <cleave/base/contract.hpp>
#include <cleave/base/error.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/traits.hpp>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// The largest exponent, up or down, of a decimal read exactly. A few characters of text can name a number that no
/// memory holds; up to this limit it takes 42 kilobytes.
inline constexpr std::int64_t max_decimal_exponent = 100'000;

namespace detail {

[[noreturn]] inline void refuse_text(std::string_view text, const char* reason) {
    std::string shown(text.substr(0, 80));
    if (shown.size() < text.size()) shown += "...";
    throw NumberError("not a number: '" + shown + "' (" + reason + ")");
}

/// base^exponent by repeated squaring.
[[nodiscard]] inline Integer power(std::uint64_t base, std::uint64_t exponent) {
    Integer result(1);
    Integer square(base);
    while (true) {
        if ((exponent & 1) != 0) result *= square;
        exponent >>= 1;
        if (exponent == 0) return result;
        square *= square;
    }
}

/// 10^exponent.
[[nodiscard]] inline Integer power_of_ten(std::uint64_t exponent) {
    return power(5, exponent) << static_cast<std::size_t>(exponent);
}

/// mantissa * 10^exponent.
struct DecimalParts {
    Integer mantissa;
    std::int64_t exponent = 0;
};

/// Reads a `part` of the grammar above; `text` is quoted in errors.
[[nodiscard]] inline DecimalParts parse_decimal(std::string_view part, std::string_view text) {
    const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
    std::size_t i = 0;
    std::string digits;
    if (i < part.size() && (part[i] == '+' || part[i] == '-')) {
        if (part[i] == '-') digits += '-';
        ++i;
    }
    const std::size_t sign_length = digits.size();
    std::int64_t exponent = 0;
    bool after_point = false;
    for (; i < part.size(); ++i) {
        if (is_digit(part[i])) {
            digits += part[i];
            if (after_point) --exponent;
        } else if (part[i] == '.' && !after_point) {
            after_point = true;
        } else {
            break;
        }
    }
    if (digits.size() == sign_length) refuse_text(text, "digits are missing");
    if (i < part.size() && (part[i] == 'e' || part[i] == 'E')) {
        ++i;
        const bool negative = i < part.size() && part[i] == '-';
        if (i < part.size() && (part[i] == '+' || part[i] == '-')) ++i;
        if (i == part.size() || !is_digit(part[i])) refuse_text(text, "the exponent has no digits");
        std::int64_t written = 0;
        for (; i < part.size() && is_digit(part[i]); ++i) {
            written = written * 10 + (part[i] - '0');
            if (written > max_decimal_exponent) refuse_text(text, "its exponent is beyond 100000");
        }
        exponent += negative ? -written : written;
    }
    if (i != part.size()) refuse_text(text, "it has a character that no number has");
    return {Integer::from_string(digits), exponent};
}

/// The value of a `number` of the grammar above as numerator and positive or negative denominator, not reduced.
[[nodiscard]] inline Fraction parse_unreduced(std::string_view text) {
    const std::size_t slash = text.find('/');
    DecimalParts above = parse_decimal(text.substr(0, slash), text);
    Fraction r;
    r.num = std::move(above.mantissa);
    std::int64_t exponent = above.exponent;
    if (slash != std::string_view::npos) {
        DecimalParts below = parse_decimal(text.substr(slash + 1), text);
        if (below.mantissa.is_zero()) refuse_text(text, "its denominator is zero");
        r.den = std::move(below.mantissa);
        exponent -= below.exponent;
    }
    if (exponent > 0) r.num *= power_of_ten(static_cast<std::uint64_t>(exponent));
    if (exponent < 0) r.den *= power_of_ten(static_cast<std::uint64_t>(-exponent));
    return r;
}

/// The n with 10^(n-1) <= value < 10^n of an unsigned `part` of the grammar. Requires: its value is not zero.
[[nodiscard]] inline std::int64_t decimal_magnitude(std::string_view part) {
    const std::size_t e = part.find_first_of("eE");
    const std::string_view digits = part.substr(0, e);
    const auto point =
        static_cast<std::int64_t>(digits.find('.') == std::string_view::npos ? digits.size() : digits.find('.'));
    const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
    std::int64_t exponent = 0;
    if (e != std::string_view::npos) {
        std::string_view written = part.substr(e + 1);
        const bool negative = written.starts_with('-');
        if (negative || written.starts_with('+')) written.remove_prefix(1);
        const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), exponent);
        // More than any text has digits, and not so much that sums overflow.
        constexpr std::int64_t far = std::int64_t(1) << 61;
        if (error == std::errc::result_out_of_range || exponent > far) exponent = far;
        if (negative) exponent = -exponent;
    }
    // Digits before the point count from it; zeros behind it count against it.
    return exponent + (first < point ? point - first : point + 1 - first);
}

}  // namespace detail

/// The number that `text` spells, exactly. Throws: NumberError, also for an exponent beyond `max_decimal_exponent`.
[[nodiscard]] inline Fraction parse_fraction(std::string_view text) {
    Fraction r = detail::parse_unreduced(text);
    return make_fraction(std::move(r.num), std::move(r.den));
}

/// The number that `text` spells, exactly. Throws: NumberError as `parse_fraction`, and where N cannot hold the value.
template <ExactRing N>
[[nodiscard]] N parse_number(std::string_view text) {
    if constexpr (number_traits<N>::is_field) {
        const Fraction x = detail::parse_unreduced(text);
        return number_traits<N>::from_fraction(x.num, x.den);
    } else {
        const Fraction x = parse_fraction(text);
        if (!x.den.is_one()) detail::refuse_text(text, "it is a fraction where an integer is needed");
        return number_traits<N>::from_integer(x.num);
    }
}

/// The double nearest to the number that `text` spells, ties to even; without a "/" any exponent may be written.
/// What rounds to zero is +0.
/// Throws: NumberError where the text is no number or rounds to an infinity.
[[nodiscard]] inline double parse_double(std::string_view text) {
    double value = 0;
    if (text.find('/') != std::string_view::npos) {
        const Fraction x = detail::parse_unreduced(text);
        value = ratio_to_double(x.num, x.den);
    } else {
        std::string_view digits = text;
        if (digits.starts_with('+') || digits.starts_with('-')) digits.remove_prefix(1);
        const bool numeric = !digits.empty() && (digits[0] == '.' || ('0' <= digits[0] && digits[0] <= '9'));
        const std::from_chars_result r = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (!numeric || r.ec == std::errc::invalid_argument || r.ptr != digits.data() + digits.size()) {
            static_cast<void>(detail::parse_decimal(text, text));  // knows what is wrong
            detail::refuse_text(text, "it is not a decimal");
        }
        // The standard does not say which end of the range was passed, and a value there is far from 1 either way.
        if (r.ec == std::errc::result_out_of_range)
            value = detail::decimal_magnitude(digits) > 0 ? std::numeric_limits<double>::infinity() : 0.0;
        if (text.starts_with('-') && value != 0.0) value = -value;
    }
    if (std::isinf(value)) detail::refuse_text(text, "it is larger than any double");
    return value;
}

/// The exact value: "p/q" in lowest terms, or "p" for an integer. Cost: quadratic in the digits, faster with GMP.
template <ExactRing N>
[[nodiscard]] std::string to_text(const N& x) {
    if constexpr (requires { number_traits<N>::to_text(x); }) {
        return number_traits<N>::to_text(x);
    } else {
        const Fraction f = number_traits<N>::to_fraction(x);
        return f.den.is_one() ? f.num.to_string() : f.num.to_string() + "/" + f.den.to_string();
    }
}

/// "p/q" in lowest terms, or "p".
[[nodiscard]] inline std::string to_text(const Fraction& x) {
    return x.den.is_one() ? x.num.to_string() : x.num.to_string() + "/" + x.den.to_string();
}

/// The exact value as a decimal without exponent ("-0.00125"), or nullopt where no finite decimal is exact.
/// As many digits as the value has: a double may have a thousand.
[[nodiscard]] inline std::optional<std::string> to_exact_decimal(const Fraction& x) {
    // Finite decimals are the fractions with a denominator 2^twos 5^fives.
    const std::size_t twos = x.den.trailing_zeros();
    const Integer odd = x.den >> twos;
    // 5^fives has 1 + floor(fives log2(5)) bits; the estimate is at most one too low.
    auto fives = static_cast<std::size_t>(static_cast<double>(odd.bit_length() - 1) / 2.321928094887363);
    Integer power = detail::power(5, fives);
    if (power < odd) {
        power *= Integer(5);
        ++fives;
    }
    if (!(power == odd)) return std::nullopt;
    const std::size_t places = twos > fives ? twos : fives;
    Integer scaled = abs(x.num) << (places - twos);
    scaled *= detail::power(5, places - fives);
    std::string digits = scaled.to_string();
    if (places != 0) {
        if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
        digits.insert(digits.size() - places, 1, '.');
    }
    return x.num.sign() == Sign::minus ? "-" + digits : digits;
}

/// The exact value as a decimal without exponent, or nullopt where no finite decimal is exact.
template <ExactRing N>
[[nodiscard]] std::optional<std::string> to_exact_decimal(const N& x) {
    return to_exact_decimal(number_traits<N>::to_fraction(x));
}

namespace detail {

/// d.ddd * 10^exponent, the digits without their point.
struct RoundedDecimal {
    std::string digits;
    std::int64_t exponent = 0;

    friend bool operator==(const RoundedDecimal& a, const RoundedDecimal& b) {
        return a.exponent == b.exponent && a.digits == b.digits;
    }
};

/// num / den to `digits` significant digits, ties to even. Requires: both are positive; no common factor need be gone.
[[nodiscard]] inline RoundedDecimal round_exactly(const Integer& num, const Integer& den, std::size_t digits) {
    const Integer limit = power_of_ten(digits);
    const Integer least = power_of_ten(digits - 1);
    // num / den lies strictly between 2^(b - 1) and 2^(b + 1), so the first guess is off by at most one.
    const double b = static_cast<double>(num.bit_length()) - static_cast<double>(den.bit_length());
    auto exponent = static_cast<std::int64_t>(std::floor(b * 0.30102999566398120));
    while (true) {
        const std::int64_t shift = static_cast<std::int64_t>(digits) - 1 - exponent;
        const Integer power = power_of_ten(static_cast<std::uint64_t>(shift < 0 ? -shift : shift));
        const Integer scaled_num = shift > 0 ? num * power : num;
        const Integer scaled_den = shift < 0 ? den * power : den;
        IntegerDivision<Integer::inline_limbs> d = divide(scaled_num, scaled_den);
        if (d.quotient >= limit) {
            ++exponent;
        } else if (d.quotient < least) {
            --exponent;
        } else {
            d.remainder <<= 1;
            if (d.remainder > scaled_den || (d.remainder == scaled_den && d.quotient.is_odd())) d.quotient += 1;
            if (d.quotient == limit) {
                d.quotient = least;
                ++exponent;
            }
            return {d.quotient.to_string(), exponent};
        }
    }
}

/// The same, from leading bits where these decide: a measure can have millions of bits, its first digits need few.
[[nodiscard]] inline RoundedDecimal round_decimal(const Integer& num, const Integer& den, std::size_t digits) {
    const std::size_t n = num.bit_length();
    const std::size_t m = den.bit_length();
    const std::size_t kept = 4 * digits + 128;
    const std::size_t offset = n > m ? n - m : m - n;
    if (n > kept && m > kept && n + m > 4 * (kept + offset)) {
        const auto leading = [kept](const Integer& x) { return x >> (x.bit_length() - kept); };
        Integer num_low = leading(num);
        Integer den_low = leading(den);
        Integer num_high = num_low + Integer(1);
        Integer den_high = den_low + Integer(1);
        for (Integer* x : {&num_low, &num_high}) *x <<= n > m ? offset : 0;
        for (Integer* x : {&den_low, &den_high}) *x <<= n > m ? 0 : offset;
        // Rounding is monotone: where both ends of an enclosure round alike, so does everything between them.
        RoundedDecimal low = round_exactly(num_low, den_high, digits);
        if (low == round_exactly(num_high, den_low, digits)) return low;
    }
    return round_exactly(num, den, digits);
}

}  // namespace detail

/// The value rounded to `digits` significant digits, ties to even: exactly that many digits are written, but for zero,
/// which is "0". Without an exponent where that needs at most six zeros behind the point and none in front of it
/// ("0.00125", "1230"), else as "1.23e45".
/// Requires: digits > 0. Cost: for huge numbers, that of their leading bits, unless a rounding boundary is near.
[[nodiscard]] inline std::string to_decimal(const Fraction& x, int digits) {
    CLEAVE_REQUIRES(digits > 0);
    if (x.num.is_zero()) return "0";
    const auto count = static_cast<std::size_t>(digits);
    detail::RoundedDecimal r = detail::round_decimal(abs(x.num), x.den, count);
    std::string& text = r.digits;
    if (r.exponent >= -7 && r.exponent < 0) {
        text.insert(0, static_cast<std::size_t>(-r.exponent), '0');
        text.insert(1, 1, '.');
    } else if (r.exponent >= 0 && r.exponent < digits) {
        const auto point = static_cast<std::size_t>(r.exponent) + 1;
        if (point < count) text.insert(point, 1, '.');
    } else {
        if (count > 1) text.insert(1, 1, '.');
        text += 'e';
        text += std::to_string(r.exponent);
    }
    return x.num.sign() == Sign::minus ? "-" + text : text;
}

/// The value rounded to `digits` significant digits; see above.
template <ExactRing N>
[[nodiscard]] std::string to_decimal(const N& x, int digits) {
    return to_decimal(number_traits<N>::to_fraction(x), digits);
}

CLEAVE_END_NAMESPACE

#endif
