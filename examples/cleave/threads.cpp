// SPDX-License-Identifier: Apache-2.0
#include "threads.hpp"

#ifdef CLEAVE_PROGRAM_WITH_TBB
#include <tbb/global_control.h>
#include <cleave/execution/tbb.hpp>

struct Threads::Implementation {
    explicit Implementation(std::size_t count)
        : limit(tbb::global_control::max_allowed_parallelism, count), executor(static_cast<int>(count)) {}

    tbb::global_control limit;  // as many as were asked for, also where the machine has fewer
    cleave::TbbExecutor executor;
};
#else
#include <cleave/execution/thread_pool.hpp>

struct Threads::Implementation {
    explicit Implementation(std::size_t count) : executor(count) {}

    cleave::ThreadPool executor;
};
#endif

Threads::Threads(std::size_t count) : implementation_(std::make_unique<Implementation>(count)) {}

Threads::~Threads() = default;

cleave::ExecutorRef Threads::executor() const {
    return implementation_->executor;
}
