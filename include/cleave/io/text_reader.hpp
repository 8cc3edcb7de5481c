// SPDX-License-Identifier: Apache-2.0
/// Reading text files: the bytes of a file, a cursor over its lines and words, and numbers with messages that say
/// where.
#ifndef CLEAVE_IO_TEXT_READER_HPP
#define CLEAVE_IO_TEXT_READER_HPP

#include <cleave/base/error.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// All bytes of a file (or pipe). Throws: FileError where it is missing, a directory, or unreadable.
[[nodiscard]] inline std::string read_file(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw FileError(path.string(), 0, "is a directory; name a mesh file in it");
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.string().c_str(), "rb"), &std::fclose);
    if (!file) throw FileError(path.string(), 0, std::string("cannot be opened: ") + std::strerror(errno));
    std::string text;
    // The size is only a hint: it is zero for pipes, and a file may change while it is read.
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    std::size_t filled = 0;
    text.resize(ignored ? 0 : static_cast<std::size_t>(size) + 1);
    for (;;) {
        if (filled == text.size()) text.resize(filled + std::max<std::size_t>(filled / 2, std::size_t{1} << 16));
        const std::size_t got = std::fread(text.data() + filled, 1, text.size() - filled, file.get());
        filled += got;
        if (got == 0) break;
    }
    if (std::ferror(file.get()) != 0) throw FileError(path.string(), 0, "cannot be read to its end");
    text.resize(filled);
    return text;
}

/// A word as it may stand in a message: printable, and not longer than a line.
[[nodiscard]] inline std::string quote_word(std::string_view word) {
    constexpr std::size_t limit = 40;
    std::string result = "'";
    for (const char c : word.substr(0, limit)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte > 0x7e) {
            constexpr std::string_view digits = "0123456789abcdef";
            result += "\\x";
            result += digits[byte >> 4];
            result += digits[byte & 15];
        } else {
            result += c;
        }
    }
    return result + (word.size() > limit ? "...'" : "'");
}

/// A cursor over the lines and words of a text. Words are separated by spaces, tabs and line ends (any of the three
/// conventions); a comment runs from its mark to the end of the line; a backslash at the end of a line continues it
/// where `continued` says so. The text must outlive the reader.
class TextReader {
public:
    enum class Lines : std::uint8_t { separate, continued };

    TextReader(std::string_view text, std::string file, char comment = '#', Lines lines = Lines::separate)
        : text_(text), file_(std::move(file)) {
        for (const char c : {' ', '\t', '\v', '\f'}) roles_[static_cast<unsigned char>(c)] = Role::blank;
        roles_[static_cast<unsigned char>(comment)] = Role::comment;
        for (const char c : {'\n', '\r'}) roles_[static_cast<unsigned char>(c)] = Role::line_end;
        if (lines == Lines::continued) roles_[static_cast<unsigned char>('\\')] = Role::backslash;
        if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // the byte order mark of UTF-8 says nothing
        if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff")) {
            fail("expected plain text, found UTF-16; save the file as UTF-8 or ASCII");
        }
    }

    /// The next word of this line; empty at its end.
    [[nodiscard]] std::string_view word() {
        skip_blanks();
        const std::size_t begin = at_;
        while (at_ < text_.size() && (role(text_[at_]) == Role::word || backslash_in_word())) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    /// The next word of this line or a later one; empty at the end of the text.
    [[nodiscard]] std::string_view next_word() {
        for (;;) {
            const std::string_view w = word();
            if (!w.empty() || !next_line()) return w;
        }
    }

    /// Goes to the start of the next line; false at the end of the text.
    bool next_line() {
        while (at_ < text_.size() && role(text_[at_]) != Role::line_end) ++at_;
        if (at_ == text_.size()) return false;
        pass_line_end();
        return true;
    }

    /// True where nothing but blanks and a comment is left on this line.
    [[nodiscard]] bool at_line_end() {
        skip_blanks();
        return at_ == text_.size() || role(text_[at_]) == Role::line_end || role(text_[at_]) == Role::comment;
    }

    /// The rest of this line, comment included.
    [[nodiscard]] std::string_view rest_of_line() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && role(text_[at_]) != Role::line_end) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    [[nodiscard]] std::size_t line() const noexcept { return line_; }
    [[nodiscard]] std::size_t bytes_left() const noexcept { return text_.size() - at_; }
    [[nodiscard]] const std::string& file() const noexcept { return file_; }

    /// Throws a FileError that names this line.
    [[noreturn]] void fail(const std::string& what) const { throw FileError(file_, line_, what); }

    /// Throws a FileError: what should be here, and the word that is here instead.
    [[noreturn]] void fail_expected(const std::string& expected, std::string_view found) const {
        fail("expected " + expected + ", found " + (found.empty() ? "the end of the line" : quote_word(found)));
    }

private:
    /// What a character does. A backslash continues a line or is part of a word.
    enum class Role : std::uint8_t { word, blank, line_end, comment, backslash };

    [[nodiscard]] Role role(char c) const noexcept { return roles_[static_cast<unsigned char>(c)]; }

    /// Passes one line end: LF, CR LF or CR.
    void pass_line_end() {
        if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
        ++at_;
        ++line_;
    }

    void skip_blanks() {
        for (;;) {
            while (at_ < text_.size() && role(text_[at_]) == Role::blank) ++at_;
            if (at_ == text_.size() || role(text_[at_]) != Role::backslash || backslash_in_word()) return;
            ++at_;
            pass_line_end();
        }
    }

    /// At a backslash that ends no line.
    [[nodiscard]] bool backslash_in_word() const noexcept {
        return role(text_[at_]) == Role::backslash &&
               (at_ + 1 == text_.size() || role(text_[at_ + 1]) != Role::line_end);
    }

    std::string_view text_;
    std::string file_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::array<Role, 256> roles_{};
};

CLEAVE_END_NAMESPACE

#endif
