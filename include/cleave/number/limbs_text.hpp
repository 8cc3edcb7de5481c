// SPDX-License-Identifier: Apache-2.0
/// Decimal text of limb arrays, nineteen digits at a time.
#ifndef CLEAVE_NUMBER_LIMBS_TEXT_HPP
#define CLEAVE_NUMBER_LIMBS_TEXT_HPP

#include <cleave/number/limbs_division.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace limbs {

inline constexpr Limb decimal_chunk = 10'000'000'000'000'000'000U;  // 10^19, the largest power of ten in a limb
inline constexpr std::size_t decimal_chunk_digits = 19;

/// The decimal digits of a number of n limbs, "0" for zero. Cost: n^2 limb divisions.
[[nodiscard]] inline std::string to_decimal(const Limb* a, std::size_t n) {
    std::vector<Limb> rest(a, a + n);
    n = normalised_size(rest.data(), n);
    if (n == 0) return "0";
    const LimbDivisor chunk(decimal_chunk);
    std::string reversed;
    reversed.reserve(n * 20);
    while (n != 0) {
        Limb digits = chunk.divide(rest.data(), rest.data(), n);
        n = normalised_size(rest.data(), n);
        for (std::size_t i = 0; i < decimal_chunk_digits && (n != 0 || digits != 0); ++i) {
            reversed.push_back(static_cast<char>('0' + digits % 10));
            digits /= 10;
        }
    }
    return {reversed.rbegin(), reversed.rend()};
}

/// Reads a non-empty string of decimal digits into `out`, normalised. Returns: false, with `out` unspecified, if any
/// character is not a digit or there is none. Cost: n^2 limb products.
[[nodiscard]] inline bool from_decimal(std::string_view digits, std::vector<Limb>& out) {
    out.clear();
    if (digits.empty()) return false;
    for (std::size_t begin = 0; begin < digits.size();) {
        // The first chunk takes what does not fill a whole one.
        const std::size_t odd = (digits.size() - begin) % decimal_chunk_digits;
        const std::size_t length = odd == 0 ? decimal_chunk_digits : odd;
        Limb value = 0;
        Limb scale = 1;
        for (const char c : digits.substr(begin, length)) {
            if (c < '0' || c > '9') return false;
            value = value * 10 + static_cast<Limb>(c - '0');
            scale *= 10;
        }
        begin += length;
        Limb carry = multiply_by_limb(out.data(), out.data(), out.size(), scale);
        if (carry != 0) out.push_back(carry);
        const Limb overflow = add(out.data(), out.data(), out.size(), &value, out.empty() ? 0 : 1);
        if (out.empty() && value != 0) out.push_back(value);
        if (overflow != 0) out.push_back(overflow);
    }
    return true;
}

}  // namespace limbs

CLEAVE_END_NAMESPACE

#endif
