// SPDX-License-Identifier: Apache-2.0
// A program whose filters all abstain and are counted: both macros hold for a whole program, so they have one of their
// own.
#define CLEAVE_COUNT_FILTERS
#define CLEAVE_FAIL_FILTERS
#include <cleave/number/filter.hpp>

#include "support/catch.hpp"

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
