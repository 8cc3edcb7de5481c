// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/rough_box.hpp>
//
#include <cleave/geometry/box_pairs.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of very different sizes, many of them equal or neighbours.
double draw(Dice& dice, int range) {
    const double x = std::ldexp(double(dice.between(-8, 8)), dice.between(-range, range));
    switch (dice.between(0, 3)) {
        case 0:
            return std::nextafter(x, infinity);
        case 1:
            return std::nextafter(x, -infinity);
        default:
            return x;
    }
}

Bounds<3> box(Dice& dice, int range) {
    Bounds<3> b;
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = draw(dice, range);
        const double y = draw(dice, range);
        b.lo[i] = std::min(x, y);
        b.hi[i] = std::max(x, y);
        if (dice.between(0, 40) == 0) b.lo[i] = -infinity;
        if (dice.between(0, 40) == 0) b.hi[i] = infinity;
    }
    return b;
}

}  // namespace

TEST_CASE("rough boxes: the map keeps the order of coordinates, whatever region it is made for") {
    Dice dice(41);
    for (int n = 0; n < 20000; ++n) {
        const int range = std::array{2, 60, 1000}[std::size_t(dice.between(0, 2))];
        const RoughMap map(box(dice, range));
        std::array<double, 3> p{};
        std::array<double, 3> q{};
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = draw(dice, range);
            q[i] = draw(dice, range);
            if (q[i] < p[i]) std::swap(p[i], q[i]);
        }
        const rough::Four a = map(p);
        const rough::Four b = map(q);
        CHECK(a[0] <= b[0]);
        CHECK(a[1] <= b[1]);
        CHECK(a[2] <= b[2]);
    }
}

TEST_CASE("rough boxes: boxes that meet still do, and a box keeps its name") {
    Dice dice(42);
    std::array<int, 2> answers{};
    for (int n = 0; n < 20000; ++n) {
        const int range = std::array{2, 60, 1000}[std::size_t(dice.between(0, 2))];
        const RoughMap map(box(dice, range));
        const Bounds<3> a = box(dice, range);
        const Bounds<3> b = box(dice, range);
        const auto name = static_cast<std::uint32_t>(dice.between(0, 1 << 30)) + (n % 2 == 0 ? 0U : 1U << 30U);
        const NamedRoughBox x(map(a), name);
        const NamedRoughBox y(map(b), std::uint32_t(n));
        CHECK(x.id() == name);
        CHECK(y.id() == std::uint32_t(n));
        if (!a.disjoint(b)) CHECK(!x.box.disjoint(y.box));
        ++answers[x.box.disjoint(y.box) ? 1 : 0];
        RoughBounds both = x.box;
        both.include(y.box);
        CHECK(both.contains(x.box));
        CHECK(both.contains(y.box));
        CHECK(x.box.contains(both) == (x.box.contains(y.box)));
    }
    CHECK(answers[0] > 1000);
    CHECK(answers[1] > 1000);
}

TEST_CASE("rough boxes: small integers are told apart exactly") {
    Dice dice(43);
    Bounds<3> region;
    region.include({-20, -20, -20}, 0);
    region.include({20, 20, 20}, 0);
    const RoughMap map(region);
    std::array<std::vector<NamedRoughBox>, 2> sets;
    std::array<std::vector<Bounds<3>>, 2> exact;
    for (std::uint32_t n = 0; n < 300; ++n)
        for (const std::size_t k : {0U, 1U}) {
            Bounds<3> b;
            std::array<double, 3> p{};
            for (double& x : p) x = dice.between(-20, 15);
            b.include(p, 0);
            for (double& x : p) x += dice.between(0, 5);
            b.include(p, 0);
            exact[k].push_back(b);
            sets[k].push_back({map(b), n});
        }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected, found;
    for (std::uint32_t a = 0; a < 300; ++a)
        for (std::uint32_t b = 0; b < 300; ++b)
            if (!exact[0][a].disjoint(exact[1][b])) expected.push_back({a, b});
    using Group = BoxGroup<NamedRoughBox>;
    for_each_meeting_pair(
        Group(sets[0]), Group(sets[1]),
        [&](std::uint32_t a, std::uint32_t b) {
            found.push_back({a, b});
        },
        [](std::size_t) {}, [](const Group&, const Group&) { return false; });
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
    CHECK(found.size() > 100);
}
