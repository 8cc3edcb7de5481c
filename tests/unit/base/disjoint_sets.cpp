// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/disjoint_sets.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <algorithm>
#include <vector>

using cleave::DisjointSets;

TEST_CASE("disjoint sets: the least number names a set, in whatever order it was made") {
    DisjointSets sets(6);
    for (std::uint32_t i = 0; i < 6; ++i) CHECK(sets.find(i) == i);
    sets.join(5, 3);
    sets.join(3, 5);
    sets.join(4, 5);
    CHECK(sets.find(4) == 3);
    sets.join(1, 4);
    CHECK(sets.find(5) == 1);
    CHECK(sets.find(0) == 0);
    CHECK(sets.find(2) == 2);
}

TEST_CASE("disjoint sets: the same as by renaming everything at each step") {
    support::Dice dice(5);
    DisjointSets sets(60);
    std::vector<std::uint32_t> names(60);
    for (std::uint32_t i = 0; i < 60; ++i) names[i] = i;
    for (int n = 0; n < 50; ++n) {
        const auto a = std::uint32_t(dice.below(60));
        const auto b = std::uint32_t(dice.below(60));
        sets.join(a, b);
        const std::uint32_t least = std::min(names[a], names[b]);
        const std::uint32_t gone = std::max(names[a], names[b]);
        std::replace(names.begin(), names.end(), gone, least);
        for (std::uint32_t i = 0; i < 60; ++i) CHECK(sets.find(i) == names[i]);
    }
}
