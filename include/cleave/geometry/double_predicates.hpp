// SPDX-License-Identifier: Apache-2.0
/// Exact orientation tests on points of doubles, with no plane or point stored anywhere.
///
/// Floating point with a proven bound decides first, integers of whatever length are needed decide the rest.
#ifndef CLEAVE_GEOMETRY_DOUBLE_PREDICATES_HPP
#define CLEAVE_GEOMETRY_DOUBLE_PREDICATES_HPP

#include <cleave/number/double.hpp>
#include <cleave/number/filter.hpp>
#include <cleave/number/integer.hpp>
#include <cleave/number/sign.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

CLEAVE_BEGIN_NAMESPACE

/// A vector scaled by some positive number that makes it an integer vector; only signs of its products have a meaning.
using IntegerVector = std::array<WideInteger, 3>;

/// p - origin, scaled. Cost: no allocation while coordinates differ by less than about 1,400 binary orders.
[[nodiscard]] inline IntegerVector integer_difference(const std::array<double, 3>& p,
                                                      const std::array<double, 3>& origin) {
    std::array<DoubleParts, 6> parts;
    int least = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        parts[i] = decompose(i < 3 ? p[i] : origin[i - 3]);
        if (i == 0 || parts[i].exponent < least) least = parts[i].exponent;
    }
    IntegerVector result;
    for (std::size_t i = 0; i < 3; ++i) {
        const DoubleParts& a = parts[i];
        const DoubleParts& b = parts[i + 3];
        result[i] = WideInteger::scaled(a.mantissa, static_cast<std::size_t>(a.exponent - least));
        result[i] -= WideInteger::scaled(b.mantissa, static_cast<std::size_t>(b.exponent - least));
    }
    return result;
}

/// Two coordinates that are kept of three, in the order that makes a turn seen from the plus end of the third axis
/// positive where it is counter-clockwise.
struct Projection {
    std::uint8_t u = 0;
    std::uint8_t v = 1;

    /// Along axis 0, 1 or 2; reversed is the same seen from the minus end.
    [[nodiscard]] static constexpr Projection along(unsigned axis, bool reversed = false) noexcept {
        const auto u = static_cast<std::uint8_t>((axis + 1) % 3);
        const auto v = static_cast<std::uint8_t>((axis + 2) % 3);
        return reversed ? Projection{v, u} : Projection{u, v};
    }
};

/// The sign of the determinant of the edge vectors a, b in a projection.
[[nodiscard]] inline Sign exact_turn(const IntegerVector& a, const IntegerVector& b, Projection projection) {
    WideInteger det;
    add_product(det, a[projection.u], b[projection.v]);
    sub_product(det, a[projection.v], b[projection.u]);
    return det.sign();
}

/// The turn in a projection of three points whose coordinates are within `error` of those of p, q, r, as far as
/// floating point proves it.
///
/// Proof. With e the error, a computed difference d' of two coordinates is within u |d'| + 2 e of the true d, u =
/// 2^-53: rounding is the first term, the data the second. So a product of two true differences is within (2 u + u^2)
/// |a' b'| + (1 + u) 2 e (|a'| + |b'|) + 4 e^2 of a' b', whose rounding adds u |a' b'| + 2^-1075. The sum of two such
/// products is rounded once more. Every term below is at least a quarter above its counterpart, which covers the
/// rounding of the bound itself. NaN and infinity fail the comparison.
[[nodiscard]] inline std::optional<Sign> approximate_turn(const std::array<double, 3>& p,
                                                          const std::array<double, 3>& q,
                                                          const std::array<double, 3>& r, Projection projection,
                                                          double error = 0) {
    const double qu = q[projection.u] - p[projection.u], qv = q[projection.v] - p[projection.v];
    const double ru = r[projection.u] - p[projection.u], rv = r[projection.v] - p[projection.v];
    const double left = qu * rv, right = qv * ru;
    const double det = left - right;
    const double spread = std::fabs(qu) + std::fabs(qv) + std::fabs(ru) + std::fabs(rv);
    const double bound =
        6 * 0x1p-53 * (std::fabs(left) + std::fabs(right)) + 0x1p-1060 + (3 * error * spread + 12 * error * error);
    if (det > bound) return Sign::plus;
    if (-det > bound) return Sign::minus;
    return std::nullopt;
}

/// The turn p, q, r in a projection: plus where it is counter-clockwise. Requires: finite coordinates.
[[nodiscard]] inline Sign turn(const std::array<double, 3>& p, const std::array<double, 3>& q,
                               const std::array<double, 3>& r, Projection projection) {
    return filtered_sign([&] { return approximate_turn(p, q, r, projection); },
                         [&] { return exact_turn(integer_difference(q, p), integer_difference(r, p), projection); });
}

/// The plane through three points of doubles as far as floating point knows it: what `approximate_side` needs of them,
/// for many points beside one plane.
struct RoughPlane {
    std::array<double, 3> origin;     ///< one of the points, exact
    std::array<double, 3> normal;     ///< their cross product, rounded
    std::array<double, 3> magnitude;  ///< of each coordinate's two products, which its error is proportional to
};

[[nodiscard]] inline RoughPlane rough_plane(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                            const std::array<double, 3>& r) {
    const double ax = q[0] - p[0], ay = q[1] - p[1], az = q[2] - p[2];
    const double bx = r[0] - p[0], by = r[1] - p[1], bz = r[2] - p[2];
    const double x1 = ay * bz, x2 = az * by;
    const double y1 = az * bx, y2 = ax * bz;
    const double z1 = ax * by, z2 = ay * bx;
    return {p,
            {x1 - x2, y1 - y2, z1 - z2},
            {std::fabs(x1) + std::fabs(x2), std::fabs(y1) + std::fabs(y2), std::fabs(z1) + std::fabs(z2)}};
}

/// The sign of det(q - p, r - p, s - p) as far as floating point proves it, `h` being the plane through p, q, r.
///
/// Proof. Each of the three products a (b c - d e) of rounded differences carries three rounded differences, two
/// rounded products, one rounded subtraction, one more product, and two sums: at most 9 u, to first order, of
/// |a| (|b c| + |d e|). Products that underflow are off by 2^-1075, times a difference where they are multiplied once
/// more.
[[nodiscard]] inline std::optional<Sign> approximate_side(const RoughPlane& h, const std::array<double, 3>& s) {
    const double cx = s[0] - h.origin[0], cy = s[1] - h.origin[1], cz = s[2] - h.origin[2];
    const double fx = std::fabs(cx), fy = std::fabs(cy), fz = std::fabs(cz);
    const double det = h.normal[0] * cx + h.normal[1] * cy + h.normal[2] * cz;
    const double size = h.magnitude[0] * fx + h.magnitude[1] * fy + h.magnitude[2] * fz;
    const double bound = 16 * 0x1p-53 * size + 0x1p-1060 * (1 + fx + fy + fz);
    if (det > bound) return Sign::plus;
    if (-det > bound) return Sign::minus;
    return std::nullopt;
}

/// The same for a plane that is asked for once.
[[nodiscard]] inline std::optional<Sign> approximate_side(const std::array<double, 3>& p,
                                                          const std::array<double, 3>& q,
                                                          const std::array<double, 3>& r,
                                                          const std::array<double, 3>& s) {
    return approximate_side(rough_plane(p, q, r), s);
}

/// The sign of det(q - p, r - p, s - p), by integers.
[[nodiscard]] inline Sign exact_side(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                     const std::array<double, 3>& r, const std::array<double, 3>& s) {
    for (std::size_t x = 0; x < 3; ++x)  // an axis-parallel face
        if (p[x] == q[x] && p[x] == r[x] && p[x] == s[x]) return Sign::zero;
    if (s == p || s == q || s == r) return Sign::zero;
    const IntegerVector a = integer_difference(q, p);
    const IntegerVector b = integer_difference(r, p);
    const IntegerVector c = integer_difference(s, p);
    WideInteger det, minor;
    for (std::size_t x = 0; x < 3; ++x) {
        minor = WideInteger();
        add_product(minor, a[(x + 1) % 3], b[(x + 2) % 3]);
        sub_product(minor, a[(x + 2) % 3], b[(x + 1) % 3]);
        add_product(det, minor, c[x]);
    }
    return det.sign();
}

/// The side of s of the plane through p, q, r: plus where p, q, r are counter-clockwise seen from s; zero where the
/// four lie on one plane. Requires: finite coordinates. Cost: about 5 ns where the filter decides.
[[nodiscard]] inline Sign plane_side(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                     const std::array<double, 3>& r, const std::array<double, 3>& s) {
    return filtered_sign([&] { return approximate_side(p, q, r, s); }, [&] { return exact_side(p, q, r, s); });
}

CLEAVE_END_NAMESPACE

#endif
