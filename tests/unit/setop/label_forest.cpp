// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/label_forest.hpp>

#include "support/catch.hpp"
#include "support/convex_sets.hpp"

#include <vector>

using namespace cleave;
using namespace support;

TEST_CASE("label forest: what is learnt of one point holds for all that are joined to it, with the differences") {
    LabelForest forest(5);
    CHECK(forest.known(3) == 0);
    CHECK(forest.label(3) == 0);
    forest.join(0, 1, 0b01);
    forest.join(2, 1, 0b10);
    CHECK(forest.known(2) == 0);
    forest.learn(2, 0b01, 0b01);
    CHECK(forest.known(0) == 0b01);
    CHECK(forest.label(2) == 0b01);
    CHECK(forest.label(1) == 0b01);
    CHECK(forest.label(0) == 0b00);
    CHECK(forest.known(4) == 0);
    forest.learn(4, 0b10, 0b00);
    forest.join(4, 0, 0b11);
    CHECK(forest.known(2) == 0b11);
    CHECK(forest.label(4) == 0b01);
    CHECK(forest.label(0) == 0b10);
    CHECK(forest.label(1) == 0b11);
    CHECK(forest.label(2) == 0b01);
}

TEST_CASE("label forest: random labels are found again, in whatever order they are told") {
    for (unsigned seed = 0; seed < 50; ++seed) {
        Dice dice(seed);
        const std::size_t n = 200;
        std::vector<LabelForest::Bits> truth(n);
        for (auto& t : truth) t = LabelForest::Bits(dice.below(1 << 20)) << dice.below(40);
        LabelForest forest(n);
        // Sets: points with the same remainder.
        const int sets = dice.between(1, 7);
        std::vector<LabelForest::Bits> told(std::size_t(sets), 0);
        for (int step = 0; step < 2000; ++step) {
            const auto a = std::uint32_t(dice.below(int(n)));
            const auto b = std::uint32_t((a + unsigned(sets) * unsigned(dice.below(int(n)))) % n);
            if (int(a) % sets == int(b) % sets) forest.join(a, b, truth[a] ^ truth[b]);
            if (dice.below(50) == 0) {
                const LabelForest::Bits which = LabelForest::Bits(1) << dice.below(64);
                forest.learn(a, which, truth[a]);
                told[a % std::size_t(sets)] |= which;
            }
        }
        for (std::uint32_t a = 0; a < n; ++a)
            forest.join(a, a % std::uint32_t(sets), truth[a] ^ truth[a % std::uint32_t(sets)]);
        for (std::uint32_t a = 0; a < n; ++a) {
            CHECK(forest.known(a) == told[a % std::size_t(sets)]);
            CHECK(forest.label(a) == (truth[a] & forest.known(a)));
        }
    }
}
