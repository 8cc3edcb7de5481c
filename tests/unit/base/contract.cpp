// SPDX-License-Identifier: Apache-2.0
// Every level is tested in a file of its own; this one is "full", whatever the build says.
#undef CLEAVE_CONTRACTS
#define CLEAVE_CONTRACTS 2
#include <cleave/base/contract.hpp>

#include "support/catch.hpp"

#include <string>

namespace {

constexpr int checked_half(int n) {
    CLEAVE_REQUIRES(n % 2 == 0);
    return n / 2;
}
static_assert(checked_half(8) == 4, "a contract that holds is usable in a constant expression");

}  // namespace

TEST_CASE("contract: a broken requirement names the condition, the file and the line") {
    try {
        CLEAVE_REQUIRES(1 + 1 == 3);
        FAIL("the requirement did not throw");
    } catch (const cleave::ContractViolation& violation) {
        const std::string text = violation.what();
        CHECK(text.find("requirement failed: 1 + 1 == 3") == 0);
        CHECK(text.find("contract.cpp:" + std::to_string(__LINE__ - 5)) != std::string::npos);
    }
}

TEST_CASE("contract: at the full level all six checks act") {
    CHECK_THROWS_AS(checked_half(7), cleave::ContractViolation);
    const int two = 2;
    CHECK_THROWS_AS(CLEAVE_ENSURES(two == 3), cleave::ContractViolation);
    CHECK_THROWS_AS(CLEAVE_ASSERT(two == 3), cleave::ContractViolation);
    CHECK_THROWS_AS(CLEAVE_REQUIRES_EXPENSIVE(two == 3), cleave::ContractViolation);
    CHECK_THROWS_AS(CLEAVE_ENSURES_EXPENSIVE(two == 3), cleave::ContractViolation);
    CHECK_THROWS_AS(CLEAVE_ASSERT_EXPENSIVE(two == 3), cleave::ContractViolation);
    CHECK_NOTHROW(CLEAVE_REQUIRES(two == 2));
    CHECK_NOTHROW(CLEAVE_ASSERT_EXPENSIVE(two == 2));
}
