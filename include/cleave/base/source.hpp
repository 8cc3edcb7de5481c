// SPDX-License-Identifier: Apache-2.0
/// Where a face came from: an operand of the operation and a face of that operand.
#ifndef CLEAVE_BASE_SOURCE_HPP
#define CLEAVE_BASE_SOURCE_HPP

#include <cleave/base/config.hpp>

#include <compare>
#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

/// A face of an operand, both counted from 0. The order (operand first) decides which of several coincident faces
/// stands for all; `none`, the default, comes after every real source.
struct Source {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::uint32_t operand = none;
    std::uint32_t face = none;

    [[nodiscard]] constexpr bool has_value() const noexcept { return operand != none; }

    friend constexpr bool operator==(const Source&, const Source&) noexcept = default;
    friend constexpr std::strong_ordering operator<=>(const Source&, const Source&) noexcept = default;
};

CLEAVE_END_NAMESPACE

#endif
