// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/error.hpp>

#include "support/catch.hpp"

#include <stdexcept>
#include <string>

using namespace cleave;

TEST_CASE("error: a file error names the file, and the line where there is one") {
    const FileError at_line("part.off", 12, "expected three numbers");
    CHECK(at_line.what() == std::string("part.off:12: expected three numbers"));
    CHECK(at_line.file() == "part.off");
    CHECK(at_line.line() == 12);

    const FileError unopened("part.off", 0, "no such file");
    CHECK(unopened.what() == std::string("part.off: no such file"));
    CHECK(unopened.line() == 0);
}

TEST_CASE("error: every error is an Error, and an Error is a runtime_error") {
    CHECK_THROWS_AS(throw FileError("a", 0, "b"), Error);
    CHECK_THROWS_AS(throw NumberError("b"), Error);
    CHECK_THROWS_AS(throw Cancelled(), Error);
    CHECK_THROWS_AS(throw NumberError("b"), std::runtime_error);
}
