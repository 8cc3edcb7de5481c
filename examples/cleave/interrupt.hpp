// SPDX-License-Identifier: Apache-2.0
// Ctrl-C: stops the work where that is safe, and never leaves half a file.
#pragma once

#include <cleave/execution/progress.hpp>

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

/// While one exists, SIGINT and SIGTERM ask the work to stop. Work that does not hear of it within a moment, because it
/// is in a part that does not ask, is ended there and then: all it holds is memory.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    [[nodiscard]] cleave::StopToken token() const { return stop_.get_token(); }

    /// The status to exit with after Cancelled: 130 for SIGINT.
    [[nodiscard]] int status() const;

    /// Does work that a signal must not cut short: writing a file.
    template <class Work>
    void protect(Work&& work) {
        const std::lock_guard<std::mutex> lock(protected_);
        work();
    }

private:
    void watch();

    std::stop_source stop_;
    mutable std::mutex mutex_;  // of the next two
    std::condition_variable changed_;
    bool finished_ = false;
    int signal_ = 0;
    std::mutex protected_;
    std::thread watcher_;
};
