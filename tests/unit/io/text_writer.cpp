// SPDX-License-Identifier: Apache-2.0
#include <cleave/io/text_writer.hpp>

#include "support/catch.hpp"
#include "support/property.hpp"

#include <bit>
#include <limits>

using namespace cleave;
using support::property;

namespace {

std::string written(const auto& value) {
    TextWriter out;
    out << value;
    return out.take();
}

}  // namespace

TEST_CASE("text_writer: text, characters and counts") {
    TextWriter out;
    out << "a" << ' ' << std::uint64_t{18446744073709551615U} << ' ' << std::uint32_t{7} << std::string_view("\n");
    REQUIRE(out.text() == "a 18446744073709551615 7\n");
    REQUIRE(out.take() == "a 18446744073709551615 7\n");
}

TEST_CASE("text_writer: doubles are the shortest text that reads back") {
    REQUIRE(written(0.1) == "0.1");
    REQUIRE(written(-2.0) == "-2");
    REQUIRE(written(1e300) == "1e+300");
    REQUIRE(written(0.0) == "0");
    property("every finite double survives", [](std::uint64_t bits) {
        const auto x = std::bit_cast<double>(bits);
        RC_PRE(x - x == 0);
        RC_ASSERT(std::bit_cast<std::uint64_t>(parse_double(written(x))) == (x == 0 ? std::uint64_t{0} : bits));
    });
}

TEST_CASE("text_writer: rationals are exact") {
    REQUIRE(written(Rational(1) / 3) == "1/3");
    REQUIRE(written(Rational(-8) / 4) == "-2");
    REQUIRE(written(Rational(0)) == "0");
}
