// SPDX-License-Identifier: Apache-2.0
/// Numbers in mesh files: indices, and coordinates as doubles or exact rationals, with messages that say where.
#ifndef CLEAVE_IO_COORDINATE_HPP
#define CLEAVE_IO_COORDINATE_HPP

#include <cleave/base/error.hpp>
#include <cleave/io/text_reader.hpp>
#include <cleave/number/rational.hpp>
#include <cleave/number/text.hpp>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

CLEAVE_BEGIN_NAMESPACE

/// The largest exponent, up or down, of a rational coordinate in a file: far beyond that of any double, and small
/// enough that a damaged file cannot ask for a number that fills the memory.
inline constexpr std::int64_t max_coordinate_exponent = 4096;

/// A non-negative whole number. `what`, and `number` behind it if given, name it in the message.
/// Throws: FileError with the reader's line.
[[nodiscard]] inline std::uint64_t read_index(const TextReader& reader, std::string_view word, const char* what,
                                              std::optional<std::size_t> number = std::nullopt) {
    std::uint64_t value = 0;
    const std::from_chars_result end = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end.ec != std::errc() || end.ptr != word.data() + word.size() || word.empty()) {
        reader.fail_expected(what + (number ? ' ' + std::to_string(*number) : std::string()), word);
    }
    return value;
}

namespace detail {

[[noreturn]] inline void fail_coordinate(const TextReader& reader, std::string_view word, std::size_t vertex,
                                         std::size_t axis, const std::string& why) {
    reader.fail("expected the " + std::string(1, "xyz"[axis]) + " coordinate of vertex " + std::to_string(vertex) +
                ", found " + (word.empty() ? "the end of the line" : quote_word(word)) +
                (why.empty() ? "" : ": " + why));
}

/// True where some exponent in the word is beyond the limit. A word that is no number may answer anything.
[[nodiscard]] inline bool has_huge_exponent(std::string_view word) {
    for (std::size_t e = word.find_first_of("eE"); e != std::string_view::npos; e = word.find_first_of("eE", e + 1)) {
        std::string_view digits = word.substr(e + 1);
        if (digits.starts_with('-') || digits.starts_with('+')) digits.remove_prefix(1);
        std::int64_t exponent = 0;
        const std::from_chars_result end = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        if (end.ec == std::errc::result_out_of_range || exponent > max_coordinate_exponent) return true;
    }
    return false;
}

}  // namespace detail

/// The double nearest to a decimal. Refuses what is not finite as a double, and fractions `p/q`, which doubles could
/// only approximate. Throws: FileError with the reader's line.
inline void read_coordinate(const TextReader& reader, std::string_view word, std::size_t vertex, std::size_t axis,
                            double& value) {
    const char* const last = word.data() + word.size();
    const std::from_chars_result end = std::from_chars(word.data(), last, value);
    if (end.ec == std::errc() && end.ptr == last && std::isfinite(value)) return;
    // Rare forms (a plus sign, underflow) and everything that is wrong.
    if (word.empty()) detail::fail_coordinate(reader, word, vertex, axis, "");
    if (word.find('/') != std::string_view::npos) {
        detail::fail_coordinate(reader, word, vertex, axis, "a fraction; read this file as rationals");
    }
    try {
        value = parse_double(word);
    } catch (const NumberError& error) {
        detail::fail_coordinate(reader, word, vertex, axis, error.what());
    }
}

/// The exact value of a decimal or of a fraction `p/q`. Throws: FileError with the reader's line.
inline void read_coordinate(const TextReader& reader, std::string_view word, std::size_t vertex, std::size_t axis,
                            Rational& value) {
    if (word.empty()) detail::fail_coordinate(reader, word, vertex, axis, "");
    if (detail::has_huge_exponent(word)) {
        detail::fail_coordinate(reader, word, vertex, axis,
                                "its exponent is beyond " + std::to_string(max_coordinate_exponent));
    }
    try {
        value = parse_number<Rational>(word);
    } catch (const NumberError& error) {
        detail::fail_coordinate(reader, word, vertex, axis, error.what());
    }
}

CLEAVE_END_NAMESPACE

#endif
