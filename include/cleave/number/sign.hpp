// SPDX-License-Identifier: Apache-2.0
/// The sign of an exact number, which is also the side of an oriented plane: plus is outside, minus is inside.
#ifndef CLEAVE_NUMBER_SIGN_HPP
#define CLEAVE_NUMBER_SIGN_HPP

#include <cleave/base/config.hpp>

CLEAVE_BEGIN_NAMESPACE

/// minus: below zero, the inside of a plane; zero: on it; plus: above zero, the outside.
enum class Sign : signed char { minus = -1, zero = 0, plus = 1 };

/// The opposite sign.
[[nodiscard]] constexpr Sign operator-(Sign s) noexcept {
    return static_cast<Sign>(-static_cast<signed char>(s));
}

/// The sign of a product.
[[nodiscard]] constexpr Sign operator*(Sign a, Sign b) noexcept {
    return static_cast<Sign>(static_cast<signed char>(a) * static_cast<signed char>(b));
}

/// The sign of anything comparable with 0 that is not NaN (built-in numbers).
template <class T>
[[nodiscard]] constexpr Sign sign_of_value(T value) noexcept {
    return value < T(0) ? Sign::minus : (T(0) < value ? Sign::plus : Sign::zero);
}

CLEAVE_END_NAMESPACE

#endif
