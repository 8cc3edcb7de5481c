// SPDX-License-Identifier: Apache-2.0
#include <cleave/io/coordinate.hpp>

#include "support/catch.hpp"

#include <limits>
#include <string>

using namespace cleave;

namespace {

const TextReader reader("", "t");

template <class T>
T read(std::string_view word) {
    T value;
    read_coordinate(reader, word, 7, 1, value);
    return value;
}

template <class T>
std::string refusal(std::string_view word) {
    try {
        (void)read<T>(word);
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("coordinate: decimals are the nearest double, or exactly themselves as rationals") {
    REQUIRE(read<double>("0.1") == 0.1);
    REQUIRE(read<Rational>("0.1") == Rational(1) / 10);
    REQUIRE(read<Rational>("0.1") != Rational(0.1));
    for (const char* text : {"0", "1", "-2.5", "1e3", "1E-3", "+4", "+.5", ".5", "5.", "-0.125e+2", "00012"}) {
        CAPTURE(text);
        REQUIRE(Rational(read<double>(text)) == (std::string(text) == "1E-3" ? Rational(0.001) : read<Rational>(text)));
    }
    REQUIRE(read<double>("4.35") == 4.35);
    REQUIRE(read<double>("9007199254740993") == 9007199254740992.0);
    REQUIRE(read<Rational>("9007199254740993") == Rational(9007199254740992.0) + 1);
}

TEST_CASE("coordinate: the ends of the range of doubles") {
    REQUIRE(read<double>("1.7976931348623157e308") == std::numeric_limits<double>::max());
    REQUIRE(read<double>("5e-324") == std::numeric_limits<double>::denorm_min());
    REQUIRE(read<double>("1e-400") == 0.0);
    REQUIRE(read<double>("-1e-400") == 0.0);
    REQUIRE(read<double>("0e999999999999") == 0.0);
    for (const char* text : {"1e309", "-1e999999999999999999999", "2e308"}) {
        CAPTURE(text);
        const std::string why = refusal<double>(text);
        REQUIRE(why.find("expected the y coordinate of vertex 7, found '" + std::string(text) + "'") !=
                std::string::npos);
        REQUIRE(why.find("larger than any double") != std::string::npos);
    }
}

TEST_CASE("coordinate: fractions are for rationals") {
    REQUIRE(read<Rational>("1/3") == Rational(1) / 3);
    REQUIRE(read<Rational>("-10/4") == Rational(-5) / 2);
    REQUIRE(refusal<double>("1/3") ==
            "t:1: expected the y coordinate of vertex 7, found '1/3': a fraction; read this file as rationals");
    REQUIRE(refusal<Rational>("1/0") != "accepted");
    REQUIRE(refusal<Rational>("1/") != "accepted");
    REQUIRE(refusal<Rational>("/2") != "accepted");
}

TEST_CASE("coordinate: what is no number is refused") {
    for (const char* text : {"abc", "1.2.3", "--1", "+-1", "1e", "0x10", "1,5", "nan", "inf", "-inf", "infinity", "NaN",
                             "nan(1)", ".", "-", "e5", "1_000", "1e5x", "\xc2\xbd"}) {
        CAPTURE(text);
        REQUIRE(refusal<double>(text).starts_with("t:1: expected the y coordinate of vertex 7, found '"));
        REQUIRE(refusal<Rational>(text).starts_with("t:1: expected the y coordinate of vertex 7, found '"));
    }
    REQUIRE(refusal<double>("") == "t:1: expected the y coordinate of vertex 7, found the end of the line");
    REQUIRE(refusal<Rational>("") == "t:1: expected the y coordinate of vertex 7, found the end of the line");
}

TEST_CASE("coordinate: a rational that would fill the memory is refused") {
    for (const char* text : {"1e4097", "1e-4097", "1e999999999999999999999999", "1/1e99999", "1e5/1e-4097"}) {
        CAPTURE(text);
        REQUIRE(refusal<Rational>(text).find("its exponent is beyond 4096") != std::string::npos);
    }
    REQUIRE(read<Rational>("1e4096") * read<Rational>("1e-4096") == 1);
}

TEST_CASE("coordinate: indices") {
    REQUIRE(read_index(reader, "0", "an index") == 0);
    REQUIRE(read_index(reader, "18446744073709551615", "an index") == 18446744073709551615U);
    for (const char* text : {"", "-1", "+1", "1.0", "a", "18446744073709551616", "1x"}) {
        CAPTURE(text);
        REQUIRE_THROWS_AS(read_index(reader, text, "an index"), FileError);
    }
    try {
        (void)read_index(reader, "x", "a vertex index of face", 12);
    } catch (const FileError& error) {
        REQUIRE(std::string(error.what()) == "t:1: expected a vertex index of face 12, found 'x'");
    }
}
