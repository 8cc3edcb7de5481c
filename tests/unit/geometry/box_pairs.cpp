// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/box_pairs.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Both sets as they were, so that an order left behind by one call cannot help the next.
Pairs meeting(std::vector<NamedBox<3>> a, std::vector<NamedBox<3>> b) {
    Pairs found;
    for_each_meeting_pair<3>(a, b, [&](std::uint32_t x, std::uint32_t y) { found.push_back({x, y}); });
    std::sort(found.begin(), found.end());
    return found;
}

Pairs by_force(const std::vector<NamedBox<3>>& a, const std::vector<NamedBox<3>>& b) {
    Pairs found;
    for (const auto& x : a)
        for (const auto& y : b)
            if (!x.box.disjoint(y.box)) found.push_back({x.name, y.name});
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<NamedBox<3>> boxes(Dice& dice, std::size_t count, int range, int size) {
    std::vector<NamedBox<3>> out(count);
    for (std::uint32_t n = 0; n < count; ++n) {
        out[n].name = n;
        for (std::size_t i = 0; i < 3; ++i) {
            out[n].box.lo[i] = dice.between(-range, range);
            out[n].box.hi[i] = out[n].box.lo[i] + dice.between(0, size);
        }
    }
    return out;
}

}  // namespace

TEST_CASE("box pairs: the same as by trying all, touching included, each once") {
    Dice dice(3);
    for (std::size_t n = 0; n < scaled(60); ++n) {
        const auto a = boxes(dice, std::size_t(dice.between(0, 300)), dice.between(1, 40), dice.between(0, 6));
        const auto b = boxes(dice, std::size_t(dice.between(0, 300)), dice.between(1, 40), dice.between(0, 60));
        CHECK(meeting(a, b) == by_force(a, b));
    }
}

TEST_CASE("box pairs: many equal boxes, and long thin ones among small ones") {
    Dice dice(4);
    std::vector<NamedBox<3>> a = boxes(dice, 200, 20, 2);
    std::vector<NamedBox<3>> b = boxes(dice, 200, 20, 2);
    for (std::uint32_t n = 0; n < 200; n += 2) a[n].box = a[0].box;
    for (std::uint32_t n = 0; n < 200; n += 3) {
        b[n].box.lo[n % 3] = -100;
        b[n].box.hi[n % 3] = 100;
    }
    CHECK(meeting(a, b) == by_force(a, b));
    CHECK(meeting(a, {}).empty());
    CHECK(meeting({}, b).empty());
}

TEST_CASE("box pairs: boxes that crowd ever closer to a point, and boxes without end") {
    Dice dice(8);
    for (std::size_t n = 0; n < scaled(40); ++n) {
        std::vector<NamedBox<3>> a = boxes(dice, 150, 6, 2);
        std::vector<NamedBox<3>> b = boxes(dice, 150, 6, 2);
        for (auto* set : {&a, &b})
            for (NamedBox<3>& box : *set) {
                const int scale = -dice.between(0, 60);
                for (std::size_t x = 0; x < 3; ++x) {
                    box.box.lo[x] = std::ldexp(box.box.lo[x], scale);
                    box.box.hi[x] = std::ldexp(box.box.hi[x], scale);
                    if (dice.between(0, 30) == 0) box.box.lo[x] = -std::numeric_limits<double>::infinity();
                    if (dice.between(0, 30) == 0) box.box.hi[x] = std::numeric_limits<double>::infinity();
                }
            }
        CHECK(meeting(a, b) == by_force(a, b));
    }
}

TEST_CASE("box pairs: within one set, the same as by trying all") {
    Dice dice(5);
    for (std::size_t n = 0; n < scaled(60); ++n) {
        const auto all = boxes(dice, std::size_t(dice.between(0, 300)), dice.between(1, 40), dice.between(0, 20));
        Pairs found;
        auto copy = all;
        for_each_meeting_pair<3>(copy, [&](std::uint32_t x, std::uint32_t y) { found.push_back(std::minmax(x, y)); });
        std::sort(found.begin(), found.end());
        Pairs expected = by_force(all, all);
        expected.erase(std::remove_if(expected.begin(), expected.end(),
                                      [](const auto& pair) { return pair.first >= pair.second; }),
                       expected.end());
        CHECK(found == expected);
    }
}
