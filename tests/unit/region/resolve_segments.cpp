// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/resolve_segments.hpp>
//
#include <cleave/query/measure.hpp>
#include <cleave/query/representation.hpp>
#include <cleave/region/make.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/setop/compare.hpp>
#include <cleave/setop/operators.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"
#include "support/exact_region.hpp"
#include "support/region_checker.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

using XY = std::array<Rational, 2>;
using Loop = std::vector<XY>;
using Loops = std::vector<Loop>;

/// Closed loops as the resolver takes them; edges are counted through as sources.
Boundary<2> segments(const Loops& loops, bool value_at_infinity = false) {
    Kernel<2> kernel;
    PointInterner<2> points(kernel);
    PolygonBuilder builder(kernel);
    std::uint32_t edge = 0;
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i, ++edge) {
            const PointId from = points(add_point<Rational, 2>(kernel, loop[i]));
            const PointId to = points(add_point<Rational, 2>(kernel, loop[(i + 1) % loop.size()]));
            if (from != to) builder.add(from, to, {0, edge});
        }
    }
    return freeze(kernel, builder.finish(), value_at_infinity, points);
}

Region<2> resolved(const Boundary<2>& boundary, WindingRule rule) {
    ProgressReporter silent;
    Region<2> r(SegmentResolver::resolve(boundary, rule, silent));
    support::RegionChecker<2>(r).verify();
    return r;
}

Region<2> resolved(const Loops& loops, WindingRule rule, bool value_at_infinity = false) {
    return resolved(segments(loops, value_at_infinity), rule);
}

std::vector<std::uint32_t> sources(const Region<2>& r) {
    std::vector<std::uint32_t> out;
    for (const FaceList::Face& face : r.boundary().faces.faces) out.push_back(face.source.face);
    std::sort(out.begin(), out.end());
    return out;
}

Loop rectangle(Rational x0, Rational y0, Rational x1, Rational y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Loop turned(Loop loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

/// How often loops run round a point on none of their edges, by the crossings of a ray in the direction of x.
int winding_number(const Loops& loops, const XY& p) {
    int winding = 0;
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const XY& a = loop[i];
            const XY& b = loop[(i + 1) % loop.size()];
            if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
            const Rational turn((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]));
            if (a[1] <= p[1] && turn > 0) ++winding;
            if (a[1] > p[1] && turn < 0) --winding;
        }
    }
    return winding;
}

}  // namespace

TEST_CASE("resolve segments: crossings become corners, and pieces face away from the set") {
    // A bow tie: one wing runs each way round.
    const Loops bow{{{0, 0}, {3, 2}, {3, 0}, {0, 2}}};
    const Rational half(1, 2);
    const XY crossing{Rational(3) * half, 1};
    const Region<2> left = resolved(bow, WindingRule::positive);
    CHECK(equal(left, polygon<Rational>(Loop{{0, 0}, crossing, {0, 2}})));
    const Region<2> both = resolved(bow, WindingRule::non_zero);
    CHECK(equal(both, left | polygon<Rational>(Loop{{3, 0}, {3, 2}, crossing})));
    CHECK(sources(both) == std::vector<std::uint32_t>{0, 0, 1, 2, 2, 3});
    const std::vector<XY> corners = vertices(both);
    CHECK(std::count(corners.begin(), corners.end(), crossing) == 1);
    CHECK(corners.size() == 5);
    CHECK(resolved({turned(bow[0])}, WindingRule::positive).face_count() == 3);
    CHECK(*measure(resolved({turned(bow[0])}, WindingRule::positive)) == Rational(3) * half);
}

TEST_CASE("resolve segments: what covers one another counts together, and the first gives the piece") {
    const Loop a = rectangle(0, 0, 4, 2);
    const Loop b = rectangle(1, 0, 3, 1);  // its lower edge is part of a's
    CHECK(sources(resolved({a, b}, WindingRule::non_zero)) == std::vector<std::uint32_t>{0, 1, 2, 3});
    CHECK(equal(resolved({a, b}, WindingRule::even_odd), polygon<Rational>(a) - polygon<Rational>(b)));
    CHECK(equal(resolved({a, turned(b)}, WindingRule::positive), polygon<Rational>(a) - polygon<Rational>(b)));
    // Side by side, one of them turned: the winding number is 1 on one side of the common edge and -1 on the other.
    const Loop c = rectangle(4, 0, 6, 2);
    CHECK(sources(resolved({a, c}, WindingRule::non_zero)) == std::vector<std::uint32_t>{0, 2, 3, 4, 5, 6});
    CHECK(equal(resolved({a, turned(c)}, WindingRule::non_zero), polygon<Rational>(rectangle(0, 0, 6, 2))));
    CHECK(equal(resolved({a, turned(c)}, WindingRule::positive), polygon<Rational>(a)));
    // Three times, of which one the other way round.
    CHECK(equal(resolved({a, a, turned(a)}, WindingRule::positive), polygon<Rational>(a)));
    CHECK(resolved({a, turned(a), a, turned(a)}, WindingRule::non_zero).is_empty());
    CHECK(sources(resolved({turned(a), a, a}, WindingRule::positive)) == std::vector<std::uint32_t>{0, 1, 2, 3});
    // Stretches that end inside each other.
    const Loops chain{rectangle(0, 0, 3, 1), rectangle(2, 0, 5, 1), rectangle(4, 0, 7, 1), rectangle(1, 0, 6, 1)};
    CHECK(equal(resolved(chain, WindingRule::positive), polygon<Rational>(rectangle(0, 0, 7, 1))));
    CHECK(*measure(resolved(chain, WindingRule::even_odd)) == 4);
}

TEST_CASE("resolve segments: a vertex inside a segment, several segments through one point") {
    const Loop floor = rectangle(0, 0, 6, 3);
    const Loop standing{{3, 3}, {5, 5}, {1, 5}};  // a corner in the middle of an edge
    CHECK(*measure(resolved({floor, standing}, WindingRule::positive)) == 22);
    CHECK(*measure(resolved({floor, turned(standing)}, WindingRule::positive)) == 18);
    // Long triangles through the origin.
    Loops fan;
    for (const auto& [x, y] : std::vector<std::pair<int, int>>{{4, 1}, {1, 4}, {-3, 2}, {2, -5}})
        fan.push_back({{-x, -y}, {x, y}, {x - y, y + x}});
    for (const WindingRule rule : all_winding_rules) {
        const Region<2> all = resolved(fan, rule);
        Loops cut;  // the same with a vertex in the origin
        for (const Loop& t : fan) cut.push_back({t[0], {0, 0}, t[1], t[2]});
        CHECK(equal(resolved(cut, rule), all));
        std::reverse(cut.begin(), cut.end());
        CHECK(equal(resolved(cut, rule), all));
    }
}

TEST_CASE("resolve segments: space of the other colour winds once more") {
    const Loop hole = turned(rectangle(0, 0, 4, 4));
    const Region<2> outside = ~polygon<Rational>(rectangle(0, 0, 4, 4));
    for (const WindingRule rule : all_winding_rules) CHECK(equal(resolved({hole}, rule, true), outside));
    // Another outline around the hole, and one in it.
    CHECK(resolved({hole, rectangle(-2, -2, 6, 6)}, WindingRule::positive, true).is_full());
    CHECK(equal(resolved({hole, rectangle(-2, -2, 6, 6)}, WindingRule::even_odd, true),
                outside ^ polygon<Rational>(rectangle(-2, -2, 6, 6))));
    CHECK(equal(resolved({hole, rectangle(1, 1, 2, 2)}, WindingRule::positive, true),
                outside | polygon<Rational>(rectangle(1, 1, 2, 2))));
    CHECK(resolved(Loops{}, WindingRule::positive, true).is_full());
    CHECK(resolved(Loops{}, WindingRule::positive).is_empty());
}

TEST_CASE("resolve segments: pieces shorter than doubles can tell, and lines steep, flat and far") {
    // Between two crossings that round to the same double there is a piece, and its middle is asked.
    Rational tiny(1);
    for (int n = 0; n < 90; ++n) tiny /= 2;
    const Loop wide = rectangle(0, 0, 4, 4);
    for (const XY& at : {XY{1, 1}, XY{Rational(1, 3), Rational(2, 7)}, XY{0, 0}, XY{3, 4}}) {
        const XY to{Rational(at[0] + tiny), Rational(at[1] + 3 * tiny)};
        const Loop speck = rectangle(at[0], at[1], to[0], to[1]);
        const Region<2> whole = polygon<Rational>(wide);
        const Region<2> part = polygon<Rational>(speck);
        CHECK(equal(resolved({wide, speck}, WindingRule::positive), whole | part));
        CHECK(equal(resolved({wide, speck}, WindingRule::even_odd), whole ^ part));
        CHECK(equal(resolved({speck, turned(wide)}, WindingRule::non_zero), whole ^ part));
        // A sliver along the diagonal, one end of which is the speck's width.
        const Loop sliver{at, {Rational(at[0] + 7), Rational(at[1] + 7)}, to};
        CHECK(equal(resolved({wide, turned(sliver)}, WindingRule::even_odd), whole ^ polygon<Rational>(sliver)));
    }
    Rational huge(1);
    for (int n = 0; n < 1020; ++n) huge *= 2;
    const Loops crossing{{{Rational(-huge), -1}, {huge, 1}, {huge, 3}}, {{-1, Rational(-huge)}, {1, huge}, {-3, huge}}};
    const Region<2> both = resolved(crossing, WindingRule::even_odd);
    CHECK(both.face_count() > 6);
    CHECK(*measure(resolved(crossing, WindingRule::non_zero)) > *measure(both));
}

TEST_CASE("resolve segments: motions, extra vertices and the order of loops change nothing") {
    Dice dice(12);
    const AffineMap<2, Integer> turn = rational_rotation<2, Integer>(0, 1, 7, 3);
    const auto mapped = [&](const Loop& loop) {
        Loop out;
        for (const XY& p : loop)
            out.push_back({Rational((Rational(20) * p[0] - Rational(21) * p[1]) / Rational(29)),
                           Rational((Rational(21) * p[0] + Rational(20) * p[1]) / Rational(29))});
        return out;
    };
    for (std::size_t n = 0; n < scaled(80); ++n) {
        Loops loops;
        for (int l = dice.between(1, 3); l > 0; --l) {
            loops.emplace_back();
            for (int i = dice.between(3, 8); i > 0; --i) loops.back().push_back({dice.below(5), dice.below(5)});
        }
        const WindingRule rule = all_winding_rules[std::size_t(dice.below(3))];
        const Region<2> expected = resolved(loops, rule);
        // What is resolved stays as it is, by any rule.
        for (const WindingRule again : all_winding_rules) CHECK(equal(resolved(expected.boundary(), again), expected));
        Loops other;
        for (const Loop& loop : loops) {
            other.emplace_back();
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const XY& p = loop[i];
                const XY& q = loop[(i + 1) % loop.size()];
                other.back().push_back(p);
                if (dice.below(3) == 0)
                    other.back().push_back(
                        {Rational((2 * p[0] + q[0]) / Rational(3)), Rational((2 * p[1] + q[1]) / Rational(3))});
            }
            std::rotate(other.back().begin(), other.back().begin() + 1, other.back().end());
        }
        std::reverse(other.begin(), other.end());
        CHECK(equal(resolved(other, rule), expected));
        for (Loop& loop : other) loop = turned(loop);
        if (rule != WindingRule::positive) CHECK(equal(resolved(other, rule), expected));
        Loops moved;
        for (const Loop& loop : loops) moved.push_back(mapped(loop));
        CHECK(*measure(resolved(moved, rule)) == *measure(expected));
        CHECK(resolved(moved, rule).face_count() == expected.face_count());
        CHECK(equal(resolved(transform(turn, expected).boundary(), rule), transform(turn, expected)));
        // Points of a lattice that no edge passes through.
        const support::ExactRegion<2> found(expected);
        for (int i = 0; i < 12; ++i) {
            const XY p{Rational(support::rational(dice.below(50), 10) + support::rational(1, 1009)),
                       Rational(support::rational(dice.below(50), 10) + support::rational(1, 100003))};
            CHECK((found.locate(p) == support::Where::inside) == is_inside(rule, winding_number(loops, p)));
        }
    }
}

TEST_CASE("resolve segments: it tells how far it is, and stops") {
    std::vector<std::string> stages;
    ProgressReporter told([&](std::string_view stage, double) { stages.emplace_back(stage); });
    const Boundary<2> b = segments({rectangle(0, 0, 4, 2), rectangle(1, 1, 3, 3)});
    CHECK(SegmentResolver::resolve(b, WindingRule::positive, told).faces.faces.size() == 7);
    CHECK(std::count(stages.begin(), stages.end(), "comparing segments") > 0);
    CHECK(std::count(stages.begin(), stages.end(), "resolving segments") > 0);
    std::stop_source stop;
    stop.request_stop();
    ProgressReporter stopped(stop.get_token());
    CHECK_THROWS_AS(SegmentResolver::resolve(b, WindingRule::positive, stopped), Cancelled);
}
