// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/source.hpp>

#include "support/catch.hpp"

#include <compare>

using cleave::Source;

TEST_CASE("source: the default names nothing and comes last") {
    const Source nothing;
    CHECK_FALSE(nothing.has_value());
    CHECK(Source{0, 0}.has_value());
    CHECK(Source{63, 0xFFFFFFFE} < nothing);
}

TEST_CASE("source: ordered by operand, then by face") {
    CHECK(Source{0, 9} < Source{1, 0});
    CHECK(Source{1, 0} < Source{1, 1});
    CHECK(Source{1, 1} == Source{1, 1});
    CHECK(Source{1, 1} != Source{1, 2});
}
