// SPDX-License-Identifier: Apache-2.0
/// Ranges cut into chunks, the same for every executor: results that are put together chunk by chunk do not depend on
/// the number of threads.
#ifndef CLEAVE_EXECUTION_CHUNKS_HPP
#define CLEAVE_EXECUTION_CHUNKS_HPP

#include <cleave/base/contract.hpp>
#include <cleave/execution/executor.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// How many chunks of `grain` indices cover [0, n), the last one being shorter. Requires: grain >= 1.
[[nodiscard]] constexpr std::size_t chunk_count(std::size_t n, std::size_t grain) noexcept {
    return n / grain + (n % grain == 0 ? 0 : 1);
}

/// Runs `f(begin, end, chunk)` for the chunks of [0, n), in any order or at once. Nothing goes to another thread where
/// there is one chunk. Requires: grain >= 1; it should stand for some 50 microseconds of work, so that handing it over
/// costs little beside.
template <Executor E, class F>
void for_each_chunk(const E& executor, std::size_t n, std::size_t grain, F&& f) {
    CLEAVE_REQUIRES(grain >= 1);
    const auto chunk = [&](std::size_t c) { f(c * grain, std::min(n, c * grain + grain), c); };
    const std::size_t count = chunk_count(n, grain);
    if (count < 2)
        SequentialExecutor().for_each_index(count, chunk);
    else
        executor.for_each_index(count, chunk);
}

/// `combine` of the values `f(begin, end)` of the chunks of [0, n), from the first to the last: the same for every
/// executor, even where `combine` is not associative, as sums of doubles are not.
template <class R, Executor E, class F, class Combine>
[[nodiscard]] R reduce_chunks(const E& executor, std::size_t n, std::size_t grain, R first, F&& f, Combine&& combine) {
    struct Slot {  // chunks write at once: values of bool must not share a byte
        R value;
    };
    std::vector<Slot> slots(chunk_count(n, grain), Slot{first});
    for_each_chunk(executor, n, grain,
                   [&](std::size_t begin, std::size_t end, std::size_t c) { slots[c].value = f(begin, end); });
    for (const Slot& slot : slots) first = combine(first, slot.value);
    return first;
}

CLEAVE_END_NAMESPACE

#endif
