# SPDX-License-Identifier: Apache-2.0
# Sourced by the run scripts: finds out what a machine lacks, and installs that and nothing else.
#
# need_program <program> <Debian package> [<what for>]
# need_header <header> <Debian package> [<what for>]     any of "a.hpp|b.hpp"; the compiler looks, so any installation
#                                                        counts
# install_missing                                        installs, or prints the line that would, and stops

missing_packages=()
missing_reasons=()

compiler=${CXX:-c++}

need_program() {
    if command -v "$1" >/dev/null 2>&1; then return; fi
    missing_packages+=("$2")
    missing_reasons+=("$1 (Debian package $2)${3:+: $3}")
}

need_header() {
    local header
    for header in ${1//|/ }; do
        if command -v "$compiler" >/dev/null 2>&1 &&
            printf '#include <%s>\n' "$header" | "$compiler" -std=c++20 -x c++ -fsyntax-only - >/dev/null 2>&1; then
            return
        fi
    done
    missing_packages+=("$2")
    missing_reasons+=("<${1//|/> or <}> (Debian package $2)${3:+: $3}")
}

install_missing() {
    [ ${#missing_packages[@]} -eq 0 ] && return
    printf 'missing: %s\n' "${missing_reasons[@]}"
    # Never remove anything: the machine may carry another Boost, say, that excludes the packaged one.
    local install="apt-get install -y --no-remove --no-install-recommends ${missing_packages[*]}"
    if ! command -v apt-get >/dev/null 2>&1; then
        printf 'This machine has no apt-get. Install what is missing with its own package manager and run this again.\n' >&2
        exit 1
    fi
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null 2>&1 || { [ ! -t 0 ] && ! sudo -n true 2>/dev/null; }; then
            printf 'Neither root nor sudo here. Have this run as root, then run this again:\n    %s\n' "$install" >&2
            exit 1
        fi
        as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update -q </dev/null
    if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive $install </dev/null; then
        printf 'The installation failed. What was tried:\n    %s\n' "$install" >&2
        exit 1
    fi
    missing_packages=()
    missing_reasons=()
}

need_build_tools() {
    need_program "$compiler" "${compiler_package:-g++}" "a C++20 compiler"
    need_program cmake cmake
    need_program ninja ninja-build
}

need_library() {
    need_header gmpxx.h libgmp-dev "fast exact rationals"
    need_header boost/multiprecision/cpp_int.hpp libboost-dev "the numbers of Boost.Multiprecision"
    need_header tbb/task_arena.h libtbb-dev "the oneTBB executor"
}

need_program_libraries() {
    need_header CLI/CLI.hpp libcli11-dev "the command-line program"
    need_header nlohmann/json.hpp nlohmann-json3-dev "the command-line program"
}

# configure <preset> [<cmake argument>...]
configure() {
    local preset=$1
    shift
    if [ -z "${CMAKE_CXX_COMPILER_LAUNCHER:-}" ] && command -v ccache >/dev/null 2>&1; then
        export CMAKE_CXX_COMPILER_LAUNCHER=ccache
        # Lets ccache keep what was compiled with a precompiled header, and find it again from another clone. The presets
        # are part of the key: a header precompiled with other flags would be refused by the compiler.
        export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_EXTRAFILES=$PWD/CMakePresets.json
    fi
    [ -z "${CXX:-}" ] || set -- "-DCMAKE_CXX_COMPILER=$CXX" "$@"
    cmake --preset "$preset" "$@"
}

jobs=$(nproc 2>/dev/null || echo 2)
