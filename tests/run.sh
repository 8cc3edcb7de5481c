#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds and runs all tests on a machine that has nothing but a compiler:
#
#     tests/run.sh [preset]
#
# The preset is one of CMakePresets.json (dev unless given). What is missing is installed from Debian's packages.
# The last line is the verdict of ctest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=${1:-dev}
if [ "$preset" = clang ]; then
    CXX=${CXX:-$(command -v clang++-14 || command -v clang++ || echo clang++)}
    compiler_package=clang
fi
source .ci/setup.sh

need_build_tools
need_library
need_program_libraries
need_header "catch2/catch.hpp|catch2/catch_test_macros.hpp" catch2 "the tests"
need_header rapidcheck.h librapidcheck-dev "the properties among the tests"
install_missing

configure "$preset"
cmake --build --preset "$preset" --parallel "$jobs"

printed=build/$preset/ctest.txt
status=0
ctest --preset "$preset" --parallel "$jobs" ${CLEAVE_CTEST_ARGUMENTS:-} 2>&1 | tee "$printed" || status=$?
# ctest shows the output of failures alone; what was skipped must be seen too, by name.
grep -h '^skipped: ' "build/$preset/Testing/Temporary/LastTest.log" || true
grep -E '^[0-9]+% tests passed' "$printed" || printf 'No tests were run.\n'
exit "$status"
