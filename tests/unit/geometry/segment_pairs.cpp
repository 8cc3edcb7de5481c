// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/segment_pairs.hpp>

#include <cleave/number/rational.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;
using Segments = std::vector<NamedSegment>;

struct Found {
    Pairs pairs;
    std::size_t visits = 0;
};

Found near_pairs(const Segments& a, const Segments& b) {
    Found found;
    for_each_near_pair(a, b, [&](std::uint32_t i, std::uint32_t j) {
        found.pairs.insert({i, j});
        ++found.visits;
    });
    return found;
}

/// The sign of the turn p, q, r.
int turn(const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 2>& r) {
    const auto exact = [](double x) { return number_traits<Rational>::from_double(x); };
    const Rational left = (exact(q[0]) - exact(p[0])) * (exact(r[1]) - exact(p[1]));
    const Rational right = (exact(q[1]) - exact(p[1])) * (exact(r[0]) - exact(p[0]));
    return left < right ? -1 : (left > right ? 1 : 0);
}

bool have_common_point(const NamedSegment& s, const NamedSegment& t) {
    for (std::size_t i = 0; i < 2; ++i)
        if (std::max(s.from[i], s.to[i]) < std::min(t.from[i], t.to[i]) ||
            std::max(t.from[i], t.to[i]) < std::min(s.from[i], s.to[i]))
            return false;
    return turn(s.from, s.to, t.from) * turn(s.from, s.to, t.to) <= 0 &&
           turn(t.from, t.to, s.from) * turn(t.from, t.to, s.to) <= 0;
}

/// Every pair with a common point is among those that were visited.
void check_all_found(const Segments& a, const Segments& b) {
    const Found found = near_pairs(a, b);
    std::size_t missed = 0;
    for (const NamedSegment& s : a)
        for (const NamedSegment& t : b)
            if (have_common_point(s, t) && found.pairs.count({s.name, t.name}) == 0) ++missed;
    CHECK(missed == 0);
}

NamedSegment segment(std::array<double, 2> from, std::array<double, 2> to, std::size_t name) {
    NamedSegment s;
    s.from = from;
    s.to = to;
    s.name = static_cast<std::uint32_t>(name);
    return s;
}

/// Segments from points of a ring to points of a larger one, like the spikes of a star.
Segments spikes(std::size_t count, double turned) {
    Segments list;
    for (std::size_t n = 0; n < count; ++n) {
        const double a = (double(n) + turned) * 6.28 / double(count);
        list.push_back(segment({std::cos(a), std::sin(a)}, {3 * std::cos(a + 0.001), 3 * std::sin(a + 0.001)}, n));
    }
    return list;
}

}  // namespace

TEST_CASE("segment pairs: all that have a common point are found") {
    Dice dice(3);
    for (std::size_t n = 0; n < scaled(400); ++n) {
        const int range = dice.below(2) == 0 ? 6 : 40;
        const int reach = dice.below(2) == 0 ? 3 : range;
        const double scale = std::array<double, 4>{1, 1.0 / 3, 1e-300, 1e300}[std::size_t(dice.below(4))];
        const auto draw = [&] {
            Segments list;
            for (int k = dice.between(0, 60); k > 0; --k) {
                const std::array<int, 2> p{dice.below(range), dice.below(range)};
                list.push_back(segment(
                    {p[0] * scale, p[1] * scale},
                    {(p[0] + dice.between(-reach, reach)) * scale, (p[1] + dice.between(-reach, reach)) * scale},
                    list.size()));
            }
            return list;
        };
        check_all_found(draw(), draw());
    }
}

TEST_CASE("segment pairs: bundles of long segments are parted along them") {
    const Segments a = spikes(2000, 0);
    const Segments b = spikes(2000, 0.5);
    // Hardly one of these meets another, but nearly all boxes of spikes in one quarter meet.
    CHECK(near_pairs(a, b).visits < 40'000);
    Segments few(a.begin(), a.begin() + 300);
    check_all_found(few, spikes(300, 0.3));
    check_all_found(few, few);
}

TEST_CASE("segment pairs: segments through one point are all compared") {
    Segments list;
    for (std::size_t n = 0; n < 40; ++n)
        list.push_back(segment({-double(n), -20.0 + double(n)}, {double(n), 20.0 - double(n)}, n));
    CHECK(near_pairs(list, list).pairs.size() == 1600);
}

TEST_CASE("segment pairs: what is known of the ends up to an error is found within it") {
    // Two rows of segments that miss each other by less than their errors.
    Segments a;
    Segments b;
    for (std::size_t n = 0; n < 30; ++n) {
        const double y = double(n);
        a.push_back(segment({0, y}, {1, y}, n));
        b.push_back(segment({0, y + 0.5}, {1, y + 0.5}, n));
        a.back().error = b.back().error = 0.3;
    }
    const Found found = near_pairs(a, b);
    for (std::uint32_t n = 0; n < 30; ++n) CHECK(found.pairs.count({n, n}) == 1);
    // Nothing is known of a point beyond the doubles.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (NamedSegment& s : a) s.error = infinity;
    for (NamedSegment& s : b) s.to = {infinity, infinity};
    CHECK(near_pairs(a, b).pairs.size() == 900);
}

TEST_CASE("segment pairs: empty sets have none") {
    CHECK(near_pairs({}, spikes(10, 0)).visits == 0);
    CHECK(near_pairs(spikes(100, 0), {}).visits == 0);
}
