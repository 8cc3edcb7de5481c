// SPDX-License-Identifier: Apache-2.0
/// Contract checks at three levels, chosen before the first include by CLEAVE_CONTRACTS:
/// 0 off, 1 cheap (the default without NDEBUG), 2 full (with the checks whose cost exceeds the routine's).
#ifndef CLEAVE_BASE_CONTRACT_HPP
#define CLEAVE_BASE_CONTRACT_HPP

#include <cleave/base/config.hpp>

#include <stdexcept>
#include <string>

#ifndef CLEAVE_CONTRACTS
#ifdef NDEBUG
#define CLEAVE_CONTRACTS 0
#else
#define CLEAVE_CONTRACTS 1
#endif
#endif

CLEAVE_BEGIN_NAMESPACE

/// A caller broke a documented requirement, or the library one of its own promises.
class ContractViolation : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// Throws ContractViolation naming the broken condition. Out of line so that a check costs one branch.
[[noreturn]] inline void fail_contract(const char* kind, const char* condition, const char* file, int line) {
    throw ContractViolation(std::string(kind) + " failed: " + condition + " (" + file + ":" + std::to_string(line) +
                            ")");
}

CLEAVE_END_NAMESPACE

#define CLEAVE_CHECK_CONTRACT(kind, condition) \
    ((condition) ? void(0) : ::cleave::fail_contract(kind, #condition, __FILE__, __LINE__))

#if CLEAVE_CONTRACTS >= 1
#define CLEAVE_REQUIRES(condition) CLEAVE_CHECK_CONTRACT("requirement", condition)
#define CLEAVE_ENSURES(condition) CLEAVE_CHECK_CONTRACT("promise", condition)
#define CLEAVE_ASSERT(condition) CLEAVE_CHECK_CONTRACT("assertion", condition)
#else
#define CLEAVE_REQUIRES(condition) void(0)
#define CLEAVE_ENSURES(condition) void(0)
#define CLEAVE_ASSERT(condition) void(0)
#endif

#if CLEAVE_CONTRACTS >= 2
#define CLEAVE_REQUIRES_EXPENSIVE(condition) CLEAVE_CHECK_CONTRACT("requirement", condition)
#define CLEAVE_ENSURES_EXPENSIVE(condition) CLEAVE_CHECK_CONTRACT("promise", condition)
#define CLEAVE_ASSERT_EXPENSIVE(condition) CLEAVE_CHECK_CONTRACT("assertion", condition)
#else
#define CLEAVE_REQUIRES_EXPENSIVE(condition) void(0)
#define CLEAVE_ENSURES_EXPENSIVE(condition) void(0)
#define CLEAVE_ASSERT_EXPENSIVE(condition) void(0)
#endif

#endif
