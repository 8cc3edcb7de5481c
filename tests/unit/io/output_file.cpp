// SPDX-License-Identifier: Apache-2.0
/// Files that appear complete or not at all.
#include <cleave/io/output_file.hpp>

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <csignal>
#include <filesystem>
#include <string>

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#define CLEAVE_TEST_HAS_FILE_LIMIT 1
#else
#define CLEAVE_TEST_HAS_FILE_LIMIT 0
#endif

using namespace cleave;
namespace fs = std::filesystem;

namespace {

std::string message(const auto& action) {
    try {
        action();
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("output_file: nothing appears before the commit, everything after it") {
    const TemporaryFolder folder;
    const fs::path path = folder.file("out.off");
    {
        OutputFile out(path);
        out.write("first ");
        REQUIRE_FALSE(fs::exists(path));
        out.write("second");
        out.commit();
    }
    REQUIRE(TemporaryFolder::read(path) == "first second");
    REQUIRE(folder.count() == 1);
}

TEST_CASE("output_file: without a commit an older file stays as it was") {
    const TemporaryFolder folder;
    const fs::path path = folder.write("out.off", "old");
    {
        OutputFile out(path);
        out.write("new");
    }
    REQUIRE(TemporaryFolder::read(path) == "old");
    REQUIRE(folder.count() == 1);
    write_file(path, "new");
    REQUIRE(TemporaryFolder::read(path) == "new");
    REQUIRE(folder.count() == 1);
}

TEST_CASE("output_file: a replaced file hands its permissions on") {
    const TemporaryFolder folder;
    const fs::path path = folder.write("out.off", "old");
    const fs::perms mode = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
    fs::permissions(path, mode);
    write_file(path, "new");
    REQUIRE(fs::status(path).permissions() == mode);
}

TEST_CASE("output_file: a symbolic link is followed, not replaced") {
    const TemporaryFolder folder;
    const fs::path target = folder.write("target.off", "old");
    const fs::path link = folder.file("link.off");
    fs::create_symlink("target.off", link);
    write_file(link, "new");
    REQUIRE(fs::is_symlink(link));
    REQUIRE(TemporaryFolder::read(target) == "new");
    // A link to a file that does not exist yet.
    const fs::path dangling = folder.file("dangling.off");
    fs::create_symlink("later.off", dangling);
    write_file(dangling, "newer");
    REQUIRE(fs::is_symlink(dangling));
    REQUIRE(TemporaryFolder::read(folder.file("later.off")) == "newer");
    REQUIRE(folder.count() == 4);
}

TEST_CASE("output_file: no such folder, and a folder in place of a file") {
    const TemporaryFolder folder;
    const fs::path nowhere = folder.file("nowhere") / "out.off";
    REQUIRE(message([&] { write_file(nowhere, "x"); }).starts_with(nowhere.string() + ": cannot be created: "));
    REQUIRE(message([&] { write_file(folder.path(), "x"); }) ==
            folder.path().string() + ": is a directory; name a file in it");
    REQUIRE(folder.count() == 0);
}

TEST_CASE("output_file: a full disk is reported") {
    // A device that is always full; the write may succeed into a buffer, the commit cannot.
    const fs::path full = "/dev/full";
    if (!fs::is_character_file(full)) CLEAVE_SKIP("this machine has no /dev/full");
    const std::string why = message([&] { write_file(full, std::string(1 << 20, 'x')); });
    REQUIRE(why.starts_with("/dev/full: cannot be written: "));
    REQUIRE(message([&] { write_file(full, "x"); }).starts_with("/dev/full: cannot be written: "));
    REQUIRE(fs::is_character_file(full));
}

#if CLEAVE_TEST_HAS_FILE_LIMIT
TEST_CASE("output_file: a write that fails half way leaves no file, and an older one as it was") {
    // A limit on the size of files stands for a disk that fills up. It holds for this process, so it is put back.
    struct Limit {
        rlimit before{};
        void (*handler)(int) = std::signal(SIGXFSZ, SIG_IGN);
        Limit() {
            getrlimit(RLIMIT_FSIZE, &before);
            rlimit small = before;
            small.rlim_cur = 100000;
            setrlimit(RLIMIT_FSIZE, &small);
        }
        ~Limit() {
            setrlimit(RLIMIT_FSIZE, &before);
            std::signal(SIGXFSZ, handler);
        }
    };
    const TemporaryFolder folder;
    const fs::path old = folder.write("old.off", "old"), fresh = folder.file("fresh.off");
    std::string why_old, why_fresh, why_little;
    {
        const Limit limit;
        why_old = message([&] { write_file(old, std::string(200000, 'x')); });
        why_fresh = message([&] { write_file(fresh, std::string(200000, 'x')); });
        why_little = message([&] { write_file(fresh, std::string(100, 'x')); });
    }
    REQUIRE(why_old.starts_with(old.string() + ": cannot be written: "));
    REQUIRE(why_fresh.starts_with(fresh.string() + ": cannot be written: "));
    REQUIRE(why_little == "no error");
    REQUIRE(TemporaryFolder::read(old) == "old");
    REQUIRE(TemporaryFolder::read(fresh) == std::string(100, 'x'));
    REQUIRE(folder.count() == 2);
}
#endif

TEST_CASE("output_file: a device is written to, not replaced") {
    const fs::path null = "/dev/null";
    if (!fs::is_character_file(null)) CLEAVE_SKIP("this machine has no /dev/null");
    write_file(null, "x");
    REQUIRE(fs::is_character_file(null));
}
