// SPDX-License-Identifier: Apache-2.0
// A line on the terminal for work that takes more than a second.
#pragma once

#include <cleave/execution/progress.hpp>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

/// Shows the running stage on the error stream, if that is a terminal, from one second after its making until its end.
/// A thread of its own repaints the line, so that stages which report nothing are shown as well.
class ProgressBar {
public:
    /// `wanted`: false shows nothing, whatever the error stream is.
    explicit ProgressBar(bool wanted);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Starts a stage whose progress is not known.
    void stage(std::string name);

    /// For a ProgressReporter: tells how much of the running stage is done.
    [[nodiscard]] cleave::Progress callback();

    /// Takes the line away for good.
    void close();

private:
    void paint_until_closed();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::string stage_;
    double fraction_ = -1;  // negative: not known
    bool closed_ = false;
    std::thread painter_;
};
