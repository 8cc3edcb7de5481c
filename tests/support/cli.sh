# SPDX-License-Identifier: Apache-2.0
# Sourced by the tests of the command-line program. $CLEAVE is the program; each test runs in a folder of its own, which
# is emptied first.
set -u
: "${CLEAVE:?names the program}"
rm -rf ./*

failures=0
checks=0

fail() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*" >&2
}

# run ARGUMENT...: runs the program; afterwards $status, $out and $err hold its exit status and what it printed.
run() {
    command_line="cleave $*"
    "$CLEAVE" "$@" >stdout.txt 2>stderr.txt </dev/null
    status=$?
    out=$(cat stdout.txt)
    err=$(cat stderr.txt)
}

expect_status() {
    checks=$((checks + 1))
    [ "$status" -eq "$1" ] || fail "$command_line: exit status $status instead of $1; $err"
}

# expect_equal WHAT FOUND WANTED
expect_equal() {
    checks=$((checks + 1))
    [ "$2" = "$3" ] || fail "$command_line: $1 is
    $2
instead of
    $3"
}

# expect_in WHAT TEXT PART...
expect_in() {
    local what=$1 text=$2 part
    shift 2
    for part in "$@"; do
        checks=$((checks + 1))
        case "$text" in
            *"$part"*) ;;
            *) fail "$command_line: $what does not contain '$part':
    $text" ;;
        esac
    done
}

expect_file() {
    checks=$((checks + 1))
    [ -s "$1" ] || fail "$command_line: there is no file $1"
}

expect_no_file() {
    checks=$((checks + 1))
    [ ! -e "$1" ] || fail "$command_line: left $1 behind"
    local rest
    for rest in "$1".tmp*; do
        [ ! -e "$rest" ] || fail "$command_line: left $rest behind"
    done
}

finish() {
    printf '%s checks, %s failed\n' "$checks" "$failures"
    [ "$failures" -eq 0 ] && [ "$checks" -gt 0 ]
    exit $?
}

# cube X Y Z SIZE: an OFF file of six squares on the standard output; numbers are written as they are given.
cube() {
    awk -v x="$1" -v y="$2" -v z="$3" -v s="$4" 'BEGIN {
        print "OFF\n8 6 0"
        for (i = 0; i < 8; ++i) print x + (i % 2) * s, y + (int(i / 2) % 2) * s, z + int(i / 4) * s
        print "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5"
    }'
}

# Runs the program on arguments that make no sense: it says which PART and how to get help, and writes nothing.
expect_usage_error() { # PART ARGUMENT...
    local part=$1
    shift
    run "$@"
    expect_status 2
    expect_equal "the standard output" "$out" ""
    expect_in "the message" "$err" "cleave: " "$part" "--help"
    expect_no_file out.off
}
