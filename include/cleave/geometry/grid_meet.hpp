// SPDX-License-Identifier: Apache-2.0
/// The meet of three planes with small coefficients, in machine words, where it is a point of doubles: what grids,
/// boxes and most constructed models consist of.
#ifndef CLEAVE_GEOMETRY_GRID_MEET_HPP
#define CLEAVE_GEOMETRY_GRID_MEET_HPP

#include <cleave/number/integer.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

CLEAVE_BEGIN_NAMESPACE

namespace grid_meeting {

/// n / w where that is a double; nullopt elsewhere. Requires: w != 0, the magnitudes are below 2^127.
inline std::optional<double> quotient(Int128 n, Int128 w) {
    if (n == 0) return 0.0;
    const bool negative = (n < 0) != (w < 0);
    UInt128 x = n < 0 ? UInt128(0) - UInt128(n) : UInt128(n);
    UInt128 y = w < 0 ? UInt128(0) - UInt128(w) : UInt128(w);
    const auto zeros = [](UInt128 v) {
        const auto low = static_cast<std::uint64_t>(v);
        return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(v >> 64U));
    };
    const int up = zeros(x);
    const int down = zeros(y);
    x >>= up;
    y >>= down;
    if (y != 1) {
        if (x % y != 0) return std::nullopt;
        x /= y;
    }
    if (x >= UInt128(1) << 53U) return std::nullopt;  // odd, so no shorter
    const double magnitude = std::ldexp(static_cast<double>(static_cast<std::uint64_t>(x)), up - down);
    return negative ? -magnitude : magnitude;
}

}  // namespace grid_meeting

/// The point that three planes n.x + c = 0 have in common; nullopt where a normal's coefficient is beyond 2^30 or
/// an offset beyond 2^62, where there is no one such point, or where a coordinate of it is no double.
///
/// Minors of two normals are at most 2^61, those with a column of offsets 2^93, so each of the four determinants is
/// less than 2^125, and nothing overflows.
[[nodiscard]] inline std::optional<std::array<double, 3>> grid_meet(
    const std::array<const std::array<Integer, 4>*, 3>& planes) {
    constexpr std::int64_t longest_normal = std::int64_t(1) << 30U;
    constexpr std::int64_t longest_offset = std::int64_t(1) << 62U;
    std::array<std::array<std::int64_t, 4>, 3> h;
    for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t i = 0; i < 4; ++i) {
            const Integer& x = (*planes[n])[3 - i];  // offsets first: they are the longest
            if (!x.fits_int64()) return std::nullopt;
            const std::int64_t v = x.to_int64();
            const std::int64_t most = i == 0 ? longest_offset : longest_normal;
            if (v > most || v < -most) return std::nullopt;
            h[n][3 - i] = v;
        }
    const auto minor = [&](std::size_t i, std::size_t j) {
        return Int128(h[1][i]) * h[2][j] - Int128(h[1][j]) * h[2][i];
    };
    const Int128 xy = minor(0, 1);
    const Int128 xz = minor(0, 2);
    const Int128 yz = minor(1, 2);
    const Int128 w = h[0][0] * yz - h[0][1] * xz + h[0][2] * xy;
    if (w == 0) return std::nullopt;
    const Int128 xc = minor(0, 3);
    const Int128 yc = minor(1, 3);
    const Int128 zc = minor(2, 3);
    const std::array<Int128, 3> numerator{-(h[0][1] * zc - h[0][2] * yc + h[0][3] * yz),
                                          h[0][0] * zc - h[0][2] * xc + h[0][3] * xz,
                                          -(h[0][0] * yc - h[0][1] * xc + h[0][3] * xy)};
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> q = grid_meeting::quotient(numerator[i], w);
        if (!q) return std::nullopt;
        x[i] = *q;
    }
    return x;
}

CLEAVE_END_NAMESPACE

#endif
