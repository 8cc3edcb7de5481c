// SPDX-License-Identifier: Apache-2.0
#include "interrupt.hpp"

#include <chrono>
#include <csignal>

#include <pthread.h>
#include <unistd.h>

namespace {

/// SIGTERM always; SIGINT unless whoever started the program had it ignored, as a shell does for background jobs.
sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGTERM);
    struct sigaction action {};
    if (sigaction(SIGINT, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&set, SIGINT);
    return set;
}

}  // namespace

Interrupt::Interrupt() {
    const sigset_t set = watched_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);  // in this thread and those it starts
    watcher_ = std::thread([this] { watch(); });
}

Interrupt::~Interrupt() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        finished_ = true;
    }
    changed_.notify_all();
    pthread_kill(watcher_.native_handle(), SIGTERM);  // wakes it
    watcher_.join();
}

int Interrupt::status() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return 128 + (signal_ == 0 ? SIGINT : signal_);
}

void Interrupt::watch() {
    const sigset_t set = watched_signals();
    int signal = 0;
    if (sigwait(&set, &signal) != 0) return;
    std::unique_lock<std::mutex> lock(mutex_);
    if (finished_) return;
    signal_ = signal;
    stop_.request_stop();
    constexpr auto patience = std::chrono::milliseconds(300);
    if (changed_.wait_for(lock, patience, [this] { return finished_; })) return;
    lock.unlock();
    const std::lock_guard<std::mutex> no_file_is_being_written(protected_);
    constexpr char text[] = "\ncleave: cancelled\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text, sizeof text - 1);
    _exit(128 + signal);
}
