#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the benchmarks in build/release/bin and runs them, or those named:
#
#     benchmarks/run.sh [name...] [-- Google Benchmark options]
#     benchmarks/run.sh --smoke            all of them, an instant each: do they run, and are their answers right?
#
# Results are printed, and written as JSON to build/release/benchmarks/. CGAL's Nef polyhedra and the Parma Polyhedra
# Library run beside cleave where libcgal-dev and libppl-dev are installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/setup.sh

smoke=false
names=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    if [ "$1" = --smoke ]; then smoke=true; else names+=("$1"); fi
    shift
done
[ $# -eq 0 ] || shift

need_build_tools
need_library
need_program_libraries
need_header benchmark/benchmark.h libbenchmark-dev "the benchmarks"
install_missing

configure release -DCLEAVE_BUILD_BENCHMARKS=ON
targets=()
for name in "${names[@]}"; do targets+=(--target "bench_$name"); done
cmake --build --preset release --parallel "$jobs" "${targets[@]}"
if $smoke; then
    exec ctest --preset release --label-regex benchmark
fi

mkdir -p build/release/benchmarks
if [ ${#names[@]} -eq 0 ]; then
    for program in build/release/bin/bench_*; do names+=("${program##*/bench_}"); done
fi
for name in "${names[@]}"; do
    "build/release/bin/bench_$name" --benchmark_out="build/release/benchmarks/$name.json" "$@"
done
