// SPDX-License-Identifier: Apache-2.0
#undef CLEAVE_CONTRACTS
#define CLEAVE_CONTRACTS 0
#include <cleave/base/contract.hpp>

#include "support/catch.hpp"

TEST_CASE("contract: switched off, no condition is evaluated") {
    int evaluated = 0;
    const auto broken = [&evaluated] { return ++evaluated < 0; };
    CHECK_NOTHROW(CLEAVE_REQUIRES(broken()));
    CHECK_NOTHROW(CLEAVE_ENSURES(broken()));
    CHECK_NOTHROW(CLEAVE_ASSERT(broken()));
    CHECK_NOTHROW(CLEAVE_REQUIRES_EXPENSIVE(broken()));
    CHECK(evaluated == 0);
    static_cast<void>(broken);
}
