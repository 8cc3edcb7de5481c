# SPDX-License-Identifier: Apache-2.0
# --threads: the same files and the same lines, whatever the number; the line says the number.
source "$(dirname "${BASH_SOURCE[0]}")/../support/cli.sh"

# A sphere of 2 n (n - 1) triangles about a point: large enough to be shared among threads.
sphere() { # N X Y Z
    awk -v n="$1" -v x="$2" -v y="$3" -v z="$4" 'BEGIN {
        pi = 3.14159265358979
        print "OFF"
        print (n - 1) * n + 2, 2 * n * (n - 1), 0
        printf "%.17g %.17g %.17g\n", x, y, z + 1
        for (i = 1; i < n; ++i)
            for (j = 0; j < n; ++j) {
                r = sin(pi * i / n)
                printf "%.17g %.17g %.17g\n", x + r * cos(2 * pi * j / n), y + r * sin(2 * pi * j / n), z + cos(pi * i / n)
            }
        printf "%.17g %.17g %.17g\n", x, y, z - 1
        for (j = 0; j < n; ++j) {
            k = (j + 1) % n
            print 3, 0, 1 + j, 1 + k
            for (i = 0; i + 2 < n; ++i) {
                print 3, 1 + i * n + j, 1 + (i + 1) * n + j, 1 + (i + 1) * n + k
                print 3, 1 + i * n + j, 1 + (i + 1) * n + k, 1 + i * n + k
            }
            print 3, 1 + (n - 2) * n + j, 1 + (n - 1) * n, 1 + (n - 2) * n + k
        }
    }'
}

sphere 54 0 0 0 >a.off
sphere 54 0.51 0.23 0.31 >b.off
sphere 12 0.25 0.5 0 >small.off
cube -0.5 -0.5 -0.5 1 >c.off

# what the line says, without the number of threads and the times
line() {
    printf '%s' "$out" | sed -E 's/"seconds".*//; s/"threads":[0-9]+//; s/out[0-9]+\.//'
}

# same COMMAND...: three runs, by 1, 2 and 5 threads, that write the same
same() {
    local threads first=
    for threads in 1 2 5; do
        run "$@" -o "out$threads.off" --json --threads "$threads"
        expect_status 0
        expect_in "the line" "$out" "\"threads\":$threads,"
        expect_file "out$threads.off"
        [ "$threads" -ne 1 ] || first=$(line)
        expect_equal "the line by $threads threads" "$(line)" "$first"
        cmp -s out1.off "out$threads.off" || fail "$command_line: another file than by one thread"
    done
    rm -f out?.off
}

same union a.off b.off
same difference a.off c.off
same eval '(x - z) ^ y' x=a.off y=b.off z=c.off
same xor small.off c.off --rational
same union small.off c.off --engine boundary-filter
same resolve small.off

for threads in 1 2 5; do
    run check a.off --threads "$threads"
    expect_status 0
    expect_in "the text" "$out" "5724 faces, bounds a solid"
    run info a.off c.off --threads "$threads"
    expect_status 0
    expect_in "the text" "$out" "8 vertices, 6 faces, volume 1"
done
run union a.off b.off -o out.off --json
expect_status 0
expect_in "the line" "$out" '"threads":'
finish
