# SPDX-License-Identifier: Apache-2.0
# Command lines that make no sense end with 2; help and version; what --quiet leaves.
source "$(dirname "${BASH_SOURCE[0]}")/../support/cli.sh"

cube 0 0 0 2 >a.off
cube 1 1 1 2 >b.off

expect_usage_error "subcommand"
expect_usage_error "there is no subcommand 'join'" join a.off b.off -o out.off
expect_usage_error "two operands or more, found 0" union -o out.off
expect_usage_error "two operands or more, found 1" union a.off -o out.off
expect_usage_error "-o OUT" union a.off b.off
expect_usage_error "--engine" union a.off b.off -o out.off --engine magic
expect_usage_error "--frobnicate" union a.off b.off -o out.off --frobnicate
for nonsense in 0 -1 two 1.5 1025 99999999999999999999; do
    expect_usage_error "--threads" union a.off b.off -o out.off --threads "$nonsense"
    expect_usage_error "--threads" check a.off --threads "$nonsense"
done
expect_usage_error "STL cannot hold" union a.off b.off -o out.stl --rational
expect_usage_error "which file" info
expect_usage_error "one file" check
expect_usage_error "one file" check a.off b.off
expect_usage_error "--output" info a.off --output out.off
expect_usage_error "--engine" check a.off --engine automatic

run --help
expect_status 0
expect_equal "the error stream" "$err" ""
expect_in "the help" "$out" "union" "intersection" "difference" "symmetric-difference" "xor" "eval" "info" "check" \
    "Examples:" "Exit status"
for subcommand in union intersection difference symmetric-difference xor eval resolve info check; do
    run "$subcommand" --help
    expect_status 0
    expect_in "the help" "$out" "Usage: cleave" "--json" "--rational" "--strict" "--threads N" "--quiet" "Example:"
done
run --version
expect_status 0
[[ "$out" =~ ^cleave\ [0-9]+\.[0-9]+\.[0-9]+$ ]] || fail "the version is '$out'"

run union a.off b.off -o out.off --quiet
expect_status 0
expect_equal "all output" "$out$err" ""
expect_file out.off
run info a.off --quiet
expect_status 0
expect_equal "all output" "$out$err" ""
run check a.off --quiet
expect_status 0
expect_equal "all output" "$out$err" ""
run union a.off b.off -o out.off --quiet --json
expect_equal "the number of lines" "$(wc -l <stdout.txt | tr -d ' ')" 1
run union a.off missing.off -o out.off --quiet
expect_status 1
expect_in "the message" "$err" "missing.off"
# Not a terminal: no progress line, whatever it takes.
run union a.off b.off -o out.off
case "$err" in *$'\r'* | *$'\033'*) fail "a progress line on a stream that is no terminal" ;; esac
finish
