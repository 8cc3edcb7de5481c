# SPDX-License-Identifier: Apache-2.0
# Ctrl-C and SIGTERM: the exit status says so, and no file is left behind, whole or half.
source "$(dirname "${BASH_SOURCE[0]}")/../support/cli.sh"
set -m # background jobs get SIGINT, as they do on a terminal

cube 0 0 0 2 >a.off
mkfifo slow.off

# interrupted SIGNAL STATUS: the program waits for an operand that never comes.
interrupted() {
    command_line="cleave, sent SIG$1"
    "$CLEAVE" union a.off slow.off -o out.off 2>stderr.txt >stdout.txt &
    local job=$! tries=0
    sleep 0.3
    kill -s "$1" "$job"
    while kill -0 "$job" 2>/dev/null && [ "$tries" -lt 200 ]; do
        sleep 0.05
        tries=$((tries + 1))
    done
    kill -s KILL "$job" 2>/dev/null && fail "$command_line did not end"
    wait "$job"
    status=$?
    err=$(cat stderr.txt)
    expect_status "$2"
    expect_in "the message" "$err" "cancelled"
    expect_equal "the standard output" "$(cat stdout.txt)" ""
    expect_no_file out.off
}

interrupted INT 130
interrupted TERM 143

# In the middle of the operation, or wherever it is by then: two corrugated slabs of some thousand faces, crosswise.
slab() { # AXIS
    awk -v n=70 -v axis="$1" 'BEGIN {
        print "OFF"; print 2 * (n + 1) * (n + 1), 4 * n * n + 8 * n, 0
        for (k = 0; k < 2; ++k) for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) {
            w = axis == 0 ? i : j; h = (w % 2) * 0.75 + ((i * 7 + j * 13) % 11) / 64 + (k == 0 ? -2 : 0)
            print i + axis / 3, j + axis / 5, h + axis / 7
        }
        for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
            a = i * (n + 1) + j; b = a + n + 1; t = (n + 1) * (n + 1)
            print 3, a, a + 1, b + 1; print 3, a, b + 1, b
            print 3, a + t, b + 1 + t, a + 1 + t; print 3, a + t, b + t, b + 1 + t
        }
        for (i = 0; i < n; ++i) {
            t = (n + 1) * (n + 1); m = n + 1
            p = i * m; q = p + m; print 3, p, q, q + t; print 3, p, q + t, p + t
            p = (i + 1) * m + n; q = p - m; print 3, p, q, q + t; print 3, p, q + t, p + t
            p = i + 1; q = i; print 3, p, q, q + t; print 3, p, q + t, p + t
            p = n * m + i; q = p + 1; print 3, p, q, q + t; print 3, p, q + t, p + t
        }
    }'
}
slab 0 >slab0.off
slab 1 >slab1.off
run check slab0.off
expect_status 0
command_line="cleave, sent SIGINT at work"
"$CLEAVE" union slab0.off slab1.off -o out.off --quiet 2>stderr.txt &
job=$!
sleep 0.2
kill -s INT "$job" 2>/dev/null
wait "$job"
status=$?
if [ "$status" -eq 0 ]; then
    expect_file out.off # it was faster
else
    expect_status 130
    expect_no_file out.off
fi
finish
