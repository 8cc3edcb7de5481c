// SPDX-License-Identifier: Apache-2.0
/// The exact measure where it can be written in few digits; a proof, and little work, where it cannot.
#ifndef CLEAVE_QUERY_MEASURE_FRACTION_HPP
#define CLEAVE_QUERY_MEASURE_FRACTION_HPP

#include <cleave/number/traits.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/query/residue_system.hpp>
#include <cleave/region/region.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A sum of fractions that is worked out exactly only if it has few digits.
///
/// The denominators of many terms multiply up, so an exact sum of ten thousand can have millions of digits. Whether it
/// has at most m is decided by its residues modulo 62-bit primes, as many as it takes for their product to exceed
/// 2 * 10^m: a sum p/q of at most m digits has |p| q < 10^m, and must then be among the few fractions with that residue
/// (see ResidueSystem).
class ShortSum {
public:
    /// Adds numerator / denominator. Requires: the denominator is not zero; a common factor is allowed.
    void add(const Integer& numerator, const Integer& denominator) {
        // Denominators 2^k and 3 2^k stay what they are, and need no second thought.
        if (denominator.bit_length() - denominator.trailing_zeros() <= 2) {
            simple_.add(numerator, denominator);
            return;
        }
        terms_.push_back({numerator, denominator});
        bits_ += denominator.bit_length();
    }

    /// The sum in lowest terms, or nullopt: it has more than `max_digits` digits, numerator and denominator together.
    /// Cost: an exact sum where denominators have `exact_bits` in all or less; beyond, one pass over the terms for each
    /// 18 digits, and an exact sum only if it turns out to be short.
    [[nodiscard]] std::optional<Fraction> value(std::size_t max_digits, std::size_t exact_bits = 1U << 18U) const {
        if (bits_ > exact_bits && !may_be_short(max_digits)) return std::nullopt;
        FractionSum sum;
        for (const Term& t : terms_) sum.add(t.numerator, t.denominator);
        const Fraction total = number_traits<Rational>::to_fraction(Rational(sum.total() + simple_.total()));
        if (digit_count(total.num, total.den) > max_digits) return std::nullopt;
        return total;
    }

    /// False is a proof that the sum has more than `max_digits` digits. True by chance is as good as impossible: two
    /// primes more than needed are used.
    [[nodiscard]] bool may_be_short(std::size_t max_digits) const {
        const Fraction simple = number_traits<Rational>::to_fraction(simple_.total());
        const std::size_t bits = max_digits * 10 / 3 + 2;  // 10/3 > log2(10)
        ResidueSystem system;
        PrimeFields primes;
        while (system.modulus().bit_length() <= bits + 2 * 62) {
            const PrimeField field = primes.next();
            const std::optional<std::uint64_t> residue = sum_modulo(field, simple);
            if (residue) system.add(field, *residue);
        }
        return system.may_be_fraction(
            [&](const Integer& p, const Integer& q) { return digit_count(p, q) <= max_digits; });
    }

private:
    struct Term {
        Integer numerator;
        Integer denominator;
    };

    /// nullopt where the prime divides a denominator.
    [[nodiscard]] std::optional<std::uint64_t> sum_modulo(const PrimeField& field, const Fraction& simple) const {
        // One inversion for all: sum up to a/b step by step.
        std::uint64_t a = field.residue(simple.num);
        std::uint64_t b = field.residue(simple.den);
        for (const Term& t : terms_) {
            const std::uint64_t d = field.residue(t.denominator);
            a = field.add(field.multiply(a, d), field.multiply(field.residue(t.numerator), b));
            b = field.multiply(b, d);
        }
        if (b == 0) return std::nullopt;
        return field.multiply(a, field.inverse(b));
    }

    FractionSum simple_;
    std::vector<Term> terms_;
    std::size_t bits_ = 0;
};

/// The exact measure if it has at most `max_digits` digits, numerator and denominator together. nullopt: it has more,
/// which is certain, or it is infinite. Empty: 0.
/// Cost: see ShortSum; a second or so for a result with a hundred thousand constructed points and 2,000 digits.
template <int D, class N>
[[nodiscard]] std::optional<Fraction> measure_fraction(const Region<D, N>& region, std::size_t max_digits) {
    if (!region.is_bounded()) return std::nullopt;
    Kernel<D> kernel;
    const LoadedBoundary<D> loaded = load(region.boundary(), kernel);
    ShortSum sum;
    measure_terms<D>(kernel, region.boundary(), loaded,
                     [&](const Integer& num, const Integer& den) { sum.add(num, den); });
    return sum.value(max_digits);
}

CLEAVE_END_NAMESPACE

#endif
