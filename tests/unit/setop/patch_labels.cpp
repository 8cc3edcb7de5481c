// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/patch_labels.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

using Bits = PatchLabels::Bits;

}  // namespace

TEST_CASE("patch labels: what is learnt of one vertex holds for its patch, and along links for the linked bits") {
    PatchLabels labels(7);
    labels.join(0, 1);
    labels.join(2, 3);
    labels.link(1, 2, 0b011);
    labels.link(3, 4, 0b110);
    labels.learn(0, 0b111, 0b101);
    labels.close();
    CHECK(labels.known(1) == 0b111);
    CHECK(labels.label(1) == 0b101);
    CHECK(labels.known(3) == 0b011);
    CHECK(labels.label(2) == 0b001);
    CHECK(labels.known(4) == 0b010);
    CHECK(labels.label(4) == 0);
    CHECK(labels.known(5) == 0);
    labels.tell(3, 0b100, 0b100);
    CHECK(labels.known(4) == 0b110);
    CHECK(labels.label(4) == 0b100);
    CHECK(labels.label(0) == 0b101);
    labels.tell(5, 0b1, 0b1);
    CHECK(labels.label(5) == 0b1);
    CHECK(labels.is_consistent());
}

TEST_CASE("patch labels: a contradiction is noticed and has no effect") {
    PatchLabels said(2);
    said.learn(0, 1, 1);
    said.learn(1, 1, 0);
    said.link(0, 1, 1);
    said.close();
    CHECK_FALSE(said.is_consistent());
    PatchLabels told(1);
    told.close();
    told.tell(0, 1, 1);
    CHECK(told.is_consistent());
    told.tell(0, 3, 2);
    CHECK_FALSE(told.is_consistent());
    CHECK(told.label(0) == 3);
}

TEST_CASE("patch labels: random labels are found again, in whatever order they are said") {
    for (unsigned seed = 0; seed < 50; ++seed) {
        Dice dice(seed);
        const int n = 60;
        // Vertices with the same remainder have the same label; neighbours in the order of remainders share some bits.
        const int patches = dice.between(1, 7);
        std::vector<Bits> truth;
        for (int p = 0; p < patches; ++p) truth.push_back(Bits(dice.below(1 << 20)) << dice.below(40));
        PatchLabels labels(std::size_t(n) + 1);
        for (int v = patches; v < n; ++v) labels.join(std::uint32_t(v), std::uint32_t(v - patches));
        for (int p = 0; p + 1 < patches; ++p)
            labels.link(std::uint32_t(p), std::uint32_t(p + 1), ~(truth[std::size_t(p)] ^ truth[std::size_t(p) + 1]));
        const bool early = seed % 2 == 0;
        const int told = dice.below(n);
        const Bits which = truth[std::size_t(told % patches)] | Bits(dice.below(1 << 20));
        if (early) labels.learn(std::uint32_t(told), which, truth[std::size_t(told % patches)]);
        labels.close();
        if (!early) labels.tell(std::uint32_t(told), which, truth[std::size_t(told % patches)]);
        CHECK(labels.is_consistent());
        for (int v = 0; v < n; ++v) {
            // Known is what was told, less what some link on the way does not carry.
            Bits known = which;
            for (int p = std::min(v % patches, told % patches); p < std::max(v % patches, told % patches); ++p)
                known &= ~(truth[std::size_t(p)] ^ truth[std::size_t(p) + 1]);
            CHECK(labels.known(std::uint32_t(v)) == known);
            CHECK(labels.label(std::uint32_t(v)) == (truth[std::size_t(v % patches)] & known));
        }
        CHECK(labels.known(std::uint32_t(n)) == 0);
    }
}
