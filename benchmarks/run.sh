#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the benchmarks in build/release/bin and runs them, or those named:
#
#     benchmarks/run.sh [name...] [-- Google Benchmark options]
#
# Results are printed, and written as JSON to build/release/benchmarks/. CGAL's Nef polyhedra run beside cleave where
# libcgal-dev is installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/setup.sh

names=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    names+=("$1")
    shift
done
[ $# -eq 0 ] || shift

need_build_tools
need_library
need_program_libraries
need_header benchmark/benchmark.h libbenchmark-dev "the benchmarks"
install_missing

configure release -DCLEAVE_BUILD_BENCHMARKS=ON
if [ ${#names[@]} -eq 0 ]; then
    for source in benchmarks/*.cpp; do names+=("$(basename "$source" .cpp)"); done
fi
mkdir -p build/release/benchmarks
for name in "${names[@]}"; do
    # A benchmark that needs CGAL has no target without it; CMake has said so above.
    if ! cmake --build --preset release --parallel "$jobs" --target "bench_$name"; then
        [ -z "$(grep -l '#include <CGAL/' "benchmarks/$name.cpp")" ] && exit 1
        printf 'skipped: %s needs CGAL (Debian package libcgal-dev)\n' "$name"
        continue
    fi
    "build/release/bin/bench_$name" --benchmark_out="build/release/benchmarks/$name.json" "$@"
done
