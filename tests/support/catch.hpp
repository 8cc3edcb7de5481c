// SPDX-License-Identifier: Apache-2.0
/// The test framework as every test sees it: Catch2, 2.13 or 3, whichever is installed, with rapidcheck's assertions,
/// and what the tests of real models and of long loops need. Properties are written with support/property.hpp.
///
/// `RC_PARAMS="seed=7 max_success=1000"` sets rapidcheck's seed and number of cases; without a seed it is always 1.
/// `CLEAVE_TEST_SCALE=20` makes `scaled(n)` a fifth of n, for slow builds (sanitizers).
/// `CLEAVE_MODELS_DIR=folder` says where the real meshes are; tests of them are skipped by name without it.
#ifndef CLEAVE_TESTS_SUPPORT_CATCH_HPP
#define CLEAVE_TESTS_SUPPORT_CATCH_HPP

#if __has_include(<catch2/catch_all.hpp>)
#define CLEAVE_TEST_CATCH_VERSION 3
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_all.hpp>
#else
#define CLEAVE_TEST_CATCH_VERSION 2
#include <catch2/catch.hpp>
#endif

#include <rapidcheck/Assertions.h>
#include <rapidcheck/Log.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <string>

/// The test cases that said they cannot run here. The main program tells it which test case is running.
class SkippedTests {
public:
    [[nodiscard]] static SkippedTests& all() {
        static SkippedTests tests;
        return tests;
    }

    void set_running(const std::string& name) { running_ = name; }

    /// Prints the name and the reason the first time a test case is skipped.
    void add(const std::string& reason) {
        if (names_.insert(running_).second) std::printf("skipped: %s: %s\n", running_.c_str(), reason.c_str());
    }

    [[nodiscard]] std::size_t count() const { return names_.size(); }

private:
    std::string running_;
    std::set<std::string> names_;
};

/// Leaves the running test case, and says so by name. Only in the body of a test case (not in a function it calls).
#define CLEAVE_SKIP(reason)              \
    do {                                 \
        SkippedTests::all().add(reason); \
        return;                          \
    } while (false)

/// The folder of real meshes, or nullopt where the machine has none.
[[nodiscard]] inline std::optional<std::filesystem::path> models_dir() {
    const char* folder = std::getenv("CLEAVE_MODELS_DIR");
    if (folder == nullptr || *folder == '\0') return std::nullopt;
    return std::filesystem::path(folder);
}

/// Declares `path`, the file of a real mesh, or skips the running test case.
#define CLEAVE_MODEL_OR_SKIP(path, file_name)                       \
    if (!models_dir()) CLEAVE_SKIP("CLEAVE_MODELS_DIR is not set"); \
    const std::filesystem::path path = *models_dir() / (file_name); \
    if (!std::filesystem::exists(path)) CLEAVE_SKIP(path.string() + " does not exist")

/// n, or the share of it (at least 1) that CLEAVE_TEST_SCALE asks for, in percent.
[[nodiscard]] inline std::size_t scaled(std::size_t n) {
    static const std::size_t percent = [] {
        const char* text = std::getenv("CLEAVE_TEST_SCALE");
        return text == nullptr || *text == '\0' ? std::size_t(100) : static_cast<std::size_t>(std::stoul(text));
    }();
    const std::size_t share = n * percent / 100;
    return share == 0 ? 1 : share;
}

#endif
