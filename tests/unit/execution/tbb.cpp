// SPDX-License-Identifier: Apache-2.0
#include <cleave/execution/tbb.hpp>

#include "support/catch.hpp"
#include "support/executor_laws.hpp"

static_assert(cleave::Executor<cleave::TbbExecutor>);

TEST_CASE("tbb: the executor keeps the promises of an executor, for any number of threads") {
    check_executor(cleave::TbbExecutor());
    for (const int threads : {1, 2, 5}) {
        const cleave::TbbExecutor executor(threads);
        CHECK(executor.concurrency() == static_cast<std::size_t>(threads));
        check_executor(executor);
    }
}
