// SPDX-License-Identifier: Apache-2.0
/// Products of limb arrays, by columns in stripes of up to four limbs.
///
/// A stripe multiplies the long operand by one to four limbs of the short one. Its columns are summed in three
/// registers (Comba's method), so the long result is read and written once a stripe instead of once a limb, and each
/// partial product costs a multiplication and three additions.
#ifndef CLEAVE_NUMBER_LIMBS_PRODUCT_HPP
#define CLEAVE_NUMBER_LIMBS_PRODUCT_HPP

#include <cleave/number/limbs.hpp>

#include <cstddef>
#include <type_traits>

CLEAVE_BEGIN_NAMESPACE

namespace limbs {

/// Three limbs that sum the products of a column.
class ColumnSum {
public:
    constexpr void add_product(Limb a, Limb b) noexcept {
        const UInt128 product = UInt128(a) * b;
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
        if (!std::is_constant_evaluated()) {
            // One add and two adc; compilers store the last carry and add it by itself, about 15 % slower.
            auto low = static_cast<Limb>(low_);
            auto middle = static_cast<Limb>(low_ >> bits);
            asm("addq %[p0], %[s0]\n\tadcq %[p1], %[s1]\n\tadcq $0, %[s2]"
                : [s0] "+&r"(low), [s1] "+&r"(middle), [s2] "+r"(high_)
                : [p0] "r"(static_cast<Limb>(product)), [p1] "r"(static_cast<Limb>(product >> bits))
                : "cc");
            low_ = (UInt128(middle) << bits) | low;
            return;
        }
#endif
        high_ += __builtin_add_overflow(low_, product, &low_) ? 1U : 0U;
    }
    constexpr void add(Limb a) noexcept {
        high_ += __builtin_add_overflow(low_, UInt128(a), &low_) ? 1U : 0U;
    }

    /// The column's digit; what is left starts the next column.
    [[nodiscard]] constexpr Limb next() noexcept {
        const auto digit = static_cast<Limb>(low_);
        low_ = (low_ >> bits) | (UInt128(high_) << bits);
        high_ = 0;
        return digit;
    }

private:
    UInt128 low_ = 0;
    Limb high_ = 0;
};

/// out = a * b, or out += a * b where `Accumulate`, for b of exactly S limbs. Requires: n >= S; `out` has n + S limbs,
/// of which the upper S are only written, and overlaps neither operand.
template <std::size_t S, bool Accumulate>
constexpr void multiply_stripe(Limb* out, const Limb* a, std::size_t n, const Limb* b) noexcept {
    ColumnSum sum;
    const auto column = [&](std::size_t k, std::size_t first, std::size_t last) {  // products a[k - j] b[j]
        for (std::size_t j = first; j < last; ++j) sum.add_product(a[k - j], b[j]);
    };
    for (std::size_t k = 0; k + 1 < S; ++k) {
        if constexpr (Accumulate) sum.add(out[k]);
        column(k, 0, k + 1);
        out[k] = sum.next();
    }
    for (std::size_t k = S - 1; k < n; ++k) {
        if constexpr (Accumulate) sum.add(out[k]);
        column(k, 0, S);
        out[k] = sum.next();
    }
    for (std::size_t j = 1; j < S; ++j) {
        column(n - 1 + j, j, S);
        out[n - 1 + j] = sum.next();
    }
    out[n + S - 1] = sum.next();
}

/// out = a * b over n + m limbs. Requires: n >= m >= 1; `out` overlaps neither operand.
constexpr void multiply(Limb* out, const Limb* a, std::size_t n, const Limb* b, std::size_t m) noexcept {
    switch (m % 4) {
        case 0:
            multiply_stripe<4, false>(out, a, n, b);
            break;
        case 1:
            multiply_stripe<1, false>(out, a, n, b);
            break;
        case 2:
            multiply_stripe<2, false>(out, a, n, b);
            break;
        default:
            multiply_stripe<3, false>(out, a, n, b);
            break;
    }
    for (std::size_t j = (m - 1) % 4 + 1; j < m; j += 4) multiply_stripe<4, true>(out + j, a, n, b + j);
}

}  // namespace limbs

CLEAVE_END_NAMESPACE

#endif
