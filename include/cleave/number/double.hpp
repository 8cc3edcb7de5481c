// SPDX-License-Identifier: Apache-2.0
/// Between binary floating-point numbers and exact integers: exact one way, correctly rounded the other.
#ifndef CLEAVE_NUMBER_DOUBLE_HPP
#define CLEAVE_NUMBER_DOUBLE_HPP

#include <cleave/number/integer.hpp>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

CLEAVE_BEGIN_NAMESPACE

/// How an exact value becomes a floating-point number: to the nearest (ties to the even mantissa), or the nearest
/// not above (`down`) or not below (`up`) it.
enum class Rounding : std::uint8_t { nearest, down, up };

/// A finite floating-point number as mantissa * 2^exponent; the mantissa is odd, or zero with exponent zero.
struct DoubleParts {
    std::int64_t mantissa;
    int exponent;
};

/// Takes a finite double apart, exactly. Throws: NumberError for an infinity or NaN.
[[nodiscard]] inline DoubleParts decompose(double x) {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>((pattern >> 52) & 0x7ff);
    std::uint64_t mantissa = pattern & ((std::uint64_t(1) << 52) - 1);
    if (biased == 0x7ff) throw NumberError("an infinity or NaN is not a number");
    if (biased != 0)
        mantissa |= std::uint64_t(1) << 52;
    else if (mantissa == 0)
        return {0, 0};
    const int zeros = std::countr_zero(mantissa);
    const auto odd = static_cast<std::int64_t>(mantissa >> zeros);
    return {(pattern >> 63) != 0 ? -odd : odd, (biased == 0 ? 1 : biased) - 1075 + zeros};
}

namespace rounding {

/// A non-negative real: (mantissa + fraction) 2^exponent, where the fraction is in [0, 1), and zero iff `exact`.
struct Magnitude {
    std::uint64_t mantissa;
    std::int64_t exponent;
    bool exact;
};

/// The layout of an IEEE binary format.
template <std::floating_point T>
struct Format {
    static_assert(std::numeric_limits<T>::is_iec559 && sizeof(T) <= 8, "float or double");
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    static constexpr int digits = std::numeric_limits<T>::digits;
    /// The exponent of the least subnormal number.
    static constexpr int least = std::numeric_limits<T>::min_exponent - digits;
};

/// Rounds a magnitude away from zero (`away`), toward zero, or to nearest-even; then puts the sign on.
/// Requires: the mantissa is below 2^digits only if the magnitude is exact.
/// A result that rounds to zero is +0; beyond the largest finite number lies an infinity, or that number where the
/// direction says toward zero.
template <std::floating_point T>
[[nodiscard]] T round(Magnitude x, bool negative, Rounding direction) noexcept {
    using Bits = typename Format<T>::Bits;
    constexpr int digits = Format<T>::digits;
    if (x.mantissa == 0 && x.exact) return T(0);
    const bool away = direction == (negative ? Rounding::down : Rounding::up);
    const bool nearest = direction == Rounding::nearest;
    // The result is a multiple of 2^quantum, `digits` bits below the leading bit, but not below the subnormal grid.
    const std::int64_t leading = x.exponent + static_cast<std::int64_t>(std::bit_width(x.mantissa));
    const std::int64_t quantum = leading - digits > Format<T>::least ? leading - digits : Format<T>::least;
    const std::int64_t drop = quantum - x.exponent;
    std::uint64_t kept = 0;
    if (drop <= 0) {
        kept = x.mantissa << -drop;  // exact, and at most `digits` bits by the choice of the quantum
    } else {
        const std::uint64_t dropped = drop >= 64 ? x.mantissa : x.mantissa & ((std::uint64_t(1) << drop) - 1);
        kept = drop >= 64 ? 0 : x.mantissa >> drop;
        bool up = false;
        if (nearest) {
            const std::uint64_t half = drop > 64 ? 0 : std::uint64_t(1) << (drop - 1);
            up = half != 0 && (dropped > half || (dropped == half && (!x.exact || (kept & 1) != 0)));
        } else {
            up = away && (dropped != 0 || !x.exact);
        }
        kept += up ? 1 : 0;
    }
    if (kept == 0) return T(0);
    // A normal number's pattern is ((exponent - least + 1) << (digits - 1)) + kept - 2^(digits - 1); for a subnormal
    // the exponent is `least` and the leading bit is absent, which the same sum expresses. A carry to 2^digits carries
    // on.
    constexpr Bits infinity = std::bit_cast<Bits>(std::numeric_limits<T>::infinity());
    const std::int64_t field = quantum - Format<T>::least;
    Bits pattern = infinity;
    if (field < (std::int64_t(1) << 12)) {
        const std::uint64_t full = (static_cast<std::uint64_t>(field) << (digits - 1)) + kept;
        if (full < infinity) pattern = static_cast<Bits>(full);
    }
    if (pattern == infinity && !nearest && !away) pattern = infinity - 1;
    const T magnitude = std::bit_cast<T>(pattern);
    return negative ? -magnitude : magnitude;
}

/// The leading 64 bits of a non-zero number, and whether they are all of it.
[[nodiscard]] inline Magnitude leading(LimbView x) noexcept {
    const std::size_t n = x.count();
    const auto shift = static_cast<unsigned>(std::countl_zero(x.limbs[n - 1]));
    Magnitude r{x.limbs[n - 1] << shift, std::int64_t(limbs::bits) * std::int64_t(n - 1) - shift, true};
    if (n == 1) return r;
    std::uint64_t rest = x.limbs[n - 2];
    if (shift != 0) {
        r.mantissa |= rest >> (limbs::bits - shift);
        rest <<= shift;
    }
    std::size_t i = n - 2;
    while (rest == 0 && i-- != 0) rest = x.limbs[i];
    r.exact = rest == 0;
    return r;
}

/// |num| / |den| as at least 63 leading bits and exactness. Requires: neither is zero.
[[nodiscard]] inline Magnitude divide_exactly(LimbView num, LimbView den) {
    const auto n = static_cast<std::int64_t>(limbs::bit_length(num.limbs, num.count()));
    const auto m = static_cast<std::int64_t>(limbs::bit_length(den.limbs, den.count()));
    const std::int64_t shift = 63 - (n - m);  // brings the quotient to 63 or 64 bits
    WideInteger a;
    WideInteger b;
    arithmetic::assign_shifted_left(a.buffer(), num.absolute(), shift > 0 ? static_cast<std::size_t>(shift) : 0);
    arithmetic::assign_shifted_left(b.buffer(), den.absolute(), shift < 0 ? static_cast<std::size_t>(-shift) : 0);
    const IntegerDivision<24> q = divide(a, b);
    return {q.quotient.view().limbs[0], -shift, q.remainder.is_zero()};
}

/// The correctly rounded quotient. Requires: den is not zero.
template <std::floating_point T>
[[nodiscard]] T ratio(LimbView num, LimbView den, Rounding direction) {
    if (num.size == 0) return T(0);
    const bool negative = num.negative() != den.negative();
    const std::size_t n = num.count();
    const std::size_t m = den.count();
    // Leading limbs first: N of two limbs, D of one. Halving N below D 2^64 makes the quotient fit one limb.
    const auto num_shift = static_cast<unsigned>(std::countl_zero(num.limbs[n - 1]));
    const auto den_shift = static_cast<unsigned>(std::countl_zero(den.limbs[m - 1]));
    const auto limb = [](LimbView x, std::size_t below_top) {
        return below_top < x.count() ? x.limbs[x.count() - 1 - below_top] : Limb(0);
    };
    const auto shifted = [](Limb high, Limb low, unsigned shift) {
        return shift == 0 ? high : (high << shift) | (low >> (limbs::bits - shift));
    };
    const Limb d = shifted(limb(den, 0), limb(den, 1), den_shift);
    UInt128 dividend = UInt128(shifted(limb(num, 0), limb(num, 1), num_shift)) << limbs::bits;
    dividend |= shifted(limb(num, 1), limb(num, 2), num_shift);
    dividend >>= 1;
    const limbs::LimbDivision q = limbs::divide_2_by_1(static_cast<Limb>(dividend >> limbs::bits),
                                                       static_cast<Limb>(dividend), d, limbs::reciprocal(d));
    // |num| = (2 N + f) 2^x and |den| = (D + g) 2^y with f in [0, 2), g in [0, 1); both quotients have exponent x - y
    // + 1.
    const std::int64_t exponent =
        (std::int64_t(n) - std::int64_t(m) - 1) * limbs::bits - num_shift + std::int64_t(den_shift) + 1;
    if (m == 1) {
        // g = 0, and f / 2 < 1 cannot lift the remainder to D: the quotient is right and only its exactness is open.
        // The bits below N are those of num beyond its first 127.
        const std::size_t below = limbs::bits * n - num_shift;
        const bool exact = q.remainder == 0 && (below <= 127 || limbs::trailing_zeros(num.limbs) >= below - 127);
        return round<T>({q.quotient, exponent, exact}, negative, direction);
    }
    // Neglecting f lowers floor(N / D) by at most 1; neglecting g raises it by at most N / (D (D + 1)) < 2^127 / 2^126
    // = 2. So the true quotient lies in (q - 2, q + 2). Rounding is monotone and changes only at integers here (nine or
    // more bits are dropped), so where both ends agree, everything between does.
    constexpr std::uint64_t slack = 2;
    if (q.quotient < ~std::uint64_t(0) - slack) {
        const T low = round<T>({q.quotient - slack, exponent, false}, negative, direction);
        if (low == round<T>({q.quotient + slack, exponent, true}, negative, direction)) return low;
    }
    return round<T>(divide_exactly(num, den), negative, direction);
}

}  // namespace rounding

/// x * 2^exponent, rounded to a float or double. Subnormal results are rounded correctly; what rounds to zero is +0.
template <std::floating_point T, unsigned K>
[[nodiscard]] T round_to(const BasicInteger<K>& x, std::int64_t exponent = 0,
                         Rounding direction = Rounding::nearest) noexcept {
    if (x.is_zero()) return T(0);
    rounding::Magnitude leading = rounding::leading(x.view());
    // Far outside every format's range the exact exponent no longer matters, and the clamp keeps the sum from
    // overflowing.
    constexpr std::int64_t far = std::int64_t(1) << 40;
    leading.exponent += exponent < -far ? -far : (exponent > far ? far : exponent);
    return rounding::round<T>(leading, x.view().negative(), direction);
}

/// x * 2^exponent as a double; see `round_to`.
template <unsigned K>
[[nodiscard]] double to_double(const BasicInteger<K>& x, std::int64_t exponent = 0,
                               Rounding direction = Rounding::nearest) noexcept {
    return round_to<double>(x, exponent, direction);
}

/// num / den, rounded to a float or double, whatever the sizes of the two; they need no common factor removed.
/// Throws: NumberError if den is zero. Cost: one division of limbs, and a long division once in some hundred calls or
/// where the quotient is exact.
template <std::floating_point T, unsigned K, unsigned M>
[[nodiscard]] T round_ratio_to(const BasicInteger<K>& num, const BasicInteger<M>& den,
                               Rounding direction = Rounding::nearest) {
    if (den.is_zero()) throw NumberError("a ratio with denominator zero is not a number");
    return rounding::ratio<T>(num.view(), den.view(), direction);
}

/// num / den as a double; see `round_ratio_to`.
template <unsigned K, unsigned M>
[[nodiscard]] double ratio_to_double(const BasicInteger<K>& num, const BasicInteger<M>& den,
                                     Rounding direction = Rounding::nearest) {
    return round_ratio_to<double>(num, den, direction);
}

/// num / den as a float; see `round_ratio_to`.
template <unsigned K, unsigned M>
[[nodiscard]] float ratio_to_float(const BasicInteger<K>& num, const BasicInteger<M>& den,
                                   Rounding direction = Rounding::nearest) {
    return round_ratio_to<float>(num, den, direction);
}

CLEAVE_END_NAMESPACE

#endif
