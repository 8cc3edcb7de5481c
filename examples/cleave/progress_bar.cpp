// SPDX-License-Identifier: Apache-2.0
#include "progress_bar.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string_view>
#include <utility>

#include <unistd.h>

ProgressBar::ProgressBar(bool wanted) {
    if (wanted && isatty(STDERR_FILENO) != 0) painter_ = std::thread([this] { paint_until_closed(); });
}

ProgressBar::~ProgressBar() {
    close();
}

void ProgressBar::stage(std::string name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    stage_ = std::move(name);
    fraction_ = -1;
}

cleave::Progress ProgressBar::callback() {
    return [this](std::string_view, double fraction) {
        const std::lock_guard<std::mutex> lock(mutex_);
        fraction_ = fraction;
    };
}

void ProgressBar::close() {
    if (!painter_.joinable()) return;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
    painter_.join();
}

void ProgressBar::paint_until_closed() {
    constexpr auto patience = std::chrono::seconds(1);
    constexpr auto period = std::chrono::milliseconds(100);
    constexpr int width = 30;
    std::unique_lock<std::mutex> lock(mutex_);
    if (changed_.wait_for(lock, patience, [this] { return closed_; })) return;
    for (int tick = 0;; ++tick) {
        std::string bar(width, '-');
        if (fraction_ >= 0) {
            std::fill_n(bar.begin(), static_cast<int>(std::clamp(fraction_, 0.0, 1.0) * width), '#');
            std::fprintf(stderr, "\r\033[K[%s] %3d %%  %s", bar.c_str(), static_cast<int>(fraction_ * 100),
                         stage_.c_str());
        } else {
            bar[static_cast<std::size_t>(tick % width)] = '#';
            std::fprintf(stderr, "\r\033[K[%s]        %s", bar.c_str(), stage_.c_str());
        }
        std::fflush(stderr);
        if (changed_.wait_for(lock, period, [this] { return closed_; })) break;
    }
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
}
