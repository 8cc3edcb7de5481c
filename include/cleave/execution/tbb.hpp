// SPDX-License-Identifier: Apache-2.0
/// oneTBB as an executor. Opt-in: not part of `<cleave.hpp>`; link `cleave::tbb`.
#ifndef CLEAVE_EXECUTION_TBB_HPP
#define CLEAVE_EXECUTION_TBB_HPP

#include <cleave/execution/executor.hpp>

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// Runs pieces on the threads of an arena of its own, so that its concurrency is not the whole program's.
class TbbExecutor {
public:
    /// As many threads as the machine offers.
    TbbExecutor() = default;

    /// Requires: threads >= 1.
    explicit TbbExecutor(int threads) : arena_(threads) {}

    [[nodiscard]] std::size_t concurrency() const { return static_cast<std::size_t>(arena_.max_concurrency()); }

    template <class F, class G>
    void invoke(F&& f, G&& g) const {
        arena_.execute([&f, &g] { tbb::parallel_invoke(f, g); });
    }

    template <class F>
    void for_each_index(std::size_t n, F&& f) const {
        arena_.execute([n, &f] { tbb::parallel_for(std::size_t(0), n, f); });
    }

private:
    // Entering an arena is not a change that a user of the executor could see.
    mutable tbb::task_arena arena_;
};

CLEAVE_END_NAMESPACE

#endif
