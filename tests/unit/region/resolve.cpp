// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/resolve.hpp>
//
#include "support/catch.hpp"
#include "support/dice.hpp"
#include "support/region_checker.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

using namespace cleave;

namespace {

using Point = std::array<Rational, 2>;
using Loop = std::vector<Point>;
using Loops = std::vector<Loop>;

Region<2> resolved(const Loops& loops, WindingRule rule) {
    Region<2> r = resolve<Rational>(std::span<const Loop>(loops), rule);
    support::RegionChecker<2>(r).verify();
    return r;
}

std::array<Rational, 3> areas(const Loops& loops) {
    std::array<Rational, 3> v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = *measure(resolved(loops, all_winding_rules[i]));
    return v;
}

using V = std::array<Rational, 3>;

Loop square(int lo, int hi) {
    return {{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}};
}

Loop turned(Loop loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

/// Sum over the edges that cross the ray from p in the direction of x, in integers; nothing where one contains p or
/// the ray passes a corner.
std::optional<int> winding_number(const std::vector<std::vector<std::array<std::int64_t, 2>>>& loops,
                                  const std::array<std::int64_t, 2>& p) {
    int winding = 0;
    for (const auto& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto& a = loop[i];
            const auto& b = loop[(i + 1) % loop.size()];
            if (a[1] == p[1] || b[1] == p[1]) return std::nullopt;
            if ((a[1] < p[1]) == (b[1] < p[1])) continue;
            const std::int64_t s = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            if (s == 0) return std::nullopt;
            if (a[1] < p[1] && s > 0) ++winding;
            if (a[1] > p[1] && s < 0) --winding;
        }
    }
    return winding;
}

}  // namespace

TEST_CASE("resolve in the plane: a pentagram by each rule") {
    // Points of a circle of rational points, every second one in turn.
    const Loop star{{0, 5}, {-3, -4}, {5, 0}, {-5, 0}, {3, -4}};
    const V v = areas({star});
    CHECK(v[0] == v[1]);
    CHECK(v[2] < v[1]);  // without the pentagon in the middle
    CHECK(v[2] > 0);
    CHECK(areas({turned(star)}) == V{0, v[1], v[2]});
    // Each edge is kept at its ends and turned round in the middle.
    CHECK(resolved({star}, WindingRule::even_odd).face_count() == 10);
    // The middle is where the winding number is 2: what two copies have too much.
    const Region<2> middle = resolved({star}, WindingRule::non_zero) - resolved({star}, WindingRule::even_odd);
    CHECK(*measure(middle) == v[1] - v[2]);
    CHECK(middle.face_count() == 5);
}

TEST_CASE("resolve in the plane: loops over one another") {
    CHECK(areas({square(0, 2)}) == V{4, 4, 4});
    CHECK(areas({turned(square(0, 2))}) == V{0, 4, 4});
    CHECK(areas({square(0, 2), square(0, 2)}) == V{4, 4, 0});
    CHECK(areas({square(0, 2), turned(square(0, 2))}) == V{0, 0, 0});
    CHECK(areas({square(0, 2), square(1, 3)}) == V{7, 7, 6});
    CHECK(areas({square(0, 2), turned(square(1, 3))}) == V{3, 6, 6});
    CHECK(areas({square(0, 4), square(1, 3)}) == V{16, 16, 12});
    CHECK(areas({square(0, 4), turned(square(1, 3))}) == V{12, 12, 12});
    CHECK(areas({square(0, 2), square(2, 4)}) == V{8, 8, 8});
    // Side by side: the edge between them vanishes where both face outward, and stays where one does not.
    const Loop right{{2, 1}, {4, 1}, {4, 3}, {2, 3}};
    CHECK(areas({square(0, 2), right}) == V{8, 8, 8});
    CHECK(areas({square(0, 2), turned(right)}) == V{4, 8, 8});
}

TEST_CASE("resolve in the plane: a bow tie, a loop to and fro, a point, nothing") {
    CHECK(areas({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}) == V{1, 2, 2});
    CHECK(areas({{{0, 0}, {2, 2}}}) == V{0, 0, 0});
    CHECK(areas({{{0, 0}, {2, 0}, {1, 0}}}) == V{0, 0, 0});
    CHECK(areas({{{1, 1}}, {{1, 1}, {1, 1}}, {}}) == V{0, 0, 0});
    CHECK(areas({}) == V{0, 0, 0});
    CHECK(*measure(resolve<Rational>({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, WindingRule::non_zero)) == 2);
}

TEST_CASE("resolve in the plane: what does not cross stays as it is") {
    const Loop l{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    const Region<2> r = resolved({l}, WindingRule::positive);
    CHECK(equal(r, polygon<Rational>(l)));
    for (std::uint32_t i = 0; i < 6; ++i) CHECK(r.boundary().faces.faces[i].source == Source{0, i});
}

TEST_CASE("resolve in the plane: a boundary of the other colour") {
    const Region<2> outside = ~polygon<Rational>(square(0, 2));
    CHECK(equal(Region<2>(resolve<2>(outside.boundary(), WindingRule::positive)), outside));
    CHECK(equal(Region<2>(resolve<2>(outside.boundary(), WindingRule::even_odd)), outside));
}

TEST_CASE("resolve of a boundary: the same region, of whatever dimension") {
    const Region<3> a = box<3>({0, 0, 0}, {2, 2, 2}) - box<3>({1, 1, 1}, {3, 3, 3});
    for (const WindingRule rule : all_winding_rules) {
        CHECK(equal(Region<3>(resolve<3>(a.boundary(), rule)), a));
        CHECK(equal(Region<3>(resolve<3>((~a).boundary(), rule)), ~a));
    }
}

TEST_CASE("resolve in the plane: random loops have the winding numbers that a ray counts") {
    support::Dice dice(31);
    std::size_t compared = 0;
    for (std::size_t n = 0; n < scaled(300); ++n) {
        Loops loops;
        std::vector<std::vector<std::array<std::int64_t, 2>>> scaled_loops;
        const int range = dice.between(1, 8);
        const int denominator = dice.between(1, 3);
        for (int l = dice.between(1, 3); l > 0; --l) {
            loops.emplace_back();
            scaled_loops.emplace_back();
            for (int i = dice.between(1, 9); i > 0; --i) {
                const int x = dice.below(range + 1);
                const int y = dice.below(range + 1);
                loops.back().push_back({Rational(x) / denominator, Rational(y) / denominator});
                scaled_loops.back().push_back({60 * x / denominator, 60 * y / denominator});
            }
        }
        for (const WindingRule rule : all_winding_rules) {
            const support::ExactRegion<2> found(resolved(loops, rule));
            for (int i = 0; i < 20; ++i) {
                const std::array<std::int64_t, 2> p{dice.below(60 * range), dice.below(60 * range)};
                const auto winding = winding_number(scaled_loops, p);
                if (!winding) continue;
                ++compared;
                CAPTURE(n, to_text(rule), *winding);
                CHECK((found.locate({support::rational(p[0], 60), support::rational(p[1], 60)}) ==
                       support::Where::inside) == is_inside(rule, *winding));
            }
        }
    }
    CHECK(compared > scaled(12000));
}
