// SPDX-License-Identifier: Apache-2.0
#undef CLEAVE_CONTRACTS
#define CLEAVE_CONTRACTS 1
#include <cleave/base/contract.hpp>

#include "support/catch.hpp"

TEST_CASE("contract: at the cheap level the expensive conditions are not even evaluated") {
    int evaluated = 0;
    const auto broken = [&evaluated] { return ++evaluated < 0; };
    CHECK_NOTHROW(CLEAVE_REQUIRES_EXPENSIVE(broken()));
    CHECK_NOTHROW(CLEAVE_ENSURES_EXPENSIVE(broken()));
    CHECK_NOTHROW(CLEAVE_ASSERT_EXPENSIVE(broken()));
    CHECK(evaluated == 0);
    CHECK_THROWS_AS(CLEAVE_REQUIRES(broken()), cleave::ContractViolation);
    CHECK_THROWS_AS(CLEAVE_ENSURES(broken()), cleave::ContractViolation);
    CHECK_THROWS_AS(CLEAVE_ASSERT(broken()), cleave::ContractViolation);
    CHECK(evaluated == 3);
}
