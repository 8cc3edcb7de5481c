// SPDX-License-Identifier: Apache-2.0
#include <cleave/algebra/laplace.hpp>

#include "support/catch.hpp"
#include "support/counting.hpp"

#include <vector>

using namespace cleave;

TEST_CASE("laplace: every minor of the first rows stands under its set of columns") {
    const Matrix<2, 3, Integer> m{{{{2, 3, 5}, {7, 11, 13}}}};
    const std::vector<Integer> minors = laplace_minors(m);
    REQUIRE(minors.size() == 8);
    CHECK(minors[0b000] == 1);
    CHECK(minors[0b001] == 2);
    CHECK(minors[0b010] == 3);
    CHECK(minors[0b100] == 5);
    CHECK(minors[0b011] == 2 * 11 - 3 * 7);
    CHECK(minors[0b101] == 2 * 13 - 5 * 7);
    CHECK(minors[0b110] == 3 * 13 - 5 * 11);
}

TEST_CASE("laplace: each minor is computed once, without division") {
    Matrix<6, 6, counting::Number> m;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) m(i, j) = counting::Number(1 + i * i + j * (i + 2));
    }
    counting::counts() = {};
    static_cast<void>(laplace_minors(m));
    CHECK(counting::counts().products == 6 * 32);  // n 2^(n - 1)
    CHECK(counting::counts().divisions == 0);
}
