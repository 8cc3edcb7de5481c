// SPDX-License-Identifier: Apache-2.0
/// Filters: an approximate answer with a proof decides first, the exact one decides where the proof abstains.
///
/// Two macros, to be set alike in a whole program: CLEAVE_COUNT_FILTERS counts what filters do (`filter_counts`);
/// CLEAVE_FAIL_FILTERS makes every filter abstain, so that a test sees the exact paths alone.
#ifndef CLEAVE_NUMBER_FILTER_HPP
#define CLEAVE_NUMBER_FILTER_HPP

#include <cleave/base/config.hpp>
#include <cleave/number/sign.hpp>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// What the program's filters did. `failures` were decided exactly; `zeros` are failures whose exact answer was zero,
/// which no approximation could have decided: on degenerate input they should be nearly all of them.
struct FilterCounts {
    std::uint64_t calls = 0;
    std::uint64_t failures = 0;
    std::uint64_t zeros = 0;
};

namespace filtering {

#ifdef CLEAVE_COUNT_FILTERS
inline constexpr bool counts = true;
#else
inline constexpr bool counts = false;
#endif

#ifdef CLEAVE_FAIL_FILTERS
inline constexpr bool always_fails = true;
#else
inline constexpr bool always_fails = false;
#endif

struct Counters {
    std::atomic<std::uint64_t> calls{0};
    std::atomic<std::uint64_t> failures{0};
    std::atomic<std::uint64_t> zeros{0};
};

inline Counters counters;

}  // namespace filtering

/// Counts one use of a filter that was not run by `filtered_sign`. Nothing without CLEAVE_COUNT_FILTERS.
inline void count_filter_call() noexcept {
    if constexpr (filtering::counts) filtering::counters.calls.fetch_add(1, std::memory_order_relaxed);
}

/// Counts one failure and what the exact answer was. Nothing without CLEAVE_COUNT_FILTERS.
inline void count_filter_failure([[maybe_unused]] Sign exact) noexcept {
    if constexpr (filtering::counts) {
        filtering::counters.failures.fetch_add(1, std::memory_order_relaxed);
        if (exact == Sign::zero) filtering::counters.zeros.fetch_add(1, std::memory_order_relaxed);
    }
}

/// The counts of all threads since the start or the last reset; zeros without CLEAVE_COUNT_FILTERS.
[[nodiscard]] inline FilterCounts filter_counts() noexcept {
    return {filtering::counters.calls.load(std::memory_order_relaxed),
            filtering::counters.failures.load(std::memory_order_relaxed),
            filtering::counters.zeros.load(std::memory_order_relaxed)};
}

/// Starts counting from zero. Counts that other threads make meanwhile may be lost.
inline void reset_filter_counts() noexcept {
    filtering::counters.calls.store(0, std::memory_order_relaxed);
    filtering::counters.failures.store(0, std::memory_order_relaxed);
    filtering::counters.zeros.store(0, std::memory_order_relaxed);
}

/// The sign that `approximate() -> std::optional<Sign>` proves, else `exact() -> Sign`.
/// Requires: where `approximate` answers, its answer is right.
template <class Approximate, class Exact>
[[nodiscard]] Sign filtered_sign(Approximate&& approximate, Exact&& exact) {
    count_filter_call();
    if constexpr (!filtering::always_fails) {
        if (const std::optional<Sign> sign = std::forward<Approximate>(approximate)()) return *sign;
    }
    const Sign sign = std::forward<Exact>(exact)();
    count_filter_failure(sign);
    return sign;
}

/// The sign of n_1 x_1 + ... + n_D x_D + c from doubles n', x', c' near the true values, or nothing.
///
/// Requires: |n'_i - n_i| <= u |n'_i| and |c' - c| <= u |c'| with u = 2^-53 (correctly rounded, neither subnormal nor
/// overflowed unless infinite), |x'_i - x_i| <= error for every i. Infinities and NaN are allowed and make it abstain.
///
/// Proof. Let M = sum |n'_i x'_i| + |c'| and L = sum |n'_i|.
///  1. Data: |n_i x_i - n'_i x'_i| <= |n_i - n'_i| |x_i| + |n'_i| |x_i - x'_i| <= u |n'_i| (|x'_i| + error) + |n'_i|
///  error,
///     so the exact values differ by at most u M + (1 + u) error L.
///  2. Rounding: a product is rounded once and passes D additions at most, so the computed sum s differs from the exact
///  sum
///     of the n' x' and c' by at most ((1 + u)^(D+1) - 1) M + D 2^-1074 <= (D + 1)(1 + 2^-46) u M + D 2^-1074 for D <=
///     64; the last term is underflow of products (sums do not underflow inexactly). A fused multiply-add omits
///     roundings and stays within the bound.
///  3. Together |s - true| <= (D + 2)(1 + 2^-46) u M + (1 + u) error L + D 2^-1074.
///  4. Computed: m >= (1 - u)^(D+1) M - D 2^-1074, and the bound below is at least
///     (1 - u) ((D + 5) u (1 - u) m + (1 + 2^-40)(1 - u)^(D+2) error L - 2^-1073) >=
///     (D + 4) u M + (1 + u) error L - 2^-1072, because (D + 5)(1 - (D + 4) u) > D + 4 + 1/2 and what underflow took
///     from m is multiplied by (D + 5) u. The surplus over 3 is u M - (D + 4) 2^-1074 > 0, as M >= 2^-900.
/// So |s| above the bound has the true sign. m <= 2^1000 keeps every partial sum finite; a NaN fails every comparison.
template <std::size_t D>
[[nodiscard]] inline std::optional<Sign> linear_form_sign(const std::array<double, D>& n, double c,
                                                          const std::array<double, D>& x, double error) noexcept {
    static_assert(D >= 1 && D <= 64, "the proof of the error bound covers up to 64 terms");
    if constexpr (filtering::always_fails) return std::nullopt;
    constexpr double u = 0x1p-53;
    constexpr double relative = (static_cast<double>(D) + 5.0) * u;
    double s = n[0] * x[0];
    double m = std::abs(n[0] * x[0]);
    double l = std::abs(n[0]);
    for (std::size_t i = 1; i < D; ++i) {
        s += n[i] * x[i];
        m += std::abs(n[i] * x[i]);
        l += std::abs(n[i]);
    }
    s += c;
    m += std::abs(c);
    const double bound = relative * m + (error * l) * (1.0 + 0x1p-40);
    if (!(m >= 0x1p-900 && m <= 0x1p+1000)) return std::nullopt;
    if (s > bound) return Sign::plus;
    if (s < -bound) return Sign::minus;
    return std::nullopt;
}

CLEAVE_END_NAMESPACE

#endif
