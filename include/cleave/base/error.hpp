// SPDX-License-Identifier: Apache-2.0
/// Errors for bad data. Each carries its evidence (file, line, face, vertex) and says what to do about it.
/// Degenerate positions are never errors: they are values.
#ifndef CLEAVE_BASE_ERROR_HPP
#define CLEAVE_BASE_ERROR_HPP

#include <cleave/base/config.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// Base of every error that the library throws because of its input.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A number could not be read, or a result does not fit the number type that the caller chose.
class NumberError : public Error {
public:
    using Error::Error;
};

/// A file could not be opened, read or written.
class FileError : public Error {
public:
    /// `line` is 1-based; 0 where no line can be named (a binary file, a failure to open).
    FileError(std::string file, std::size_t line, const std::string& what)
        : Error(line == 0 ? file + ": " + what : file + ":" + std::to_string(line) + ": " + what),
          file_(std::move(file)),
          line_(line) {}

    [[nodiscard]] const std::string& file() const noexcept { return file_; }
    [[nodiscard]] std::size_t line() const noexcept { return line_; }

private:
    std::string file_;
    std::size_t line_;
};

/// Long work was stopped on request; operands are untouched.
class Cancelled : public Error {
public:
    Cancelled() : Error("the operation was cancelled") {}
};

CLEAVE_END_NAMESPACE

#endif
