// SPDX-License-Identifier: Apache-2.0
/// The four set operations: one spelling each, their truth tables, and their names as text.
#ifndef CLEAVE_BASE_OPERATION_HPP
#define CLEAVE_BASE_OPERATION_HPP

#include <cleave/base/config.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

CLEAVE_BEGIN_NAMESPACE

/// A set operation on two or more operands. For more than two, `difference` is the first minus all others and
/// `symmetric_difference` is parity. `union_` has its underscore because `union` is a keyword.
enum class Operation : std::uint8_t { union_, intersection, difference, symmetric_difference };

/// All operations, in the order of the enumeration.
inline constexpr std::array<Operation, 4> all_operations = {Operation::union_, Operation::intersection,
                                                            Operation::difference, Operation::symmetric_difference};

/// Returns: whether a point belongs to the result, given whether it belongs to the first and to the second operand.
[[nodiscard]] constexpr bool apply(Operation operation, bool a, bool b) noexcept {
    switch (operation) {
        case Operation::union_:
            return a || b;
        case Operation::intersection:
            return a && b;
        case Operation::difference:
            return a && !b;
        case Operation::symmetric_difference:
            return a != b;
    }
    return false;
}

/// Returns: the name of the operation as the command line spells it: "union", "symmetric-difference".
[[nodiscard]] constexpr std::string_view to_text(Operation operation) noexcept {
    switch (operation) {
        case Operation::union_:
            return "union";
        case Operation::intersection:
            return "intersection";
        case Operation::difference:
            return "difference";
        case Operation::symmetric_difference:
            return "symmetric-difference";
    }
    return {};
}

/// Returns: the operation of that name, `to_text` reversed; also "xor" and the C++ spellings "union_" and
/// "symmetric_difference". nullopt for any other text.
[[nodiscard]] constexpr std::optional<Operation> operation_from_text(std::string_view text) noexcept {
    for (const Operation operation : all_operations) {
        if (text == to_text(operation)) return operation;
    }
    if (text == "union_") return Operation::union_;
    if (text == "symmetric_difference" || text == "xor") return Operation::symmetric_difference;
    return std::nullopt;
}

CLEAVE_END_NAMESPACE

#endif
