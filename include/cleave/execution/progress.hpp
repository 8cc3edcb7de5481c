// SPDX-License-Identifier: Apache-2.0
/// Progress out of long work, and the request to stop into it.
///
/// Whoever starts long work makes a `ProgressReporter` and passes it by reference; algorithms call `begin`, `advance`
/// and `finish`. A stop request surfaces as `Cancelled` from `begin` or `advance`, at a place where nothing the caller
/// owns has been changed.
#ifndef CLEAVE_EXECUTION_PROGRESS_HPP
#define CLEAVE_EXECUTION_PROGRESS_HPP

#include <cleave/base/error.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string_view>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// Called with the name of the running stage and the share of it that is done, 0 to 1. Called on the thread that does
/// the work; what it throws ends the work.
using Progress = std::function<void(std::string_view stage, double fraction)>;

/// Asks long work to stop, from any thread: `std::stop_source::request_stop()`.
using StopToken = std::stop_token;

/// Counts units of work, tells the callback now and then, and throws `Cancelled` once a stop was requested.
///
/// For one thread at a time. Each stage is reported at its start (0) and its end (1), and between them at most once per
/// interval. The clock is read only after a number of units that adapts itself to their pace.
class ProgressReporter {
public:
    using Clock = std::chrono::steady_clock;

    /// Reports to nobody and never stops.
    ProgressReporter() = default;

    explicit ProgressReporter(Progress progress, StopToken stop = {},
                              Clock::duration interval = std::chrono::milliseconds(100))
        : progress_(std::move(progress)), stop_(std::move(stop)), interval_(interval) {}

    /// Stops on request without reporting.
    explicit ProgressReporter(StopToken stop) : stop_(std::move(stop)) {}

    ProgressReporter(const ProgressReporter&) = delete;
    ProgressReporter& operator=(const ProgressReporter&) = delete;

    /// Starts a stage of `total` units; `stage` must outlive it (a literal).
    /// Throws: Cancelled if a stop was requested.
    void begin(std::string_view stage, std::uint64_t total) {
        throw_if_stopped();
        stage_ = stage;
        total_ = std::max<std::uint64_t>(total, 1);
        done_ = 0;
        step_ = 1;
        look_at_ = step_;
        last_report_ = Clock::now();
        report(0);
    }

    /// Says that `units` more are done. Throws: Cancelled if a stop was requested.
    /// Cost: an addition and a comparison, nearly always.
    void advance(std::uint64_t units = 1) {
        done_ += units;
        if (done_ >= look_at_) look();
    }

    /// Ends the stage.
    void finish() { report(1); }

    /// Throws: Cancelled if a stop was requested. For work that does not count its units.
    void throw_if_stopped() const {
        if (stop_.stop_requested()) throw Cancelled();
    }

private:
    /// Units may become dearer: of those that take 5 microseconds, this many pass before a request to stop is seen.
    static constexpr std::uint64_t longest_step = 1u << 13;

    void look() {
        throw_if_stopped();
        const Clock::time_point now = Clock::now();
        if (now - last_report_ >= interval_) {
            // Units may have become dearer: look twice as often from here on.
            step_ = std::max<std::uint64_t>(step_ / 2, 1);
            last_report_ = now;
            report(std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_)));
        } else if (now - last_look_ < interval_ / 16) {
            step_ = std::min(step_ * 2, longest_step);
        }
        last_look_ = now;
        look_at_ = done_ + step_;
    }

    void report(double fraction) {
        if (progress_) progress_(stage_, fraction);
    }

    Progress progress_;
    StopToken stop_;
    Clock::duration interval_ = std::chrono::milliseconds(100);
    std::string_view stage_;
    std::uint64_t total_ = 1;
    std::uint64_t done_ = 0;
    std::uint64_t step_ = 1;
    std::uint64_t look_at_ = 1;
    Clock::time_point last_report_{};
    Clock::time_point last_look_{};
};

CLEAVE_END_NAMESPACE

#endif
