#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds every example in build/release/bin on a machine that has nothing but a compiler, runs each and compares what it
# prints with examples/expected/, and last runs the main job, the union and the difference of two solids:
#
#     examples/run.sh
#
# What is missing is installed from Debian's packages. The files that examples write are in build/release/out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/setup.sh

need_build_tools
need_library
need_program_libraries
install_missing

configure release
cmake --build --preset release --parallel "$jobs"
ctest --preset release --label-regex example --parallel "$jobs"

if [ -x build/release/bin/union_of_solids ]; then
    mkdir -p build/release/out/union_of_solids
    cd build/release/out/union_of_solids
    printf '\n%s\n' "build/release/bin/union_of_solids, run in $(pwd):"
    ../../bin/union_of_solids
    ls -l
fi
