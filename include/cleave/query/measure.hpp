// SPDX-License-Identifier: Apache-2.0
/// Length, area and volume, exactly: as a fraction, as digits, or as a residue.
///
/// The exact value of a volume can have millions of digits. `measure` gives it all the same; `measure_digits` gives
/// correctly rounded leading digits and `measure_modulo` a residue for comparing exact values cheaply.
#ifndef CLEAVE_QUERY_MEASURE_HPP
#define CLEAVE_QUERY_MEASURE_HPP

#include <cleave/number/text.hpp>
#include <cleave/query/measure_terms.hpp>
#include <cleave/region/region.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Sums fractions pairwise from the leaves of a balanced tree, so that denominators grow as late as possible.
class FractionSum {
public:
    void add(const Integer& numerator, const Integer& denominator) {
        // Like a binary counter: level i holds the sum of 2^i terms, or nothing.
        Rational carry = number_traits<Rational>::from_fraction(numerator, denominator);
        for (std::size_t level = 0;; ++level) {
            if (level == levels_.size()) levels_.emplace_back();
            if (!levels_[level]) {
                levels_[level] = std::move(carry);
                return;
            }
            carry += *levels_[level];
            levels_[level].reset();
        }
    }

    [[nodiscard]] Rational total() const {
        Rational sum(0);
        for (const std::optional<Rational>& level : levels_)
            if (level) sum += *level;
        return sum;
    }

private:
    std::vector<std::optional<Rational>> levels_;
};

/// The exact D-dimensional measure in units^D: length, area, volume. nullopt: infinite. Empty: 0.
/// Cost: exact fractions whose denominators are products of all constructed points' weights; seconds for a result with
/// ten thousand of them. See `measure_digits` and `measure_modulo`.
template <int D, class N>
[[nodiscard]] std::optional<typename number_traits<N>::field_type> measure(const Region<D, N>& region) {
    if (!region.is_bounded()) return std::nullopt;
    Kernel<D> kernel;
    const LoadedBoundary<D> loaded = load(region.boundary(), kernel);
    FractionSum sum;
    measure_terms<D>(kernel, region.boundary(), loaded,
                     [&](const Integer& num, const Integer& den) { sum.add(num, den); });
    using Field = typename number_traits<N>::field_type;
    if constexpr (std::is_same_v<Field, Rational>)
        return sum.total();
    else
        return convert_number<Field>(sum.total());
}

/// The exact measure modulo a prime, by default 2^61-1. nullopt: infinite, or the prime divides the denominator.
/// Cost: linear, a few microseconds per boundary edge.
template <std::uint64_t P = first_prime, int D, class N>
[[nodiscard]] std::optional<Modular<P>> measure_modulo(const Region<D, N>& region) {
    if (!region.is_bounded()) return std::nullopt;
    Kernel<D> kernel;
    const LoadedBoundary<D> loaded = load(region.boundary(), kernel);
    std::vector<Modular<P>> numerators;
    std::vector<Modular<P>> denominators;
    bool divisible = false;
    measure_terms<D>(kernel, region.boundary(), loaded, [&](const Integer& num, const Integer& den) {
        numerators.emplace_back(num);
        denominators.emplace_back(den);
        if (!denominators.back().is_zero()) return;
        const Integer g = gcd(num, den);
        numerators.back() = Modular<P>(exact_divide(num, g));
        denominators.back() = Modular<P>(exact_divide(den, g));
        divisible = divisible || denominators.back().is_zero();
    });
    if (divisible) {
        const auto exact = measure(Region<D, Rational>(region));
        const Fraction f = number_traits<Rational>::to_fraction(*exact);
        const Modular<P> d(f.den);
        if (d.is_zero()) return std::nullopt;
        return Modular<P>(f.num) / d;
    }
    invert_all(std::span<Modular<P>>(denominators));
    Modular<P> sum(0);
    for (std::size_t i = 0; i < numerators.size(); ++i) sum += numerators[i] * denominators[i];
    return sum;
}

/// The measure correctly rounded to `digits` significant digits, as text. nullopt: infinite. Zero is "0".
/// Cost: one division per boundary edge at a few hundred bits; exact arithmetic only where digits cannot decide.
template <int D, class N>
[[nodiscard]] std::optional<std::string> measure_digits(const Region<D, N>& region, int digits) {
    if (!region.is_bounded()) return std::nullopt;
    if (region.is_empty()) return "0";
    Kernel<D> kernel;
    const LoadedBoundary<D> loaded = load(region.boundary(), kernel);
    // Fixed point: each term is rounded down to a multiple of 2^-places, so the sum of n terms is short by less than n
    // of them. The same digits at both ends of that interval are the digits.
    const auto wanted = std::size_t(4 * digits + 64);
    for (std::int64_t places = std::int64_t(wanted); places < 100000; places *= 2) {
        Integer sum;
        std::int64_t terms = 0;
        measure_terms<D>(kernel, region.boundary(), loaded, [&](const Integer& num, const Integer& den) {
            IntegerDivision<Integer::inline_limbs> d = divide(num << std::size_t(places), den);
            // `divide` truncates toward zero: step down where that was up.
            const bool up = !d.remainder.is_zero() && (num.sign() != den.sign());
            sum += d.quotient;
            if (up) sum -= 1;
            ++terms;
        });
        if (sum.bit_length() < wanted) continue;
        const Integer unit = Integer::scaled(1, std::size_t(places));
        const std::string low = to_decimal(make_fraction(sum, unit), digits);
        if (low == to_decimal(make_fraction(sum + Integer(terms), unit), digits)) return low;
    }
    return to_decimal(*measure(Region<D, Rational>(region)), digits);
}

CLEAVE_END_NAMESPACE

#endif
