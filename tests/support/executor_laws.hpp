// SPDX-License-Identifier: Apache-2.0
/// What every executor must do; one body for all of them.
#ifndef CLEAVE_TESTS_SUPPORT_EXECUTOR_LAWS_HPP
#define CLEAVE_TESTS_SUPPORT_EXECUTOR_LAWS_HPP

#include <cleave/execution/executor.hpp>

#include "support/catch.hpp"

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <vector>

/// The sum of the indices in [first, last), by halving: nested forks, a leaf for every index.
template <cleave::Executor E>
std::size_t sum_by_halving(const E& executor, std::size_t first, std::size_t last) {
    if (last - first == 1) return first;
    const std::size_t middle = first + (last - first) / 2;
    std::size_t left = 0;
    std::size_t right = 0;
    executor.invoke([&] { left = sum_by_halving(executor, first, middle); },
                    [&] { right = sum_by_halving(executor, middle, last); });
    return left + right;
}

template <cleave::Executor E>
void check_executor(const E& executor) {
    CHECK(executor.concurrency() >= 1);

    std::vector<std::atomic<int>> visits(1000);
    executor.for_each_index(visits.size(), [&visits](std::size_t i) { ++visits[i]; });
    std::size_t once = 0;
    for (const std::atomic<int>& count : visits) once += count == 1 ? 1 : 0;
    CHECK(once == visits.size());

    int calls = 0;
    executor.for_each_index(0, [&calls](std::size_t) { ++calls; });
    CHECK(calls == 0);

    CHECK(sum_by_halving(executor, 0, 1000) == 499500);

    CHECK_THROWS_AS(executor.invoke([] { throw std::out_of_range("first"); }, [] {}), std::out_of_range);
    CHECK_THROWS_AS(executor.invoke([] {}, [] { throw std::out_of_range("second"); }), std::out_of_range);
    CHECK_THROWS_AS(executor.for_each_index(100,
                                            [](std::size_t i) {
                                                if (i == 63) throw std::out_of_range("in the middle");
                                            }),
                    std::out_of_range);
}

#endif
