// SPDX-License-Identifier: Apache-2.0
#include <cleave/clip/loop.hpp>

#include "support/catch.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

using namespace cleave;

namespace {

struct Corner {
    std::string point;
    std::string edge;
    friend bool operator==(const Corner&, const Corner&) = default;
};

struct Parts {
    std::vector<Corner> minus;
    std::vector<Corner> plus;
};

/// Splits the loop a, b, c, ... with edges ab, bc, ... whose corners have the given signs ("-", "0", "+").
Parts split_letters(const std::string& signs) {
    std::vector<Corner> loop;
    std::vector<Sign> values;
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const char here = static_cast<char>('a' + static_cast<int>(i));
        const char next = static_cast<char>('a' + static_cast<int>((i + 1) % signs.size()));
        loop.push_back({std::string(1, here), std::string{here, next}});
        values.push_back(signs[i] == '-' ? Sign::minus : (signs[i] == '+' ? Sign::plus : Sign::zero));
    }
    Parts parts;
    split_loop(
        std::span<const Corner>(loop), std::span<const Sign>(values), std::string("h"), std::string("~h"),
        [&](std::size_t i, std::size_t) { return "x" + loop[i].edge; },
        [&](const Corner& c) { parts.minus.push_back(c); }, [&](const Corner& c) { parts.plus.push_back(c); });
    return parts;
}

}  // namespace

TEST_CASE("loop: a cut across two edges") {
    const Parts parts = split_letters("--++");
    CHECK(parts.minus == std::vector<Corner>{{"a", "ab"}, {"b", "bc"}, {"xbc", "h"}, {"xda", "da"}});
    CHECK(parts.plus == std::vector<Corner>{{"xbc", "bc"}, {"c", "cd"}, {"d", "da"}, {"xda", "~h"}});
}

TEST_CASE("loop: A-T2, a cut through a vertex: plus goes on along the cut, minus along the edge, and the other way") {
    // 0 -> - : the minus part starts at the vertex along its own edge, the plus part returns along the cut.
    const Parts down = split_letters("0-++");
    CHECK(down.minus == std::vector<Corner>{{"a", "ab"}, {"b", "bc"}, {"xbc", "h"}});
    CHECK(down.plus == std::vector<Corner>{{"a", "~h"}, {"xbc", "bc"}, {"c", "cd"}, {"d", "da"}});
    // 0 -> + : exchanged.
    const Parts up = split_letters("0+--");
    CHECK(up.minus == std::vector<Corner>{{"a", "h"}, {"xbc", "bc"}, {"c", "cd"}, {"d", "da"}});
    CHECK(up.plus == std::vector<Corner>{{"a", "ab"}, {"b", "bc"}, {"xbc", "~h"}});
}

TEST_CASE("loop: a diagonal through two vertices") {
    const Parts parts = split_letters("0-0+");
    CHECK(parts.minus == std::vector<Corner>{{"a", "ab"}, {"b", "bc"}, {"c", "h"}});
    CHECK(parts.plus == std::vector<Corner>{{"a", "~h"}, {"c", "cd"}, {"d", "da"}});
}

TEST_CASE("loop: every rotation of a loop gives the same cycles") {
    const auto cycle_of = [](std::vector<Corner> corners) {
        // Letters depend on the rotation, so only shapes are compared: how many corners, how many on the cut.
        std::size_t cuts = 0;
        for (const Corner& c : corners) cuts += c.edge == "h" || c.edge == "~h" ? 1 : 0;
        return std::pair(corners.size(), cuts);
    };
    for (const std::string signs : {"---+++", "0--+++", "0--0++", "0-0++", "-+", "--0+++", "-0+"}) {
        const Parts parts = split_letters(signs);
        for (std::size_t k = 1; k < signs.size(); ++k) {
            const Parts turned = split_letters(signs.substr(k) + signs.substr(0, k));
            CHECK(cycle_of(turned.minus) == cycle_of(parts.minus));
            CHECK(cycle_of(turned.plus) == cycle_of(parts.plus));
        }
        CHECK(cycle_of(parts.minus).second == 1);
        CHECK(cycle_of(parts.plus).second == 1);
    }
}
