#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# cleave beside other engines: builds build/release/bin/side_by_side and runs it, with CGAL where libcgal-dev is
# installed, and then Manifold on the same operands where node and the npm package manifold-3d are (the package beside
# this script or in NODE_PATH).
#
#     benchmarks/side_by_side/run.sh [options of side_by_side, but for --json and --write-cases]
#
# Results are printed, and written as JSON to build/release/benchmarks/. All cases take an hour or more; --cases picks.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source .ci/setup.sh

need_build_tools
need_library
need_header benchmark/benchmark.h libbenchmark-dev "the other benchmarks, which CMake configures with this one"
need_program_libraries
install_missing

configure release -DCLEAVE_BUILD_BENCHMARKS=ON
cmake --build --preset release --parallel "$jobs" --target side_by_side

out=build/release/benchmarks
mkdir -p "$out"
build/release/bin/side_by_side --json "$out/side_by_side.json" "$@" || [ $? -eq 1 ]

if ! command -v node >/dev/null 2>&1; then
    echo "skipped: Manifold, because node is not installed"
    exit 0
fi
operands=$(mktemp -d)
trap 'rm -rf "$operands"' EXIT
build/release/bin/side_by_side "$@" --write-cases "$operands"
node benchmarks/side_by_side/manifold.mjs "$operands" --beside "$out/side_by_side.json" |
    tee "$out/side_by_side_manifold.json"
