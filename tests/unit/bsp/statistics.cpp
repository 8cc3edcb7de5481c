// SPDX-License-Identifier: Apache-2.0
#include <cleave/bsp/statistics.hpp>

#include "support/catch.hpp"

#include <cstddef>
#include <utility>

using Tree = cleave::PlaneTree<int>;

TEST_CASE("statistics: a single leaf has depth zero") {
    CHECK(cleave::statistics(Tree(true)) == cleave::TreeStatistics{0, 1, 0, 0});
    CHECK(cleave::statistics(Tree(true)).average_depth() == 0.0);
}

TEST_CASE("statistics: nodes, leaves, depth and mean depth of a small tree") {
    const Tree t(1, Tree(2, Tree(3, Tree(true), Tree(false)), Tree(false)), Tree(false));
    CHECK(cleave::statistics(t) == cleave::TreeStatistics{3, 4, 3, 3 + 3 + 2 + 1});
    CHECK(cleave::statistics(t).average_depth() == 2.25);
}

TEST_CASE("statistics: a chain of 100,000 cuts has depth 100,000") {
    constexpr std::size_t n = 100'000;
    Tree t(true);
    for (std::size_t k = 0; k < n; ++k) t = Tree(static_cast<int>(k), std::move(t), Tree(false));
    CHECK(cleave::statistics(t) == cleave::TreeStatistics{n, n + 1, n, n * (n + 1) / 2 + n});
}
