// SPDX-License-Identifier: Apache-2.0
/// The exact plane through three points of doubles, from differences: in machine words where the coordinates lie on one
/// grid of 62 bits, as those of most triangles do, else in integers of any length.
#ifndef CLEAVE_GEOMETRY_DOUBLE_PLANE_HPP
#define CLEAVE_GEOMETRY_DOUBLE_PLANE_HPP

#include <cleave/geometry/double_predicates.hpp>

#include <cleave/number/integer.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// Integer coefficients (n, c) of the plane n.x + c = 0 through p, q, r, up to a positive factor; the plus side is
/// where p, q, r are counter-clockwise. All zero where the points are on one line. Requires: finite coordinates. Cost:
/// nine products of differences and of what they give, shorter than minors of homogeneous coordinates.
[[nodiscard]] inline std::array<Integer, 4> plane_through(const std::array<double, 3>& p,
                                                          const std::array<double, 3>& q,
                                                          const std::array<double, 3>& r) {
    const IntegerVector a = integer_difference(q, p);
    const IntegerVector b = integer_difference(r, p);
    std::array<DoubleParts, 3> at;
    int least = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        at[i] = decompose(p[i]);
        if (at[i].mantissa != 0) least = std::min(least, at[i].exponent);
    }
    // p = P 2^least, so n 2^-least . x - n . P is zero at p.
    std::array<Integer, 4> plane;
    WideInteger offset;
    for (std::size_t i = 0; i < 3; ++i) {
        WideInteger n;
        add_product(n, a[(i + 1) % 3], b[(i + 2) % 3]);
        sub_product(n, a[(i + 2) % 3], b[(i + 1) % 3]);
        if (at[i].mantissa != 0)
            sub_product(offset, n,
                        WideInteger::scaled(at[i].mantissa, static_cast<std::size_t>(at[i].exponent - least)));
        plane[i] = Integer(n << static_cast<std::size_t>(-least));
    }
    plane[3] = Integer(offset);
    return plane;
}

/// A plane's primitive integer coefficients, the first of the normal's that is not zero being positive.
struct PrimitivePlane {
    std::array<Integer, 4> coefficients;
    bool is_flipped;  ///< whether the plane that was asked for faces the other way
};

namespace grid_plane {

/// The points on a grid of 2^`exponent`.
struct GridPoints {
    std::array<std::array<std::int64_t, 3>, 3> points;
    int exponent;
};

/// nullopt where the coordinates need more than 62 bits.
inline std::optional<GridPoints> on_grid(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                         const std::array<double, 3>& r) {
    constexpr int bits = 62;
    std::array<std::array<DoubleParts, 3>, 3> parts;
    int least = 0;
    int top = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array<double, 3>& x = i == 0 ? p : (i == 1 ? q : r);
        for (std::size_t k = 0; k < 3; ++k) {
            const DoubleParts d = parts[i][k] = decompose(x[k]);
            if (d.mantissa == 0) continue;
            least = std::min(least, d.exponent);
            top = std::max(top, d.exponent + int(std::bit_width(std::uint64_t(std::abs(d.mantissa)))));
        }
    }
    if (top - least > bits) return std::nullopt;
    GridPoints grid;
    grid.exponent = least;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            grid.points[i][k] = parts[i][k].mantissa == 0
                                    ? 0
                                    : parts[i][k].mantissa * (std::int64_t(1) << (parts[i][k].exponent - least));
    return grid;
}

inline int trailing_zeros(UInt128 x) {
    const auto low = static_cast<std::uint64_t>(x);
    return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(x >> 64U));
}

/// The greatest odd number that divides both; of x where y is zero [Stein-1967].
inline UInt128 odd_divisor(UInt128 x, UInt128 y) {
    if (x == 0) std::swap(x, y);
    if (x == 0) return 0;
    x >>= trailing_zeros(x);
    if (y == 0) return x;
    y >>= trailing_zeros(y);
    // Without branches that depend on which is larger: nobody can predict them.
    while (((x | y) >> 64U) != 0) {
        const UInt128 difference = x - y;
        if (difference == 0) return x;
        const bool less = x < y;
        y = less ? x : y;
        x = (less ? UInt128(0) - difference : difference) >> trailing_zeros(difference);
    }
    auto a = static_cast<std::uint64_t>(x);
    auto b = static_cast<std::uint64_t>(y);
    while (a != b) {
        const std::uint64_t difference = a - b;
        const bool less = a < b;
        b = less ? a : b;
        a = (less ? 0 - difference : difference) >> std::countr_zero(difference);
    }
    return a;
}

/// A number of up to 191 bits and a sign.
struct Number {
    std::array<std::uint64_t, 3> limbs{};
    bool negative = false;

    Number() = default;
    Number(UInt128 magnitude, bool is_negative)
        : limbs{static_cast<std::uint64_t>(magnitude), static_cast<std::uint64_t>(magnitude >> 64U), 0},
          negative(is_negative) {}

    [[nodiscard]] bool is_zero() const { return (limbs[0] | limbs[1] | limbs[2]) == 0; }

    [[nodiscard]] std::size_t trailing_zeros() const {
        std::size_t i = 0;
        while (limbs[i] == 0) ++i;
        return 64 * i + std::size_t(std::countr_zero(limbs[i]));
    }

    /// Divides by one word. Returns: the remainder.
    std::uint64_t divide(std::uint64_t divisor) {
        UInt128 rest = 0;
        for (std::size_t i = 3; i-- > 0;) {
            rest = rest << 64U | limbs[i];
            limbs[i] = static_cast<std::uint64_t>(rest / divisor);
            rest %= divisor;
        }
        return static_cast<std::uint64_t>(rest);
    }

    [[nodiscard]] Integer integer() const {
        if (is_zero()) return {};
        return Integer::from_limbs(negative ? Sign::minus : Sign::plus, limbs);
    }
};

/// x - n y. Requires: the result fits.
inline Number minus_product(const Number& x, const Number& n, std::int64_t y) {
    const bool negative = n.negative != (y < 0);
    const std::uint64_t factor = y < 0 ? 0 - static_cast<std::uint64_t>(y) : static_cast<std::uint64_t>(y);
    std::array<std::uint64_t, 3> product;
    const UInt128 low = UInt128(n.limbs[0]) * factor;
    const UInt128 high = UInt128(n.limbs[1]) * factor + (low >> 64U);
    product = {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high),
               static_cast<std::uint64_t>(high >> 64U)};
    // As two's complement: add or subtract, then take the magnitude again.
    const auto sum = [](std::array<std::uint64_t, 3> a, const std::array<std::uint64_t, 3>& b, bool subtract) {
        std::uint64_t carry = subtract ? 1 : 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const UInt128 t = UInt128(a[i]) + (subtract ? ~b[i] : b[i]) + carry;
            a[i] = static_cast<std::uint64_t>(t);
            carry = static_cast<std::uint64_t>(t >> 64U);
        }
        return a;
    };
    const std::array<std::uint64_t, 3> zero{};
    const std::array<std::uint64_t, 3> start = x.negative ? sum(zero, x.limbs, true) : x.limbs;
    Number result;
    result.limbs = sum(start, product, !negative);
    if ((result.limbs[2] >> 63U) != 0) {
        result.limbs = sum(zero, result.limbs, true);
        result.negative = true;
    }
    return result;
}

/// The plane through three points on a grid; nullopt where the coefficients have a common divisor of more than a word.
/// Requires: they are not on one line.
inline std::optional<PrimitivePlane> primitive_plane(const GridPoints& grid) {
    std::array<std::int64_t, 3> a, b;
    for (std::size_t k = 0; k < 3; ++k) {
        a[k] = grid.points[1][k] - grid.points[0][k];
        b[k] = grid.points[2][k] - grid.points[0][k];
    }
    std::array<Number, 4> c;
    UInt128 divisor = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Int128 n = Int128(a[(k + 1) % 3]) * b[(k + 2) % 3] - Int128(a[(k + 2) % 3]) * b[(k + 1) % 3];
        const bool negative = n < 0;
        const UInt128 magnitude = negative ? UInt128(0) - static_cast<UInt128>(n) : static_cast<UInt128>(n);
        c[k] = Number(magnitude, negative);
        if (divisor != 1) divisor = odd_divisor(divisor, magnitude);
        c[3] = minus_product(c[3], c[k], grid.points[0][k]);
    }
    if (divisor != 1) {
        if ((divisor >> 64U) != 0) return std::nullopt;
        Number rest = c[3];
        divisor = odd_divisor(divisor, rest.divide(static_cast<std::uint64_t>(divisor)));
    }
    // n 2^-exponent . x + c is zero where n . X + c is, x being X 2^exponent.
    const auto shift = static_cast<std::size_t>(-grid.exponent);
    std::size_t zeros = c[3].is_zero() ? ~std::size_t(0) : c[3].trailing_zeros();
    for (std::size_t k = 0; k < 3; ++k)
        if (!c[k].is_zero()) zeros = std::min(zeros, c[k].trailing_zeros() + shift);
    std::size_t first = 0;
    while (c[first].is_zero()) ++first;
    PrimitivePlane plane;
    plane.is_flipped = c[first].negative;
    for (std::size_t k = 0; k < 4; ++k) {
        if (divisor != 1) c[k].divide(static_cast<std::uint64_t>(divisor));
        c[k].negative = c[k].negative != plane.is_flipped;
        const std::size_t up = k < 3 ? shift : 0;
        plane.coefficients[k] = c[k].integer();
        if (up >= zeros)
            plane.coefficients[k] <<= up - zeros;
        else if (!c[k].is_zero())
            plane.coefficients[k] >>= zeros - up;
    }
    return plane;
}

}  // namespace grid_plane

/// The plane through p, q, r in primitive coefficients, if it can be had in machine words: nullopt where the
/// coordinates span more than 62 bits, and in rare other cases. Requires: finite coordinates, not on one line. Cost:
/// some 0.3 microseconds.
[[nodiscard]] inline std::optional<PrimitivePlane> small_plane_through(const std::array<double, 3>& p,
                                                                       const std::array<double, 3>& q,
                                                                       const std::array<double, 3>& r) {
    const std::optional<grid_plane::GridPoints> grid = grid_plane::on_grid(p, q, r);
    return grid ? grid_plane::primitive_plane(*grid) : std::nullopt;
}

CLEAVE_END_NAMESPACE

#endif
