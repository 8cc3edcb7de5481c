// SPDX-License-Identifier: Apache-2.0
#include <cleave/execution/executor.hpp>

#include "support/catch.hpp"
#include "support/executor_laws.hpp"

static_assert(cleave::Executor<cleave::SequentialExecutor>);
static_assert(!cleave::Executor<int>);

TEST_CASE("executor: the sequential executor keeps the promises of an executor") {
    check_executor(cleave::SequentialExecutor());
}

TEST_CASE("executor: the sequential executor keeps the order") {
    std::vector<std::size_t> order;
    const cleave::SequentialExecutor executor;
    executor.for_each_index(4, [&order](std::size_t i) { order.push_back(i); });
    executor.invoke([&order] { order.push_back(4); }, [&order] { order.push_back(5); });
    CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4, 5});
    CHECK(executor.concurrency() == 1);
}
