// SPDX-License-Identifier: Apache-2.0
#include <cleave/execution/thread_pool.hpp>

#include "support/catch.hpp"
#include "support/executor_laws.hpp"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

using cleave::ThreadPool;

static_assert(cleave::Executor<ThreadPool>);

TEST_CASE("thread_pool: the pool keeps the promises of an executor, for any number of threads") {
    check_executor(ThreadPool());
    for (const std::size_t threads : {1U, 2U, 3U, 7U}) {
        const ThreadPool pool(threads);
        CHECK(pool.concurrency() == threads);
        check_executor(pool);
    }
}

TEST_CASE("thread_pool: a pool that is never used ends") {
    const ThreadPool pool(5);
    CHECK(pool.concurrency() == 5);
}

TEST_CASE("thread_pool: pieces that ask for pieces do not wait for each other") {
    const ThreadPool pool(3);
    std::atomic<std::size_t> sum = 0;
    pool.for_each_index(20, [&](std::size_t i) {
        pool.for_each_index(20, [&](std::size_t j) { pool.invoke([&] { sum += i; }, [&] { sum += j; }); });
    });
    CHECK(sum == 2 * 20 * 190);
}

TEST_CASE("thread_pool: who waits for a piece takes part in what that piece asks for") {
    const ThreadPool pool(2);
    std::atomic<bool> is_late = false;
    std::atomic<int> arrived = 0;
    // The second piece asks for two that have to run at once, when the first has long ended.
    const auto meet = [&] {
        ++arrived;
        while (arrived < 2) std::this_thread::yield();
    };
    pool.invoke([&] { is_late = true; },
                [&] {
                    while (!is_late) std::this_thread::yield();
                    std::this_thread::sleep_for(std::chrono::milliseconds(5));
                    pool.invoke(meet, meet);
                });
    CHECK(arrived == 2);
}

TEST_CASE("thread_pool: pieces of one pool may ask another") {
    const ThreadPool outer(2);
    const ThreadPool inner(3);
    std::atomic<std::size_t> sum = 0;
    outer.for_each_index(10, [&](std::size_t) {
        inner.for_each_index(10, [&](std::size_t) { outer.for_each_index(10, [&](std::size_t i) { sum += i; }); });
    });
    CHECK(sum == 100 * 45);
}

TEST_CASE("thread_pool: several threads may use one pool at once") {
    const ThreadPool pool(3);
    std::atomic<std::size_t> sum = 0;
    std::vector<std::thread> users;
    for (int user = 0; user < 4; ++user)
        users.emplace_back([&] {
            for (int round = 0; round < 50; ++round) pool.for_each_index(10, [&](std::size_t i) { sum += i; });
        });
    for (std::thread& user : users) user.join();
    CHECK(sum == 4 * 50 * 45);
}

TEST_CASE("thread_pool: two pieces of a pool of two threads do run at once") {
    const ThreadPool pool(2);
    std::atomic<int> arrived = 0;
    const auto meet = [&] {
        ++arrived;
        while (arrived < 2) std::this_thread::yield();
    };
    pool.invoke(meet, meet);
    CHECK(arrived == 2);
}

TEST_CASE("thread_pool: an exception comes out after all pieces that had started, and stops the rest") {
    const ThreadPool pool(4);
    std::atomic<int> running = 0;
    std::atomic<int> started = 0;
    const auto piece = [&](std::size_t i) {
        ++running;
        ++started;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        --running;
        if (i == 3) throw std::out_of_range("the fourth piece");
    };
    CHECK_THROWS_AS(pool.for_each_index(100000, piece), std::out_of_range);
    CHECK(running == 0);
    CHECK(started < 100000);
    // The pool is as good as new.
    check_executor(pool);
}

TEST_CASE("thread_pool: an exception of an inner piece comes out of the outer call") {
    const ThreadPool pool(3);
    const auto outer = [&](std::size_t i) {
        pool.for_each_index(10, [&](std::size_t j) {
            if (10 * i + j == 57) throw std::out_of_range("an inner piece");
        });
    };
    CHECK_THROWS_AS(pool.for_each_index(10, outer), std::out_of_range);
}
