// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/config.hpp>

#include "support/catch.hpp"

#include <string>
#include <type_traits>

CLEAVE_BEGIN_NAMESPACE
struct InTheVersionedNamespace {};
CLEAVE_END_NAMESPACE

TEST_CASE("config: names live in an inline namespace of the version, so that two versions do not mix") {
    CHECK(std::is_same_v<cleave::InTheVersionedNamespace, cleave::v0_1::InTheVersionedNamespace>);
}

TEST_CASE("config: the version is stated once, as numbers and as text") {
    const std::string text = std::to_string(CLEAVE_VERSION_MAJOR) + "." + std::to_string(CLEAVE_VERSION_MINOR) + "." +
                             std::to_string(CLEAVE_VERSION_PATCH);
    CHECK(text == CLEAVE_VERSION_STRING);
}
