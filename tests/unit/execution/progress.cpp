// SPDX-License-Identifier: Apache-2.0
#include <cleave/execution/progress.hpp>

#include "support/catch.hpp"

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace cleave;

namespace {

using Reports = std::vector<std::pair<std::string, double>>;

Progress record_in(Reports& reports) {
    return [&reports](std::string_view stage, double fraction) { reports.emplace_back(stage, fraction); };
}

}  // namespace

TEST_CASE("progress: without an interval every unit is reported, in order and exactly") {
    Reports reports;
    ProgressReporter reporter(record_in(reports), {}, ProgressReporter::Clock::duration::zero());
    reporter.begin("build", 4);
    reporter.advance();
    reporter.advance(2);
    reporter.advance();
    reporter.finish();
    CHECK(reports == Reports{{"build", 0.0}, {"build", 0.25}, {"build", 0.75}, {"build", 1.0}, {"build", 1.0}});
}

TEST_CASE("progress: within the interval only the start and the end of a stage are reported") {
    Reports reports;
    ProgressReporter reporter(record_in(reports), {}, std::chrono::hours(1));
    reporter.begin("read", 1000000);
    for (int i = 0; i < 1000000; ++i) reporter.advance();
    reporter.finish();
    reporter.begin("write", 1);
    reporter.finish();
    CHECK(reports == Reports{{"read", 0.0}, {"read", 1.0}, {"write", 0.0}, {"write", 1.0}});
}

TEST_CASE("progress: the fraction never passes 1, even for a wrong or an empty total") {
    Reports reports;
    ProgressReporter reporter(record_in(reports), {}, ProgressReporter::Clock::duration::zero());
    reporter.begin("guess", 2);
    reporter.advance(5);
    reporter.begin("nothing", 0);
    reporter.advance(3);
    CHECK(reports == Reports{{"guess", 0.0}, {"guess", 1.0}, {"nothing", 0.0}, {"nothing", 1.0}});
}

TEST_CASE("progress: a stop request surfaces as Cancelled") {
    std::stop_source stop;
    ProgressReporter reporter(stop.get_token());
    reporter.begin("operate", 100);
    CHECK_NOTHROW(reporter.advance());
    stop.request_stop();
    CHECK_THROWS_AS(reporter.throw_if_stopped(), Cancelled);
    CHECK_THROWS_AS(reporter.begin("export", 1), Cancelled);
}

TEST_CASE("progress: a stop request is seen within a bounded number of units, however cheap they are") {
    std::stop_source stop;
    ProgressReporter reporter({}, stop.get_token(), std::chrono::hours(1));
    reporter.begin("operate", std::uint64_t(1) << 40);
    for (int i = 0; i < 3000000; ++i) reporter.advance();
    stop.request_stop();
    bool stopped = false;
    std::uint64_t more = 0;
    try {
        for (; more < (std::uint64_t(1) << 21); ++more) reporter.advance();
    } catch (const Cancelled&) {
        stopped = true;
    }
    CHECK(stopped);
    CHECK(more <= std::uint64_t(1) << 20);
}

TEST_CASE("progress: what the callback throws ends the work") {
    ProgressReporter reporter([](std::string_view, double) { throw std::runtime_error("window closed"); });
    CHECK_THROWS_AS(reporter.begin("build", 1), std::runtime_error);
}

TEST_CASE("progress: a default reporter reports to nobody") {
    ProgressReporter reporter;
    reporter.begin("build", 10);
    reporter.advance(10);
    CHECK_NOTHROW(reporter.finish());
    CHECK_NOTHROW(reporter.throw_if_stopped());
}
