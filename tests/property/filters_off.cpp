// SPDX-License-Identifier: Apache-2.0
// A program whose filters all abstain and are counted: both macros hold for a whole program, so they have one of their
// own.
#define CLEAVE_COUNT_FILTERS
#define CLEAVE_FAIL_FILTERS
#include <cleave/number/filter.hpp>

#include "support/catch.hpp"

#include <cleave/mesh/from_region.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>
#include <cleave/shape/simplex.hpp>
#include <cleave/shape/sphere.hpp>

#include <optional>
#include <thread>
#include <vector>

using namespace cleave;

TEST_CASE("filters off: no approximate answer is believed, every exact one is counted") {
    reset_filter_counts();
    const auto wrong = [] { return std::optional(Sign::minus); };
    CHECK(filtered_sign(wrong, [] { return Sign::plus; }) == Sign::plus);
    CHECK(filtered_sign(wrong, [] { return Sign::zero; }) == Sign::zero);
    CHECK(filter_counts().calls == 2);
    CHECK(filter_counts().failures == 2);
    CHECK(filter_counts().zeros == 1);
    count_filter_call();
    count_filter_failure(Sign::zero);
    CHECK(filter_counts().calls == 3);
    CHECK(filter_counts().zeros == 2);
    reset_filter_counts();
    CHECK(filter_counts().calls == 0);
}

TEST_CASE("filters off: a linear form that is plainly positive is not decided") {
    CHECK(linear_form_sign<1>({1.0}, 1.0, {1.0}, 0.0) == std::nullopt);
}

TEST_CASE("filters off: threads count together") {
    reset_filter_counts();
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([] {
            for (int i = 0; i < 1000; ++i)
                static_cast<void>(filtered_sign([] { return std::optional<Sign>(); }, [] { return Sign::zero; }));
        });
    }
    for (std::thread& t : threads) t.join();
    CHECK(filter_counts().calls == 4000);
    CHECK(filter_counts().failures == 4000);
    CHECK(filter_counts().zeros == 4000);
}

// The engine with no approximation believed anywhere: the same sets, each number of them known.

TEST_CASE("filters off: set operations in space rest on exact signs") {
    const Region<3> cube = box<3>({0, 0, 0}, {2, 2, 2});
    const Region<3> corner = simplex<3>({{1, 1, 1}, {4, 1, 1}, {1, 4, 1}, {1, 1, 4}});  // x + y + z <= 6
    const Region<3> both = cube & corner;
    CHECK(*measure(both) == 1);
    CHECK(*measure(cube | corner) == Rational(8) + Rational(9) / 2 - 1);
    CHECK((both ^ box<3>({1, 1, 1}, {2, 2, 2})).is_empty());
    CHECK(((cube - corner) ^ (cube & ~corner)).is_empty());
    CHECK((cube ^ cube).is_empty());

    OperationCounts counts;
    const Region<3> ball = sphere<Rational>({1, 1, 2}, Rational(5) / 4);
    const Region<3> any = union_(cube, ball, {.counts = &counts});
    CHECK(counts.kernel.filter_failures > 500);
    CHECK(counts.kernel.exact_tests == counts.kernel.filter_failures);
    CHECK(*measure(any) + *measure(cube & ball) == *measure(cube) + *measure(ball));
    CHECK(validate(to_mesh(any)).is_closed());
}

TEST_CASE("filters off: set operations in the plane and on the line rest on exact signs") {
    const Region<2> square = box<2>({0, 0}, {3, 3});
    const Region<2> round = disc<Rational>({3, 3}, 2);
    CHECK(*measure(square | round) + *measure(square & round) == *measure(square) + *measure(round));
    CHECK(4 * *measure(square & round) == *measure(round));
    const Region<1> a = intervals({{0, 1}, {2, 3}});
    const Region<1> b = intervals({{Rational(1) / 3, 2}});
    CHECK(*measure(a | b) == 3);
    CHECK(*measure(a & b) == Rational(2) / 3);
}
