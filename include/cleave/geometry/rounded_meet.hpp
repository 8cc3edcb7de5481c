// SPDX-License-Identifier: Apache-2.0
/// The correctly rounded coordinates of the meet of three planes without an integer, nearly always.
#ifndef CLEAVE_GEOMETRY_ROUNDED_MEET_HPP
#define CLEAVE_GEOMETRY_ROUNDED_MEET_HPP

#include <cleave/number/double_double.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

CLEAVE_BEGIN_NAMESPACE

/// A plane's coefficients, all times one positive number, each within 2^-106 of its value.
using DoubleDoublePlane = std::array<DoubleDouble, 4>;

namespace rounded_meeting {

/// An approximate value, and the sum of the magnitudes that its error is proportional to.
struct Term {
    DoubleDouble value;
    double magnitude = 0;

    friend Term operator*(const DoubleDouble& a, const Term& b) { return {a * b.value, std::fabs(a.hi) * b.magnitude}; }
    friend Term operator+(const Term& a, const Term& b) { return {a.value + b.value, a.magnitude + b.magnitude}; }
    friend Term operator-(const Term& a, const Term& b) { return {a.value - b.value, a.magnitude + b.magnitude}; }
};

inline Term product(const DoubleDouble& a, const DoubleDouble& b) {
    return {a * b, std::fabs(a.hi * b.hi)};
}

/// The double nearest to `x` +- `error`, where there is only one.
inline std::optional<double> round(const DoubleDouble& x, double error) {
    error *= 1 + 0x1p-40;
    if (x.hi + (x.lo + error) == x.hi && x.hi + (x.lo - error) == x.hi) return x.hi + 0.0;
    return std::nullopt;
}

}  // namespace rounded_meeting

/// The coordinates of the planes' meet, each the double nearest to the exact one; nullopt where two doubles may be
/// that, or the numbers are beyond 2^250 in size or smallness, or a coordinate may be zero.
///
/// Proof. By Cramer's rule a coordinate is a quotient of two 3 x 3 determinants. Each of their six products of three
/// coefficients is within 3 * 2^-106 + 2 * 2^-100 of its value, relatively, and each of three sums on its way adds
/// 2^-100 of what is summed: a determinant is off by less than 2^-96 times the sum S of its products' magnitudes, whose
/// own rounding that covers. With numerator N and denominator W off by n and w < |W| / 2, the quotient q is off by at
/// most 2 (n + |q| w) / |W|, and by 2^-100 |q| for its own rounding. Products of numbers between 2^-250 and 2^250, and
/// of their lower halves, lose at most 2^-1074 by underflow, which is nothing beside 2^-96 S.
[[nodiscard]] inline std::optional<std::array<double, 3>> rounded_meet(const std::array<DoubleDoublePlane, 3>& planes) {
    using rounded_meeting::Term;
    for (const DoubleDoublePlane& h : planes)
        for (const DoubleDouble& x : h)
            if (x.hi != 0 && !(std::fabs(x.hi) > 0x1p-250 && std::fabs(x.hi) < 0x1p250)) return std::nullopt;
    // Minors of the last two planes: of columns i and j, i < j.
    std::array<std::array<Term, 4>, 4> minor;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            minor[i][j] = rounded_meeting::product(planes[1][i], planes[2][j]) -
                          rounded_meeting::product(planes[1][j], planes[2][i]);
    const DoubleDoublePlane& h = planes[0];
    const auto determinant = [&](std::size_t i, std::size_t j, std::size_t k) {
        return h[i] * minor[j][k] - h[j] * minor[i][k] + h[k] * minor[i][j];
    };
    constexpr double factor = 0x1p-96;
    const Term w = determinant(0, 1, 2);
    const double w_size = std::fabs(w.value.hi);
    const double w_error = factor * w.magnitude;
    if (!(w_size > 2 * w_error)) return std::nullopt;
    const std::array<Term, 3> numerator{determinant(1, 2, 3), determinant(0, 2, 3), determinant(0, 1, 3)};
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Term& n = numerator[i];
        if (n.magnitude == 0) continue;  // zero, every product of it
        if (!(std::fabs(n.value.hi) > factor * n.magnitude)) return std::nullopt;
        const DoubleDouble q = n.value / w.value;
        const double size = std::fabs(q.hi);
        const double error = 2 * (factor * n.magnitude + size * w_error) / w_size + DoubleDouble::error * size;
        const std::optional<double> nearest = rounded_meeting::round(i == 1 ? q : -q, error);
        if (!nearest || !(size > 0x1p-250 && size < 0x1p250)) return std::nullopt;
        x[i] = *nearest;
    }
    return x;
}

CLEAVE_END_NAMESPACE

#endif
