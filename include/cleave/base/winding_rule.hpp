// SPDX-License-Identifier: Apache-2.0
/// Winding rules: which points belong to the set that a closed surface describes where it runs through itself.
#ifndef CLEAVE_BASE_WINDING_RULE_HPP
#define CLEAVE_BASE_WINDING_RULE_HPP

#include <cleave/base/config.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

CLEAVE_BEGIN_NAMESPACE

/// Which winding numbers are inside. The winding number of a point is how often the surface runs around it: 1 inside a
/// solid that faces outward, -1 inside one that faces inward, and the sum of these where several overlap.
///
/// `positive`: w > 0. Overlapping solids are united, cavities stay cavities, what is inside out vanishes.
/// `non_zero`: w != 0. Overlapping solids are united whichever way they face; a cavity is w = 0 and stays one.
/// `even_odd`: w is odd. What two solids have in common is left out, however they face.
enum class WindingRule : std::uint8_t { positive, non_zero, even_odd };

/// All rules, in the order of the enumeration.
inline constexpr std::array<WindingRule, 3> all_winding_rules = {WindingRule::positive, WindingRule::non_zero,
                                                                 WindingRule::even_odd};

/// Whether points of this winding number are inside.
[[nodiscard]] constexpr bool is_inside(WindingRule rule, int winding) noexcept {
    switch (rule) {
        case WindingRule::positive:
            return winding > 0;
        case WindingRule::non_zero:
            return winding != 0;
        case WindingRule::even_odd:
            return winding % 2 != 0;
    }
    return false;
}

/// Returns: the name of the rule as the command line spells it: "positive", "non-zero", "even-odd".
[[nodiscard]] constexpr std::string_view to_text(WindingRule rule) noexcept {
    switch (rule) {
        case WindingRule::positive:
            return "positive";
        case WindingRule::non_zero:
            return "non-zero";
        case WindingRule::even_odd:
            return "even-odd";
    }
    return {};
}

/// Returns: the rule of that name, `to_text` reversed; also the C++ spellings. nullopt for any other text.
[[nodiscard]] constexpr std::optional<WindingRule> winding_rule_from_text(std::string_view text) noexcept {
    for (const WindingRule rule : all_winding_rules) {
        if (text == to_text(rule)) return rule;
    }
    if (text == "non_zero") return WindingRule::non_zero;
    if (text == "even_odd") return WindingRule::even_odd;
    return std::nullopt;
}

CLEAVE_END_NAMESPACE

#endif
