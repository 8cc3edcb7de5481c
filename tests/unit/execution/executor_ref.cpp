// SPDX-License-Identifier: Apache-2.0
#include <cleave/execution/executor_ref.hpp>
#include <cleave/execution/thread_pool.hpp>

#include "support/catch.hpp"
#include "support/executor_laws.hpp"

#include <type_traits>

using namespace cleave;

static_assert(Executor<ExecutorRef>);
static_assert(std::is_trivially_copyable_v<ExecutorRef>);
static_assert(std::is_convertible_v<const ThreadPool&, ExecutorRef>);
static_assert(!std::is_constructible_v<ExecutorRef, ThreadPool&&>);
static_assert(!std::is_constructible_v<ExecutorRef, SequentialExecutor>);
static_assert(!std::is_constructible_v<ExecutorRef, int&>);

TEST_CASE("executor_ref: a reference to nothing is the sequential executor") {
    const ExecutorRef none;
    check_executor(none);
    CHECK(none.concurrency() == 1);
    std::vector<std::size_t> order;
    none.for_each_index(3, [&order](std::size_t i) { order.push_back(i); });
    none.invoke([&order] { order.push_back(3); }, [&order] { order.push_back(4); });
    CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4});
}

TEST_CASE("executor_ref: a reference does what its executor does") {
    const SequentialExecutor sequential;
    check_executor(ExecutorRef(sequential));
    const ThreadPool pool(3);
    ExecutorRef reference;
    reference = pool;
    check_executor(reference);
    CHECK(reference.concurrency() == 3);
    const ExecutorRef copy = reference;
    CHECK(sum_by_halving(copy, 0, 100) == 4950);
}
