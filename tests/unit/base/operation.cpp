// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/operation.hpp>

#include "support/catch.hpp"

#include <optional>

using cleave::Operation;
using cleave::operation_from_text;

TEST_CASE("operation: names are read back") {
    for (const Operation operation : cleave::all_operations) {
        CHECK(operation_from_text(to_text(operation)) == operation);
    }
}

TEST_CASE("operation: xor and the C++ spellings are names too") {
    CHECK(operation_from_text("xor") == Operation::symmetric_difference);
    CHECK(operation_from_text("symmetric_difference") == Operation::symmetric_difference);
    CHECK(operation_from_text("union_") == Operation::union_);
}

TEST_CASE("operation: any other text is no name") {
    for (const char* text : {"", "Union", "unio", "unions", " union", "minus", "symmetric difference"}) {
        CHECK(operation_from_text(text) == std::nullopt);
    }
}

TEST_CASE("operation: truth tables in the order 00, 01, 10, 11") {
    const auto table = [](Operation operation) {
        int bits = 0;
        for (int i = 0; i < 4; ++i) bits = bits * 2 + (apply(operation, (i & 2) != 0, (i & 1) != 0) ? 1 : 0);
        return bits;
    };
    CHECK(table(Operation::union_) == 0b0111);
    CHECK(table(Operation::intersection) == 0b0001);
    CHECK(table(Operation::difference) == 0b0010);
    CHECK(table(Operation::symmetric_difference) == 0b0110);
}
