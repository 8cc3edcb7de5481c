// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/planar_evaluation.hpp>
//
#include <cleave/query/measure.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/make.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"
#include "support/region_checker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

using Loop = std::vector<Coordinates<2>>;

Region<2> from_loops(const std::vector<Loop>& loops) {
    return verified(polygons<Rational>(loops));
}

Rational area(const Region<2>& r) {
    return ExactRegion<2>(r).measure();
}

/// The evaluation under test is what ran; its result is sound and that of boundary filtering.
Region<2> planar(const BooleanFunction& function, const std::vector<Region<2>>& operands,
                 OperationCounts* counts = nullptr) {
    std::vector<const Boundary<2>*> boundaries;
    for (const Region<2>& r : operands) boundaries.push_back(&r.boundary());
    REQUIRE(PlanarEvaluation::is_for(boundaries));
    OperationOptions options;
    options.counts = counts;
    PlanarEvaluation evaluation(boundaries, function, options);
    REQUIRE(evaluation.is_sound());
    Region<2> result(evaluation.finish());
    CHECK(canonical(result) == canonical(evaluate<2, Rational>(Engine::boundary_filter, function, operands)));
    const RegionChecker<2> checker(result);
    checker.verify();
    checker.verify_names(boundaries);
    return result;
}

Region<2> planar(Operation operation, const Region<2>& a, const Region<2>& b, OperationCounts* counts = nullptr) {
    return planar(BooleanFunction::from(operation, 2), {a, b}, counts);
}

/// All operations, with either operand inverted too. Returns: the area of the intersection.
Rational check_operations(const Region<2>& a, const Region<2>& b) {
    for (const Operation operation : all_operations) {
        planar(operation, a, b);
        planar(operation, b, a);
        planar(operation, ~a, b);
        planar(operation, ~a, ~b);
    }
    const Rational common = area(planar(Operation::intersection, a, b));
    CHECK(area(planar(Operation::union_, a, b)) == area(a) + area(b) - common);
    CHECK(area(planar(Operation::difference, a, b)) == area(a) - common);
    CHECK(area(planar(Operation::symmetric_difference, a, b)) == area(a) + area(b) - 2 * common);
    return common;
}

/// A polygon round a centre with corners at drawn distances: simple, its corners on the grid of 1/8.
Region<2> star(Dice& dice, int corners, int x, int y) {
    Loop loop;
    for (int n = 0; n < corners; ++n) {
        const double angle = 6.2831853 * n / corners;
        const double r = dice.between(16, 48);
        loop.push_back({Rational(x + std::round(8 * r * std::cos(angle)) / 8),
                        Rational(y + std::round(8 * r * std::sin(angle)) / 8)});
    }
    return polygon<Rational>(loop);
}

std::vector<Source> sources(const Region<2>& region) {
    std::vector<Source> list;
    for (const FaceList::Face& f : region.boundary().faces.faces) list.push_back(f.source);
    std::sort(list.begin(), list.end());
    return list;
}

}  // namespace

TEST_CASE("planar evaluation: two boxes in every relative position") {
    const Region<2> a = box<2>({0, 0}, {2, 2});
    // Along each axis: apart, touching, overlapping, with a common side inside, the same, and beyond on both sides.
    const std::array<std::array<int, 2>, 7> ends = {{{3, 4}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {-1, 3}}};
    const auto common = [](const std::array<int, 2>& e) { return std::max(0, std::min(2, e[1]) - std::max(0, e[0])); };
    for (const auto& x : ends)
        for (const auto& y : ends)
            CHECK(check_operations(a, box<2>({x[0], y[0]}, {x[1], y[1]})) == common(x) * common(y));
}

TEST_CASE("planar evaluation: crossings at points that are no doubles") {
    const Region<2> a = from_loops({{{0, 0}, {7, 1}, {2, 5}}});
    const Region<2> b = from_loops({{{1, -1}, {5, 4}, {-1, 3}}});
    check_operations(a, b);
    const Rational third = Rational(1) / 3;
    const Region<2> c = from_loops({{{third, third}, {7 * third, third}, {third, 10 * third}}});
    check_operations(a, c);
    check_operations(b, c);
}

TEST_CASE("planar evaluation: nested, with holes, and operands in each other's holes") {
    const Region<2> ring = from_loops({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{2, 2}, {2, 7}, {7, 7}, {7, 2}}});
    CHECK(check_operations(ring, box<2>({3, 3}, {6, 6})) == 0);
    CHECK(check_operations(ring, box<2>({2, 2}, {7, 7})) == 0);  // fills the hole
    CHECK(check_operations(ring, box<2>({-1, -1}, {10, 10})) == 56);
    CHECK(check_operations(ring, box<2>({0, 0}, {9, 9})) == 56);  // the same outside
    CHECK(check_operations(ring, box<2>({1, 1}, {8, 8})) == 24);
    CHECK(check_operations(ring, ring) == 56);
    CHECK(planar(Operation::union_, ring, box<2>({2, 2}, {7, 7})).face_count() == 4);
    OperationCounts counts;
    planar(Operation::union_, ring, box<2>({3, 3}, {6, 6}), &counts);
    CHECK(counts.face_pairs == 0);
    CHECK(counts.faces_crossed == 0);
    CHECK(counts.faces_whole == 12);
    CHECK(counts.faces_merged == 0);
    CHECK(counts.points_located == 1);  // of the box; all loops of the ring are outside its bounds
}

TEST_CASE("planar evaluation: touching at vertices, at a part of an edge, in a T") {
    const Region<2> a = box<2>({0, 0}, {4, 4});
    const auto none = [&](const Loop& loop) { CHECK(check_operations(a, from_loops({loop})) == 0); };
    none({{4, 4}, {6, 5}, {5, 6}});                                           // vertex at vertex
    none({{4, 2}, {6, 1}, {6, 3}});                                           // vertex on edge, from outside
    none({{-1, 3}, {1, 5}, {-1, 5}});                                         // edge at vertex
    none({{4, 1}, {6, 1}, {4, 3}});                                           // part of an edge
    none({{4, -1}, {6, -1}, {4, 5}});                                         // more than an edge
    none({{4, 3}, {6, 3}, {4, 6}});                                           // edges that overlap in part
    CHECK(check_operations(a, from_loops({{{4, 2}, {2, 3}, {2, 1}}})) == 2);  // vertex on edge, from inside
    CHECK(check_operations(a, from_loops({{{4, 4}, {1, 2}, {2, 1}}})) == area(from_loops({{{4, 4}, {1, 2}, {2, 1}}})));
    CHECK(check_operations(a, from_loops({{{0, 0}, {4, 0}, {2, 2}}})) == 4);  // a whole edge, from inside
    CHECK(check_operations(a, from_loops({{{2, 0}, {4, 2}, {2, 4}, {0, 2}}})) == 8);
    CHECK(check_operations(a, from_loops({{{0, -2}, {6, 4}, {4, 6}, {-2, 0}}})) == 12);  // through two vertices
}

TEST_CASE("planar evaluation: operands that touch themselves in vertices and on edges") {
    const Region<2> bow = from_loops({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}});
    CHECK(check_operations(bow, box<2>({0, 0}, {4, 2})) == 4);
    CHECK(check_operations(bow, box<2>({1, 1}, {3, 3})) == 2);
    CHECK(check_operations(bow, from_loops({{{2, 2}, {5, 1}, {5, 3}}})) == 0);
    CHECK(check_operations(bow, from_loops({{{2, 2}, {4, 0}, {4, 4}}})) == 0);
    CHECK(check_operations(bow, from_loops({{{-1, 2}, {5, 2}, {5, 3}, {-1, 3}}})) == 1);
    CHECK(check_operations(bow, from_loops({{{0, 0}, {4, 0}, {4, 4}}})) == 4);
    // A triangle hangs from the middle of an edge of the square around it: the edge passes a vertex without ending.
    const Region<2> hung = from_loops({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{4, 8}, {6, 4}, {2, 4}}});
    CHECK(area(hung) == 56);
    check_operations(hung, box<2>({0, 8}, {8, 9}));  // along that edge, from outside
    check_operations(hung, box<2>({4, 4}, {9, 8}));
    check_operations(hung, box<2>({3, 7}, {5, 9}));
    check_operations(hung, from_loops({{{4, 8}, {6, 10}, {2, 10}}}));
    check_operations(hung, from_loops({{{4, 8}, {2, 4}, {6, 4}}}));
    check_operations(hung, hung);
}

TEST_CASE("planar evaluation: the same and the opposite") {
    const Region<2> a = from_loops({{{0, 0}, {5, 1}, {3, 6}}});
    CHECK(canonical(planar(Operation::union_, a, a)) == canonical(a));
    CHECK(planar(Operation::symmetric_difference, a, a).is_empty());
    CHECK(planar(Operation::difference, a, a).is_empty());
    CHECK(planar(Operation::union_, a, ~a).is_full());
    CHECK(planar(Operation::intersection, a, ~a).is_empty());
    CHECK(planar(Operation::union_, a, Region<2>::full()).is_full());
    CHECK(canonical(planar(Operation::intersection, a, Region<2>::full())) == canonical(a));
    CHECK(canonical(planar(Operation::union_, Region<2>::empty(), a)) == canonical(a));
    CHECK(planar(Operation::union_, Region<2>::empty(), Region<2>::empty()).is_empty());
    CHECK(canonical(planar(~BooleanFunction::operand(0, 1), {a})) == canonical(~a));
    CHECK(planar(BooleanFunction::constant(true, 1), {a}).is_full());
}

TEST_CASE("planar evaluation: three operands, points that all of them share, and any function") {
    const Region<2> a = box<2>({0, 0}, {6, 6});
    const Region<2> b = from_loops({{{-2, 4}, {4, -2}, {8, 2}, {2, 8}}});
    // All three outlines pass through (2, 0), where nothing ends for the first two.
    const Region<2> c = from_loops({{{1, -2}, {5, 6}, {-3, 6}}});
    std::vector<Region<2>> operands{a, b, c};
    const auto f = [](unsigned i) { return BooleanFunction::operand(i, 3); };
    do {
        for (const Operation operation : all_operations) planar(BooleanFunction::from(operation, 3), operands);
        planar(BooleanFunction::at_least(2, 3), operands);
        planar((f(0) - f(1)) ^ (f(2) & ~f(0)), operands);
        planar(~f(2) | (f(0) & f(1)), operands);
        std::rotate(operands.begin(), operands.begin() + 1, operands.end());
    } while (operands.front().shared_boundary() != a.shared_boundary());
    // A fan: eight triangles with one common vertex, neighbours with a common side.
    const std::array<std::array<int, 2>, 8> rim = {
        {{3, 0}, {3, 3}, {0, 3}, {-3, 3}, {-3, 0}, {-3, -3}, {0, -3}, {3, -3}}};
    std::vector<Region<2>> fan;
    for (std::size_t n = 0; n < 8; ++n) {
        const auto& p = rim[n];
        const auto& q = rim[(n + 1) % 8];
        fan.push_back(from_loops({{{0, 0}, {p[0], p[1]}, {q[0], q[1]}}}));
    }
    CHECK(area(planar(BooleanFunction::union_(8), fan)) == 36);
    CHECK(planar(BooleanFunction::union_(8), fan).face_count() == 8);
    CHECK(area(planar(BooleanFunction::symmetric_difference(8), fan)) == 36);
    CHECK(planar(BooleanFunction::at_least(2, 8), fan).is_empty());
    for (std::size_t n = 0; n < 8; n += 2) fan[n] = ~fan[n];
    planar(BooleanFunction::symmetric_difference(8), fan);
    planar(BooleanFunction::at_least(4, 8), fan);
}

TEST_CASE("planar evaluation: sixty-four operands in a row, and all on one place") {
    std::vector<Region<2>> row;
    for (int i = 0; i < 64; ++i) row.push_back(box<2>({i, 0}, {i + 3, 1 + i % 2}));
    for (const unsigned m : {1U, 2U, 3U, 4U}) planar(BooleanFunction::at_least(m, 64), row);
    planar(BooleanFunction::symmetric_difference(64), row);
    planar(BooleanFunction::operand(63, 64) - BooleanFunction::operand(61, 64), row);
    const std::vector<Region<2>> same(64, row[0]);
    CHECK(canonical(planar(BooleanFunction::at_least(64, 64), same)) == canonical(row[0]));
    CHECK(planar(BooleanFunction::symmetric_difference(64), same).is_empty());
}

TEST_CASE("planar evaluation: the smallest and the largest coordinates") {
    for (const double unit : {1e-300, 1e300, 1e-3, 0x1p-1060}) {
        const auto at = [&](double x, double y) { return std::array<double, 2>{x * unit, y * unit}; };
        const Region<2> a(polygon<double>({at(0, 0), at(64, 0), at(64, 64), at(0, 64)}));
        const Region<2> b(polygon<double>({at(32, -16), at(80, 32), at(32, 80)}));
        const Region<2> c(polygon<double>({at(64, 32), at(96, 32), at(96, 96)}));
        check_operations(a, b);
        check_operations(a, c);
        check_operations(b, c);
    }
    // Beyond the doubles, and both at once.
    Rational large(1);
    for (int n = 0; n < 5; ++n) large *= Rational("1" + std::string(100, '0'));
    const Region<2> huge = from_loops({{{Rational(-large), Rational(-large)}, {large, 0}, {0, large}}});
    const Region<2> shifted = from_loops({{{0, 0}, {large, Rational(large / 3)}, {1, 2}}});
    check_operations(huge, shifted);
    check_operations(huge, box<2>({-1, -1}, {1, 1}));
    std::vector<Region<2>> spikes;
    for (int n = 0; n < 12; ++n)
        spikes.push_back(from_loops({{{n, 0}, {n + 1, 0}, {Rational(large + n), Rational(large / (n + 1))}}}));
    planar(BooleanFunction::union_(12), spikes);
}

TEST_CASE("planar evaluation: sources, and what comes back as it went in") {
    const Region<2> a = box<2>({0, 0}, {4, 4});
    const std::vector<Source> own{{0, 0}, {0, 1}, {0, 2}, {0, 3}};
    CHECK(sources(planar(BooleanFunction::union_(3), {a, a, a})) == own);
    OperationCounts counts;
    // Touched on all sides, and nothing lost.
    const Region<2> frame =
        planar(Operation::difference, a, planar(Operation::difference, box<2>({-1, -1}, {5, 5}), a), &counts);
    CHECK(counts.faces_whole == 4);
    CHECK(counts.faces_merged == 0);
    CHECK(counts.faces_crossed == 8);
    CHECK(sources(frame) == own);
    // Cut where another begins, and put together again where nothing comes of it.
    const Region<2> joined = planar(Operation::union_, a, box<2>({1, 1}, {3, 4}), &counts);
    CHECK(canonical(joined) == canonical(a));
    CHECK(counts.faces_whole == 4);
    CHECK(counts.faces_merged == 0);
    // A face of two stretches is one face.
    const Region<2> notched = planar(Operation::difference, a, box<2>({1, 3}, {3, 5}), &counts);
    CHECK(area(notched) == 14);
    CHECK(notched.face_count() == 7);
    CHECK(counts.faces_merged == 3);
    CHECK(counts.kernel.sides > 0);
    CHECK(counts.facets == 8);
    // A face of which a part is kept and a part turned gives two faces of one source.
    const std::vector<Source> odd = sources(planar(Operation::symmetric_difference, a, box<2>({2, 2}, {6, 6})));
    for (const std::uint32_t f : {1U, 2U}) CHECK(std::count(odd.begin(), odd.end(), Source{0, f}) == 2);
}

TEST_CASE("planar evaluation: many corners, and results as operands") {
    Dice dice(11);
    for (std::size_t n = 0; n < scaled(6); ++n) {
        const int corners = 20 << dice.below(4);
        const Region<2> a = star(dice, corners, 0, 0);
        const Region<2> b = star(dice, corners + 7, dice.between(-20, 20), dice.between(-20, 20));
        const Region<2> sum = planar(Operation::union_, a, b);
        const Region<2> odd = planar(Operation::symmetric_difference, a, b);
        CHECK(canonical(planar(Operation::symmetric_difference, odd, b)) == canonical(a));
        CHECK(canonical(planar(Operation::difference, sum, odd)) == canonical(planar(Operation::intersection, a, b)));
        planar(BooleanFunction::at_least(2, 4), {a, b, odd, sum});
        planar(BooleanFunction::at_least(2, 3), {a, star(dice, corners, 3, 3), star(dice, corners, 5, -7)});
    }
}

TEST_CASE("planar evaluation: many components that nothing touches") {
    Region<2> squares = Region<2>::empty();
    for (int x = 0; x < 6; ++x)
        for (int y = 0; y < 6; ++y) squares = squares | box<2>({4 * x, 4 * y}, {4 * x + 2, 4 * y + 2});
    const Region<2> diamond = from_loops({{{11, -9}, {31, 11}, {11, 31}, {-9, 11}}});
    OperationCounts counts;
    planar(Operation::intersection, squares, diamond, &counts);
    CHECK(counts.points_located > 8);  // enough for a hierarchy, were the other larger
    Dice dice(5);
    check_operations(squares, star(dice, 100, 11, 11));
    CHECK(planar(Operation::intersection, squares, ~squares).is_empty());
    CHECK(planar(Operation::union_, squares, ~squares).is_full());
}

TEST_CASE("planar evaluation: operands that intersect themselves end in a region or an error") {
    Dice dice(13);
    std::size_t sound = 0;
    std::size_t refused = 0;
    for (std::size_t n = 0; n < scaled(300); ++n) {
        std::array<Region<2>, 2> operands;
        try {
            for (Region<2>& r : operands) {
                Loop loop;
                for (int k = dice.between(3, 9); k > 0; --k) loop.push_back({dice.between(0, 6), dice.between(0, 6)});
                r = polygon<Rational>(loop);
            }
        } catch (const Error&) {
            continue;
        }
        const std::array<const Boundary<2>*, 2> boundaries{&operands[0].boundary(), &operands[1].boundary()};
        for (const Operation operation : all_operations) {
            const BooleanFunction function = BooleanFunction::from(operation, 2);
            PlanarEvaluation evaluation(boundaries, function, {});
            (evaluation.is_sound() ? sound : refused) += 1;
            try {
                const Region<2> r = apply(operation, operands[0], operands[1]);
                (void)apply(operation, r, operands[0]);
            } catch (const std::exception&) {  // where contracts are checked, trees may be first to tell
            }
        }
    }
    CHECK(sound > 0);
    CHECK(refused > 0);
}

TEST_CASE("planar evaluation: cancelled, it leaves the operands alone; watched, it goes from 0 to 1") {
    Dice dice(2);
    const std::vector<Region<2>> operands{star(dice, 50, 0, 0), star(dice, 50, 3, 4), star(dice, 20, 1, 1)};
    std::vector<std::string> before;
    for (const Region<2>& r : operands) before.push_back(dump(r.boundary()));
    const auto run = [&](ProgressReporter& progress) {
        OperationOptions options;
        options.progress = &progress;
        return evaluate<2, Rational>(BooleanFunction::union_(3), operands, options);
    };
    for (const double at : {-1.0, 0.0, 0.3, 0.9}) {
        std::stop_source stop;
        if (at < 0) stop.request_stop();
        double reached = 0;
        ProgressReporter progress(
            [&](std::string_view, double share) {
                reached = share;
                if (share >= at) stop.request_stop();
            },
            stop.get_token(), ProgressReporter::Clock::duration::zero());
        CHECK_THROWS_AS(run(progress), Cancelled);
        CHECK(reached < 1);
    }
    for (std::size_t i = 0; i < operands.size(); ++i) CHECK(dump(operands[i].boundary()) == before[i]);
    std::vector<double> shares;
    ProgressReporter watching([&](std::string_view, double share) { shares.push_back(share); }, {},
                              ProgressReporter::Clock::duration::zero());
    const Region<2> watched = run(watching);
    REQUIRE(!shares.empty());
    CHECK(shares.front() == 0);
    CHECK(shares.back() == 1);
    CHECK(std::is_sorted(shares.begin(), shares.end()));
    CHECK(dump(watched.boundary()) == dump(evaluate<2, Rational>(BooleanFunction::union_(3), operands).boundary()));
}
