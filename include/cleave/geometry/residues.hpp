// SPDX-License-Identifier: Apache-2.0
/// Minors and doubles modulo 2^61-1: what hashes of constructed points are made of.
#ifndef CLEAVE_GEOMETRY_RESIDUES_HPP
#define CLEAVE_GEOMETRY_RESIDUES_HPP

#include <cleave/number/double.hpp>
#include <cleave/number/modular.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

/// The determinant of the rows from `row` on and the given columns, by cofactors.
template <std::size_t Rows, std::size_t Columns, std::size_t K>
[[nodiscard]] Mod61 residue_determinant(const std::array<std::array<Mod61, Columns>, Rows>& m,
                                        const std::array<std::size_t, K>& columns, std::size_t row) {
    if constexpr (K == 1) {
        return m[row][columns[0]];
    } else {
        Mod61 sum(0);
        for (std::size_t skip = 0; skip < K; ++skip) {
            std::array<std::size_t, K - 1> rest{};
            for (std::size_t i = 0, c = 0; c < K; ++c)
                if (c != skip) rest[i++] = columns[c];
            const Mod61 term = m[row][columns[skip]] * residue_determinant(m, rest, row + 1);
            sum = skip % 2 == 0 ? sum + term : sum - term;
        }
        return sum;
    }
}

/// Maximal minors with alternating signs, by cofactors: meant for D of at most 3, and good enough for a few more.
template <std::size_t D>
[[nodiscard]] std::array<Mod61, D + 1> residue_minors(const std::array<std::array<Mod61, D + 1>, D>& m) {
    std::array<Mod61, D + 1> v;
    for (std::size_t skip = 0; skip <= D; ++skip) {
        std::array<std::size_t, D> columns{};
        for (std::size_t i = 0, c = 0; c <= D; ++c)
            if (c != skip) columns[i++] = c;
        const Mod61 det = residue_determinant(m, columns, 0);
        v[skip] = skip % 2 == 0 ? det : Mod61(0) - det;
    }
    return v;
}

/// A finite double modulo 2^61-1.
[[nodiscard]] inline Mod61 residue_of(double x) {
    const DoubleParts parts = decompose(x);
    if (parts.mantissa == 0) return Mod61(0);
    // 2^61 = 1 modulo 2^61-1, so exponents count modulo 61.
    const auto e = unsigned(((parts.exponent % 61) + 61) % 61);
    const std::uint64_t m = parts.mantissa < 0 ? std::uint64_t(-parts.mantissa) : std::uint64_t(parts.mantissa);
    const Mod61 value = Mod61(m) * Mod61(std::uint64_t(1) << e);
    return parts.mantissa < 0 ? Mod61(0) - value : value;
}

CLEAVE_END_NAMESPACE

#endif
