// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/crossing_table.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <cstdint>
#include <map>
#include <utility>

using namespace cleave;

TEST_CASE("crossing table: a crossing is new once, and its point stays while the table grows") {
    support::Dice dice(3);
    CrossingTable table;
    std::map<std::pair<std::uint64_t, std::uint64_t>, PointId> expected;
    for (int n = 0; n < 5000; ++n) {
        // Few edges and many faces, then the other way round, and operands in the upper halves.
        const auto edge = std::uint64_t(dice.between(0, n % 2 == 0 ? 3 : 400)) | std::uint64_t(n % 3) << 32U;
        const auto face = std::uint64_t(dice.between(0, n % 2 == 0 ? 400 : 3)) | std::uint64_t(n % 2) << 32U;
        PointId& point = table[{edge, face}];
        const auto [known, is_new] = expected.try_emplace({edge, face}, static_cast<PointId>(n));
        CHECK((point == no_id) == is_new);
        if (is_new) point = static_cast<PointId>(n);
        CHECK(point == known->second);
    }
    CHECK(table.size() == expected.size());
    for (const auto& [key, point] : expected) CHECK(table[{key.first, key.second}] == point);
    CHECK(table.size() == expected.size());
}
