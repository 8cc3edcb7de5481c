// SPDX-License-Identifier: Apache-2.0
/// `Interval`: a pair of doubles that certainly enclose a real number.
///
/// The rounding mode is never touched. IEEE operations round to nearest, so the true result of one operation lies
/// between the neighbours of the rounded one, and stepping to a neighbour is integer arithmetic on the bit pattern:
///
///  * Sum s = fl(a + b): the error e = a + b - s is itself a double (Knuth's TwoSum computes it in additions alone,
///  also
///    for subnormal results). Where e >= 0, s is a lower end of the sum, otherwise its predecessor is; likewise above.
///    So sums are as tight as directed rounding.
///  * Product or quotient r = fl(a o b): |r - a o b| is at most half the gap to a neighbour, underflow included, so the
///    predecessor and successor of r enclose a o b. They are read from r's bit pattern, which forces r to be rounded:
///    no compiler can contract the product with what follows.
///  * An end that is infinite or NaN (overflow, or infinity minus infinity) makes the result the whole line: it
///  abstains.
#ifndef CLEAVE_NUMBER_INTERVAL_HPP
#define CLEAVE_NUMBER_INTERVAL_HPP

#include <cleave/base/contract.hpp>
#include <cleave/number/double.hpp>
#include <cleave/number/sign.hpp>

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cstdint>
#include <limits>
#include <optional>

CLEAVE_BEGIN_NAMESPACE

#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "cleave's floating-point filters need doubles that are evaluated as doubles (on x86: SSE2)"
#endif

/// The next double above x. Requires: x is finite. Returns: infinity above the largest.
[[nodiscard]] constexpr double next_above(double x) noexcept {
    const auto pattern = std::bit_cast<std::int64_t>(x);
    // As integers, positive doubles ascend and negative ones descend; both zeros step to the least subnormal.
    if (pattern >= 0) return std::bit_cast<double>(pattern + 1);
    return x == 0.0 ? std::numeric_limits<double>::denorm_min() : std::bit_cast<double>(pattern - 1);
}

/// The next double below x. Requires: x is finite. Returns: minus infinity below the least.
[[nodiscard]] constexpr double next_below(double x) noexcept {
    return -next_above(-x);
}

/// All reals from `lower()` to `upper()`: certainly among them the number it stands for. Ends are finite, except in the
/// whole line, which says nothing. A ring in form (its laws hold up to enclosure), so predicates can be written once.
class Interval {
public:
    /// Exactly zero.
    constexpr Interval() noexcept = default;

    /// Exactly this number; the whole line if it is infinite or NaN.
    constexpr Interval(double value) noexcept  // implicit: a double is a point
        : Interval(checked(value, value)) {}

    /// Exactly this number. Requires: |value| <= 2^53, or it is a double anyway.
    constexpr Interval(int value) noexcept : lower_(value), upper_(value) {}

    /// From the least to the greatest. Requires: lower <= upper. An end that is infinite or NaN gives the whole line.
    constexpr Interval(double lower, double upper) : Interval(checked(lower, upper)) {
        CLEAVE_REQUIRES(lower_ <= upper_);
    }

    /// Every real number: the answer that abstains.
    [[nodiscard]] static constexpr Interval whole() noexcept {
        Interval r;
        r.lower_ = -std::numeric_limits<double>::infinity();
        r.upper_ = std::numeric_limits<double>::infinity();
        return r;
    }

    /// The tightest interval around x * 2^exponent.
    template <unsigned K>
    [[nodiscard]] static Interval enclosing(const BasicInteger<K>& x, std::int64_t exponent = 0) noexcept {
        return checked(to_double(x, exponent, Rounding::down), to_double(x, exponent, Rounding::up));
    }

    /// The tightest interval around num / den. Throws: NumberError if den is zero.
    template <unsigned K, unsigned M>
    [[nodiscard]] static Interval enclosing_ratio(const BasicInteger<K>& num, const BasicInteger<M>& den) {
        return checked(ratio_to_double(num, den, Rounding::down), ratio_to_double(num, den, Rounding::up));
    }

    [[nodiscard]] constexpr double lower() const noexcept { return lower_; }
    [[nodiscard]] constexpr double upper() const noexcept { return upper_; }
    [[nodiscard]] constexpr bool is_point() const noexcept { return lower_ == upper_; }
    [[nodiscard]] constexpr bool is_whole() const noexcept {
        return lower_ == -std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] constexpr bool contains(double x) const noexcept { return lower_ <= x && x <= upper_; }

    /// The sign of the enclosed number, or nothing where the interval allows more than one.
    [[nodiscard]] constexpr std::optional<Sign> sign() const noexcept {
        if (lower_ > 0.0) return Sign::plus;
        if (upper_ < 0.0) return Sign::minus;
        if (lower_ == 0.0 && upper_ == 0.0) return Sign::zero;
        return std::nullopt;
    }

    constexpr Interval operator-() const noexcept {
        Interval r;
        r.lower_ = -upper_;
        r.upper_ = -lower_;
        return r;
    }
    constexpr Interval operator+() const noexcept { return *this; }

    friend constexpr Interval operator+(const Interval& a, const Interval& b) noexcept {
        return checked(sum_below(a.lower_, b.lower_), -sum_below(-a.upper_, -b.upper_));
    }
    friend constexpr Interval operator-(const Interval& a, const Interval& b) noexcept { return a + (-b); }

    friend constexpr Interval operator*(const Interval& a, const Interval& b) noexcept {
        if (a.is_exact_zero() || b.is_exact_zero())
            return a.is_whole() || b.is_whole() ? whole() : Interval();  // zero times unknown may hide an overflow
        const double p = a.lower_ * b.lower_;
        const double q = a.lower_ * b.upper_;
        const double r = a.upper_ * b.lower_;
        const double s = a.upper_ * b.upper_;
        // The extremes are taken at corners, and rounding is monotone: the least rounded corner is the rounded least.
        return widened(p, q, r, s);
    }

    /// Division by an interval that contains zero gives the whole line.
    friend constexpr Interval operator/(const Interval& a, const Interval& b) noexcept {
        if (b.lower_ <= 0.0 && b.upper_ >= 0.0) return whole();
        if (a.is_exact_zero()) return Interval();
        return widened(a.lower_ / b.lower_, a.lower_ / b.upper_, a.upper_ / b.lower_, a.upper_ / b.upper_);
    }

    constexpr Interval& operator+=(const Interval& b) noexcept { return *this = *this + b; }
    constexpr Interval& operator-=(const Interval& b) noexcept { return *this = *this - b; }
    constexpr Interval& operator*=(const Interval& b) noexcept { return *this = *this * b; }
    constexpr Interval& operator/=(const Interval& b) noexcept { return *this = *this / b; }

    /// The same ends. (Enclosed numbers can only be compared through the sign of their difference.)
    friend constexpr bool operator==(const Interval&, const Interval&) noexcept = default;

private:
    [[nodiscard]] constexpr bool is_exact_zero() const noexcept { return lower_ == 0.0 && upper_ == 0.0; }

    /// The two ends where both are finite, else the whole line. NaN fails both comparisons.
    [[nodiscard]] static constexpr Interval checked(double lower, double upper) noexcept {
        constexpr double largest = std::numeric_limits<double>::max();
        if (!(lower >= -largest && lower <= largest && upper >= -largest && upper <= largest)) return whole();
        Interval r;
        r.lower_ = lower;
        r.upper_ = upper;
        return r;
    }

    /// The largest double that is not above a + b, or something not finite.
    [[nodiscard]] static constexpr double sum_below(double a, double b) noexcept {
        const double sum = a + b;
        const double b_part = sum - a;
        const double error = (a - (sum - b_part)) + (b - b_part);
        return error < 0.0 ? next_below(sum) : (error >= 0.0 ? sum : -std::numeric_limits<double>::infinity());
    }

    [[nodiscard]] static constexpr double absolute(double x) noexcept { return x < 0.0 ? -x : x; }

    [[nodiscard]] static constexpr Interval widened(double p, double q, double r, double s) noexcept {
        // min and max drop a NaN silently, a sum of all four does not; it is infinite or NaN if any of them is.
        if (!(absolute(p) + absolute(q) + absolute(r) + absolute(s) <= std::numeric_limits<double>::max()))
            return whole();
        return checked(next_below(std::min(std::min(p, q), std::min(r, s))),
                       next_above(std::max(std::max(p, q), std::max(r, s))));
    }

    double lower_ = 0.0;
    double upper_ = 0.0;
};

CLEAVE_END_NAMESPACE

#endif
