// SPDX-License-Identifier: Apache-2.0
/// `TextWriter`: text in memory, with numbers that read back as the same value.
#ifndef CLEAVE_IO_TEXT_WRITER_HPP
#define CLEAVE_IO_TEXT_WRITER_HPP

#include <cleave/number/rational.hpp>
#include <cleave/number/text.hpp>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// Collects text; `take` hands it over. Locale plays no part.
class TextWriter {
public:
    TextWriter& operator<<(std::string_view text) {
        text_ += text;
        return *this;
    }
    TextWriter& operator<<(char c) {
        text_ += c;
        return *this;
    }
    TextWriter& operator<<(std::uint64_t n) { return append_characters(n); }
    TextWriter& operator<<(std::uint32_t n) { return append_characters(n); }

    /// The shortest decimal that reads back as the same double.
    TextWriter& operator<<(double x) { return append_characters(x); }

    /// "p/q", or "p" for an integer: exact.
    TextWriter& operator<<(const Rational& x) {
        text_ += to_text(x);
        return *this;
    }

    void reserve(std::size_t bytes) { text_.reserve(bytes); }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    [[nodiscard]] std::string take() noexcept { return std::move(text_); }

private:
    template <class T>
    TextWriter& append_characters(T value) {
        char buffer[32];  // 24 characters suffice for a double, 20 for an integer
        const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, value);
        text_.append(buffer, end.ptr);
        return *this;
    }

    std::string text_;
};

CLEAVE_END_NAMESPACE

#endif
