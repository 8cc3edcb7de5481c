// SPDX-License-Identifier: Apache-2.0
#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/execution/thread_pool.hpp>

#include "support/catch.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

using namespace cleave;

namespace {

using Border = std::array<std::size_t, 3>;

template <class E>
std::vector<Border> borders(const E& executor, std::size_t n, std::size_t grain) {
    std::vector<Border> found(chunk_count(n, grain));
    for_each_chunk(executor, n, grain, [&](std::size_t begin, std::size_t end, std::size_t c) {
        found[c] = {begin, end, c};
    });
    return found;
}

}  // namespace

TEST_CASE("chunks: they cover the range, whoever runs them") {
    const ThreadPool pool(3);
    for (const auto& found : {borders(SequentialExecutor(), 10, 4), borders(pool, 10, 4)})
        CHECK(found == std::vector<Border>{{0, 4, 0}, {4, 8, 1}, {8, 10, 2}});
    CHECK(borders(pool, 0, 4).empty());
    CHECK(borders(pool, 4, 4) == std::vector<Border>{{0, 4, 0}});
    CHECK(borders(pool, 3, 4) == std::vector<Border>{{0, 3, 0}});
    CHECK(borders(ExecutorRef(pool), 2, 1) == std::vector<Border>{{0, 1, 0}, {1, 2, 1}});
}

TEST_CASE("chunks: a sum of doubles is the same to the last bit") {
    const auto sum = [](const auto& executor) {
        return reduce_chunks(
            executor, 100000, 1000, 0.0,
            [](std::size_t begin, std::size_t end) {
                double s = 0;
                for (std::size_t i = begin; i < end; ++i) s += 1 / (1.0 + double(i));
                return s;
            },
            [](double a, double b) { return a + b; });
    };
    const double alone = sum(SequentialExecutor());
    CHECK(alone > 12);
    for (const std::size_t threads : {1U, 2U, 3U, 7U}) CHECK(sum(ThreadPool(threads)) == alone);
}

TEST_CASE("chunks: truth values of chunks do not get into each other's way") {
    const ThreadPool pool(4);
    for (std::size_t wrong = 0; wrong < 64; ++wrong) {
        const bool all = reduce_chunks(
            pool, 64, 1, true, [&](std::size_t i, std::size_t) { return i != wrong; },
            [](bool a, bool b) { return a && b; });
        CHECK_FALSE(all);
    }
}

TEST_CASE("chunks: what a chunk throws comes out") {
    const ThreadPool pool(2);
    const auto chunk = [](std::size_t begin, std::size_t, std::size_t) {
        if (begin == 60) throw std::out_of_range("a chunk");
    };
    CHECK_THROWS_AS(for_each_chunk(pool, 100, 20, chunk), std::out_of_range);
}
