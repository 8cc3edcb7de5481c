// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/winding_rule.hpp>

#include "support/catch.hpp"

#include <array>
#include <optional>

using namespace cleave;

TEST_CASE("winding rule: what is inside") {
    constexpr std::array<int, 7> numbers{-3, -2, -1, 0, 1, 2, 3};
    constexpr std::array<bool, 7> positive{false, false, false, false, true, true, true};
    constexpr std::array<bool, 7> non_zero{true, true, true, false, true, true, true};
    constexpr std::array<bool, 7> even_odd{true, false, true, false, true, false, true};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        CHECK(is_inside(WindingRule::positive, numbers[i]) == positive[i]);
        CHECK(is_inside(WindingRule::non_zero, numbers[i]) == non_zero[i]);
        CHECK(is_inside(WindingRule::even_odd, numbers[i]) == even_odd[i]);
    }
}

TEST_CASE("winding rule: names are read back") {
    for (const WindingRule rule : all_winding_rules) CHECK(winding_rule_from_text(to_text(rule)) == rule);
    CHECK(winding_rule_from_text("non_zero") == WindingRule::non_zero);
    CHECK(winding_rule_from_text("even_odd") == WindingRule::even_odd);
    for (const char* text : {"", "Positive", "nonzero", "odd", " positive"})
        CHECK(winding_rule_from_text(text) == std::nullopt);
}
