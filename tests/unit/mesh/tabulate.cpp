// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/tabulate.hpp>

#include <cleave/execution/thread_pool.hpp>

#include "support/catch.hpp"

#include <cstdint>
#include <string>
#include <vector>

using namespace cleave;

TEST_CASE("tabulate: the values of a function, in order, each asked for once") {
    std::size_t calls = 0;
    const auto square = [&calls](std::size_t i) {
        ++calls;
        return int(i * i);
    };
    CHECK(tabulate(5, square) == std::vector<int>{0, 1, 4, 9, 16});
    CHECK(calls == 5);
    CHECK(tabulate(0, square).empty());
    CHECK(tabulate(2, [](std::size_t i) { return std::string(i + 1, 'x'); }) == std::vector<std::string>{"x", "xx"});
}

TEST_CASE("tabulate: by several threads") {
    const auto square = [](std::size_t i) { return std::uint64_t(i) * i; };
    for (const std::size_t n : {0U, 5U, 8192U, 8193U, 100000U})
        CHECK(tabulate(ThreadPool(3), n, square) == tabulate(n, square));
}
