// SPDX-License-Identifier: Apache-2.0
#include <cleave/io/text_reader.hpp>

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <string>
#include <vector>

using namespace cleave;

namespace {

std::string message(const auto& action) {
    try {
        action();
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

/// All words with their lines: "1:a 1:b 3:c".
std::string words(TextReader reader) {
    std::string result;
    for (std::string_view w = reader.next_word(); !w.empty(); w = reader.next_word()) {
        result += (result.empty() ? "" : " ") + std::to_string(reader.line()) + ":" + std::string(w);
    }
    return result;
}

}  // namespace

TEST_CASE("text_reader: words, lines and comments") {
    REQUIRE(words({"a b\tc\n\n  d # e f\ng", "t"}) == "1:a 1:b 1:c 3:d 4:g");
    REQUIRE(words({"", "t"}).empty());
    REQUIRE(words({"# only a comment", "t"}).empty());
    REQUIRE(words({"   \n\t\n", "t"}).empty());
    REQUIRE(words({"a#b\nc", "t"}) == "1:a 2:c");
    REQUIRE(words({"a % b\n", "t", '%'}) == "1:a");
}

TEST_CASE("text_reader: the three line ends, and a byte order mark") {
    REQUIRE(words({"a\nb\n\nc", "t"}) == "1:a 2:b 4:c");
    REQUIRE(words({"a\r\nb\r\n\r\nc", "t"}) == "1:a 2:b 4:c");
    REQUIRE(words({"a\rb\r\rc", "t"}) == "1:a 2:b 4:c");
    REQUIRE(words({"\xef\xbb\xbf"
                   "a",
                   "t"}) == "1:a");
    REQUIRE(message([] {
                (void)words({std::string_view("\xff\xfe"
                                              "a\0",
                                              4),
                             "t"});
            }) == "t:1: expected plain text, found UTF-16; save the file as UTF-8 or ASCII");
}

TEST_CASE("text_reader: a backslash continues a line only where that is asked for") {
    const auto continued = TextReader::Lines::continued;
    TextReader reader("f 1 2\\\n 3 \\\r\n4\nv", "t", '#', continued);
    std::vector<std::string> line;
    for (std::string_view w = reader.word(); !w.empty(); w = reader.word()) line.emplace_back(w);
    REQUIRE(line == std::vector<std::string>{"f", "1", "2", "3", "4"});
    REQUIRE(reader.line() == 3);
    REQUIRE(reader.next_line());
    REQUIRE(reader.word() == "v");
    REQUIRE(reader.line() == 4);
    REQUIRE_FALSE(reader.next_line());
    REQUIRE(words({"a\\\nb", "t"}) == "1:a\\ 2:b");
    REQUIRE(words({"a\\b c:\\d\\", "t", '#', continued}) == "1:a\\b 1:c:\\d\\");
    REQUIRE(words({"\\\n\\\n\\\na", "t", '#', continued}) == "4:a");
}

TEST_CASE("text_reader: the rest of a line") {
    TextReader reader("a b # c\nd", "t");
    REQUIRE(reader.word() == "a");
    REQUIRE_FALSE(reader.at_line_end());
    REQUIRE(reader.word() == "b");
    REQUIRE(reader.at_line_end());
    REQUIRE(reader.rest_of_line() == "# c");
    REQUIRE(reader.rest_of_line().empty());
    REQUIRE(reader.bytes_left() == 2);
    REQUIRE(reader.next_word() == "d");
    REQUIRE(reader.word().empty());
    REQUIRE(reader.bytes_left() == 0);
}

TEST_CASE("text_reader: messages name file and line, and quote words as printable text") {
    TextReader reader(
        "one\n\x01\xc3\xa4"
        "bc",
        "dir/file.off");
    (void)reader.next_word();
    const std::string_view word = reader.next_word();
    REQUIRE(message([&] { reader.fail_expected("a number", word); }) ==
            "dir/file.off:2: expected a number, found '\\x01\\xc3\\xa4bc'");
    REQUIRE(message([&] { reader.fail_expected("a number", ""); }) ==
            "dir/file.off:2: expected a number, found the end of the line");
    REQUIRE(quote_word(std::string(1000, 'x')) == "'" + std::string(40, 'x') + "...'");
    try {
        reader.fail("what");
    } catch (const FileError& error) {
        REQUIRE(error.file() == "dir/file.off");
        REQUIRE(error.line() == 2);
    }
}

TEST_CASE("text_reader: files are read whole, whatever is in them") {
    const TemporaryFolder folder;
    std::string bytes;
    for (int i = 0; i < 200000; ++i) bytes += static_cast<char>(i * 7);
    REQUIRE(read_file(folder.write("all.bin", bytes)) == bytes);
    REQUIRE(read_file(folder.write("empty", "")).empty());
}

TEST_CASE("text_reader: missing files and directories are errors that say so") {
    const TemporaryFolder folder;
    const std::string missing = message([&] { (void)read_file(folder.file("missing.off")); });
    REQUIRE(missing.starts_with(folder.file("missing.off").string() + ": cannot be opened: "));
    REQUIRE(message([&] { (void)read_file(folder.path()); }) ==
            folder.path().string() + ": is a directory; name a mesh file in it");
}
