// SPDX-License-Identifier: Apache-2.0
#include <cleave/region/canonical.hpp>
#include <cleave/setop/apply.hpp>
#include <cleave/setop/engines.hpp>
//
#include "support/catch.hpp"
#include "support/cuboids.hpp"
#include "support/region_checker.hpp"

#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/prism.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

Region<3> cube(int low, int high) {
    return box<3>({low, low, low}, {high, high, high});
}

template <int D>
Rational size(const Region<D>& r) {
    return ExactRegion<D>(r).measure();
}

Region<3> evaluated(const BooleanFunction& function, const std::vector<Region<3>>& operands) {
    return checked_evaluate<3, Rational>(function, operands);
}

/// The sources of all faces, sorted.
template <int D>
std::vector<Source> sources(const Region<D>& region) {
    std::vector<Source> list;
    for (const FaceList::Face& f : region.boundary().faces.faces) list.push_back(f.source);
    std::sort(list.begin(), list.end());
    return list;
}

/// The loops of face f as places.
const std::vector<std::vector<Coordinates<3>>>& loops(const ExactRegion<3>& region, std::size_t f) {
    return region.faces()[f].loops;
}

}  // namespace

TEST_CASE("evaluate: at least m of three cubes, and an odd number of them") {
    const std::vector<Region<3>> cubes{cube(0, 3), cube(1, 4), cube(2, 5)};
    // 8 in the first two and in the last two, 1 in all.
    CHECK(evaluated(BooleanFunction::at_least(0, 3), cubes).is_full());
    CHECK(size(evaluated(BooleanFunction::at_least(1, 3), cubes)) == 81 - 17 + 1);
    CHECK(size(evaluated(BooleanFunction::at_least(2, 3), cubes)) == 17 - 2);
    CHECK(equal_sets(evaluated(BooleanFunction::at_least(3, 3), cubes), cube(2, 3)));
    CHECK(evaluated(BooleanFunction::at_least(4, 3), cubes).is_empty());
    CHECK(size(evaluated(BooleanFunction::symmetric_difference(3), cubes)) == 81 - 34 + 4);
    CHECK(size(evaluated(BooleanFunction::difference(3), cubes)) == 27 - 8);
    CHECK(size(verified(~evaluated(~BooleanFunction::at_least(2, 3), cubes))) == 15);
}

TEST_CASE("evaluate: an expression at once is the expression step by step") {
    const Region<3> a = cube(0, 3);
    const Region<3> b = ~cube(1, 4);
    const Region<3> c = box<3>({0, 0, 1}, {3, 5, 3});  // shares planes and edges with both
    const auto f = [](unsigned i) { return BooleanFunction::operand(i, 3); };
    const Region<3> once = evaluated((f(0) - f(1)) ^ (f(2) & ~f(0)), {a, b, c});
    CHECK(equal_sets(once, (a - b) ^ (c & ~a)));
    const Region<3> unbounded = evaluated((f(1) | f(0)) - f(2), {a, b, c});
    CHECK(!unbounded.is_bounded());
    CHECK(equal_sets(unbounded, (b | a) - c));
    // The order of operands does not matter to a symmetric function.
    for (const Operation op : {Operation::union_, Operation::intersection, Operation::symmetric_difference})
        CHECK(equal_sets(evaluated(BooleanFunction::from(op, 3), {a, b, c}),
                         evaluated(BooleanFunction::from(op, 3), {c, b, a})));
}

TEST_CASE("evaluate: operands that do not matter, that repeat, and functions that are constant") {
    const std::vector<Region<3>> cubes{cube(0, 3), cube(1, 4), cube(2, 5)};
    const Region<3> second = evaluated(BooleanFunction::operand(1, 3), cubes);
    CHECK(equal_sets(second, cubes[1]));
    CHECK(second.face_count() == 6);
    for (const Source& s : sources(second)) CHECK(s.operand == 1);
    CHECK(evaluated(BooleanFunction::constant(true, 3), cubes).is_full());
    CHECK(evaluated(BooleanFunction::constant(false, 3), cubes).is_empty());
    const std::vector<Region<3>> same(4, cubes[0]);
    CHECK(equal_sets(evaluated(BooleanFunction::at_least(4, 4), same), cubes[0]));
    CHECK(evaluated(BooleanFunction::symmetric_difference(4), same).is_empty());
    CHECK(evaluated(BooleanFunction::difference(4), same).is_empty());
}

TEST_CASE("evaluate: sixty-four operands") {
    // [i, i + 3] for i = 0 .. 63: 1, 2, 3, ..., 3, 2, 1 operands over unit intervals; all share the lines y = 0, 1.
    std::vector<Region<1>> line;
    std::vector<Region<2>> strip;
    for (int i = 0; i < 64; ++i) {
        line.push_back(intervals({{i, i + 3}}));
        strip.push_back(box<2>({i, 0}, {i + 3, 1}));
    }
    const auto check = [&](const BooleanFunction& function, const Region<1>& expected) {
        const Region<1> r = checked_evaluate<1, Rational>(function, line);
        CHECK(equal_sets(r, expected));
        CHECK(size(checked_evaluate<2, Rational>(function, strip)) == size(expected));
    };
    check(BooleanFunction::union_(64), intervals({{0, 66}}));
    check(BooleanFunction::at_least(2, 64), intervals({{1, 65}}));
    check(BooleanFunction::at_least(3, 64), intervals({{2, 64}}));
    check(BooleanFunction::symmetric_difference(64), intervals({{0, 1}, {2, 64}, {65, 66}}));
    check(BooleanFunction::difference(64), intervals({{0, 1}}));
    check(BooleanFunction::at_least(4, 64), Region<1>::empty());
    const BooleanFunction last = BooleanFunction::operand(63, 64);
    check(last - BooleanFunction::operand(61, 64), intervals({{64, 66}}));
    // The lower end of [63, 66] is the upper end of [60, 63]: the lower operand stands for both.
    CHECK(sources(evaluate<1, Rational>(last, line)) == std::vector<Source>{{60, 1}, {63, 1}});
}

TEST_CASE("evaluate: sources name operand and face, of coincident faces the lowest operand's") {
    const Region<3> a = cube(0, 4);
    const Region<3> inner = cube(1, 2);
    // Flipped faces, too.
    const Region<3> hollow = evaluated(BooleanFunction::difference(2), {a, inner});
    std::vector<Source> expected;
    for (std::uint32_t f = 0; f < 12; ++f) expected.push_back({f / 6, f % 6});
    CHECK(sources(hollow) == expected);
    CHECK(sources(evaluated(BooleanFunction::union_(3), {a, a, a})) ==
          std::vector<Source>(expected.begin(), expected.begin() + 6));
    // Faces -x, +x, -y, +y, -z, +z. The neighbour's -x face and the cube's +x face cancel; the rest stays apart.
    const Region<3> pair = evaluated(BooleanFunction::union_(2), {a, box<3>({4, 0, 0}, {5, 4, 4})});
    CHECK(sources(pair) ==
          std::vector<Source>{{0, 0}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {1, 1}, {1, 2}, {1, 3}, {1, 4}, {1, 5}});
    // A face of which a part is kept and a part flipped gives two faces of one source.
    const Region<3> odd = evaluated(BooleanFunction::symmetric_difference(2), {a, box<3>({2, 2, 2}, {6, 6, 6})});
    for (const std::uint32_t f : {1U, 3U, 5U}) {
        const auto list = sources(odd);
        CHECK(std::count(list.begin(), list.end(), Source{0, f}) == 2);
    }
    // A face in several pieces is one face.
    const Region<3> cut = evaluated(BooleanFunction::difference(2), {a, box<3>({1, -1, -1}, {2, 5, 5})});
    const auto list = sources(cut);
    CHECK(std::count(list.begin(), list.end(), Source{0, 2}) == 1);
    CHECK(cut.face_count() == 8);
}

TEST_CASE("evaluate: what no other operand touches comes back as it went in") {
    // Non-convex faces with holes and straight corners, both kept and flipped.
    const Region<3> plate = prism<Rational>({{0, 0}, {4, 0}, {9, 0}, {9, 4}, {5, 4}, {5, 9}, {0, 9}}, 0, 2) -
                            prism<Rational>({{1, 1}, {4, 2}, {2, 4}}, -1, 3);
    const Region<3> far = box<3>({20, 0, 0}, {22, 2, 2});
    const Region<3> around = box<3>({-1, -1, -1}, {30, 10, 3});
    const ExactRegion<3> before(plate);
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    const Region<3> both = checked_evaluate<3, Rational>(BooleanFunction::union_(2), {plate, far}, options);
    CHECK(counts.faces_whole == plate.face_count() + 6);
    CHECK(counts.faces_merged == 0);
    const ExactRegion<3> after(both);
    for (std::size_t f = 0; f < plate.face_count(); ++f) CHECK(loops(after, f) == loops(before, f));
    (void)evaluate<3, Rational>(Engine::boundary_filter, BooleanFunction::union_(2), std::vector{plate, far}, options);
    CHECK(counts.facets > plate.face_count() + 6);  // faces that are not convex are cut, and put together again
    CHECK(counts.faces_whole == plate.face_count() + 6);
    const Region<3> mould = checked_evaluate<3, Rational>(BooleanFunction::difference(2), {around, plate}, options);
    CHECK(counts.faces_whole == plate.face_count() + 6);  // of this operation alone
    const ExactRegion<3> inside(mould);
    for (std::size_t f = 0; f < plate.face_count(); ++f)
        for (std::size_t l = 0; l < loops(before, f).size(); ++l) {
            std::vector<Coordinates<3>> loop = loops(inside, 6 + f)[l];
            std::reverse(loop.begin(), loop.end());
            CHECK(loop == loops(before, f)[l]);
        }
}

TEST_CASE("evaluate: counts of what was done") {
    OperationCounts counts;
    OperationOptions options;
    options.counts = &counts;
    const std::vector<Region<3>> cubes{cube(0, 3), cube(1, 4), cube(2, 5)};
    const Region<3> r = checked_evaluate<3, Rational>(BooleanFunction::union_(3), cubes, options);
    CHECK(counts.face_pairs > 0);
    CHECK(counts.faces_crossed == 12);
    CHECK(counts.faces_whole == 6);
    CHECK(counts.faces_whole + counts.faces_merged == r.face_count());
    CHECK(counts.facets == 0);
    (void)evaluate<3, Rational>(Engine::boundary_filter, BooleanFunction::union_(3), cubes, options);
    CHECK(counts.facets == 18);
    CHECK(counts.face_pairs == 0);
    CHECK(counts.kernel.sides > 0);
    CHECK(counts.kernel.sides >= counts.kernel.by_identity + counts.kernel.filter_failures);
    CHECK(counts.trees.nodes > 0);
    CHECK(counts.trees.piece_splits > 0);
    (void)evaluate<3, Rational>(BooleanFunction::union_(0), {}, options);
    CHECK(counts.facets == 0);
    CHECK(counts.faces_whole + counts.faces_merged == 0);
    CHECK(counts.trees.nodes == 0);
    CHECK(counts.kernel.sides == 0);
}

TEST_CASE("evaluate: every engine gives the same, and so does every number type") {
    const std::array<Region<2>, 2> squares{box<2>({0, 0}, {4, 4}), box<2>({1, -1}, {3, 9})};
    for (const Operation op : all_operations) {
        const std::string usual = dump(apply(op, squares[0], squares[1]).boundary());
        CHECK(dump(apply(Engine::boundary_filter, op, squares[0], squares[1]).boundary()) == usual);
        CHECK(canonical(apply(Engine::tree_merge, op, squares[0], squares[1])) ==
              canonical(apply(op, squares[0], squares[1])));
        CHECK(dump(evaluate<2, Rational>(BooleanFunction::from(op, 2), squares).boundary()) == usual);
        const Region<2, double> a(squares[0]);
        CHECK(dump(apply(op, a, Region<2, double>(squares[1])).boundary()) == usual);
    }
}

TEST_CASE("evaluate: cancelled, it leaves the operands alone") {
    const std::vector<Region<3>> operands{cuboid({0, 0, 0}, {4, 4, 4}, {3, true}), cuboid({1, 1, 1}, {5, 5, 5})};
    const std::string first = dump(operands[0].boundary());
    const std::string second = dump(operands[1].boundary());
    const auto run = [&](ProgressReporter& progress) {
        OperationOptions options;
        options.progress = &progress;
        return evaluate<3, Rational>(BooleanFunction::union_(2), operands, options);
    };
    for (const double at : {-1.0, 0.0, 0.3, 0.9}) {
        std::stop_source stop;
        if (at < 0) stop.request_stop();  // before it begins
        double reached = 0;
        ProgressReporter progress(
            [&](std::string_view, double share) {
                reached = share;
                if (share >= at) stop.request_stop();
            },
            stop.get_token(), ProgressReporter::Clock::duration::zero());
        CHECK_THROWS_AS(run(progress), Cancelled);
        CHECK(reached >= std::max(at, 0.0));
        CHECK(reached < 1);
    }
    // What the callback throws ends the work as well.
    ProgressReporter failing([](std::string_view, double) { throw std::runtime_error("no more"); });
    CHECK_THROWS_AS(run(failing), std::runtime_error);
    CHECK(dump(operands[0].boundary()) == first);
    CHECK(dump(operands[1].boundary()) == second);
    // Not stopped, it goes from 0 to 1 without a step back, and the result does not depend on being watched.
    std::vector<double> shares;
    ProgressReporter watching([&](std::string_view, double share) { shares.push_back(share); }, {},
                              ProgressReporter::Clock::duration::zero());
    const Region<3> watched = run(watching);
    REQUIRE(!shares.empty());
    CHECK(shares.front() == 0);
    CHECK(shares.back() == 1);
    CHECK(std::is_sorted(shares.begin(), shares.end()));
    CHECK(dump(watched.boundary()) == dump((operands[0] | operands[1]).boundary()));
}

#if CLEAVE_CONTRACTS >= 1
TEST_CASE("evaluate: as many operands as the function takes") {
    const std::vector<Region<1>> one{intervals({{0, 1}})};
    CHECK_THROWS_AS((evaluate<1, Rational>(BooleanFunction::union_(2), one)), ContractViolation);
    CHECK_THROWS_AS((evaluate<1, Rational>(BooleanFunction::union_(0), one)), ContractViolation);
}
#endif
