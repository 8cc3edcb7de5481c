// SPDX-License-Identifier: Apache-2.0
/// `OutputFile`: a file that appears complete under its name, or not at all.
#ifndef CLEAVE_IO_OUTPUT_FILE_HPP
#define CLEAVE_IO_OUTPUT_FILE_HPP

#include <cleave/base/error.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

CLEAVE_BEGIN_NAMESPACE

/// Writes to a temporary sibling of the named file, which `commit` renames over it. Without a commit (an exception, a
/// full disk) the destructor removes the temporary file and an older file of that name is untouched.
///
/// A name that exists and is not a regular file (a device, a pipe) is written to directly: it must not be replaced. A
/// symbolic link is followed. A replaced file hands its permissions on.
class OutputFile {
public:
    /// Opens the temporary file. Throws: FileError where that fails (no such directory, no permission).
    explicit OutputFile(const std::filesystem::path& path) : name_(path.string()), target_(path) {
        namespace fs = std::filesystem;
        std::error_code ignored;
        if (fs::is_directory(path, ignored)) throw FileError(name_, 0, "is a directory; name a file in it");
        // By hand, because canonical paths are for files that exist. A loop of links ends where opening fails.
        for (int links = 0; links < 40 && fs::is_symlink(target_, ignored); ++links) {
            const fs::path next = fs::read_symlink(target_, ignored);
            if (ignored) break;
            target_ = next.is_absolute() ? next : target_.parent_path() / next;
        }
        if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored)) {
            file_ = std::fopen(target_.string().c_str(), "wb");
            if (file_ == nullptr) fail("cannot be opened for writing", errno);
            return;
        }
        // "x" refuses a name that is taken, so two writers never share a temporary file.
        std::random_device random;
        for (int attempt = 0; attempt < 16 && file_ == nullptr; ++attempt) {
            temporary_ = target_;
            temporary_ += ".tmp" + std::to_string(random());
            errno = 0;
            file_ = std::fopen(temporary_.string().c_str(), "wbx");
            if (file_ == nullptr && errno != EEXIST) break;
        }
        if (file_ == nullptr) {
            temporary_.clear();
            fail("cannot be created", errno);
        }
        const fs::file_status old = fs::status(target_, ignored);
        if (!ignored && fs::exists(old)) fs::permissions(temporary_, old.permissions(), ignored);
    }

    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    ~OutputFile() {
        if (file_ != nullptr) std::fclose(file_);
        remove_temporary();
    }

    /// Appends bytes. Throws: FileError where the disk is full or fails.
    void write(std::string_view bytes) {
        if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("cannot be written", errno);
    }

    /// Makes the file appear under its name. Throws: FileError, and nothing appears.
    void commit() {
        const bool flushed = std::fflush(file_) == 0;
        const int why = errno;
        const bool closed = std::fclose(std::exchange(file_, nullptr)) == 0;
        if (!flushed) fail("cannot be written", why);
        if (!closed) fail("cannot be written", errno);
        if (temporary_.empty()) return;
        std::error_code error;
        std::filesystem::rename(temporary_, target_, error);
        if (error) {
            remove_temporary();
            throw FileError(name_, 0, "cannot be replaced: " + error.message());
        }
        temporary_.clear();
    }

private:
    [[noreturn]] void fail(const char* what, int why) {
        if (file_ != nullptr) std::fclose(std::exchange(file_, nullptr));
        remove_temporary();
        throw FileError(name_, 0, std::string(what) + ": " + std::strerror(why));
    }

    void remove_temporary() noexcept {
        if (temporary_.empty()) return;
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
        temporary_.clear();
    }

    std::string name_;  // as the caller wrote it, for messages
    std::filesystem::path target_;
    std::filesystem::path temporary_;  // empty where the target is written to directly
    std::FILE* file_ = nullptr;
};

/// Writes a whole file at once. Throws: FileError, and no partial file is left.
inline void write_file(const std::filesystem::path& path, std::string_view bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

CLEAVE_END_NAMESPACE

#endif
