# SPDX-License-Identifier: Apache-2.0
# --rational: decimals and fractions in, fractions out, nothing rounded.
source "$(dirname "${BASH_SOURCE[0]}")/../support/cli.sh"

cube 0 0 0 0.1 >tenth.off
run info tenth.off --rational --json
expect_status 0
expect_in "the line" "$out" '"volume":"1/1000","volume_40":"0.001000000000000000000000000000000000000000"'

# x + y + z < 1 cut by x < 1/3, and 1/7: denominators that no double has.
cat >tetrahedron.off <<'END'
OFF
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
END
cat >third.obj <<'OBJ'
v 1/3 -1 -1
v -1 -1 -1
v -1 2 -1
v 1/3 2 -1
v 1/3 -1 2
v -1 -1 2
v -1 2 2
v 1/3 2 2
f 1 2 3 4
f 8 7 6 5
f 1 5 6 2
f 2 6 7 3
f 3 7 8 4
f 4 8 5 1
OBJ
run intersection tetrahedron.off third.obj -o cut.off --rational --json
expect_status 0
expect_in "the line" "$out" '"volume":"12"' '"volume":"1/6"' '"result":{"vertices":6,"faces":8,"volume":"19/162"' \
    '"closed":true,"components":1'
expect_in "the file" "$(cat cut.off)" '1/3 0 0' '1/3 2/3 0' '1/3 0 2/3'

# The output read again is the same set, in both formats; without --rational, fractions are refused with a hint.
run xor cut.off cut.off -o nothing.obj --rational --json
expect_status 0
expect_in "the line" "$out" '"file":"cut.off","vertices":6,"faces":8,"volume":"19/162"' '"volume":"0"'
run union cut.off cut.off -o again.obj --rational
expect_status 0
expect_in "the text" "$out" 'volume 19/162, about 0.11728395061728395'
run info again.obj --rational --json
expect_in "the line" "$out" '"volume":"19/162"'
run info cut.off
expect_status 1
expect_in "the message" "$err" "cut.off:" "1/3" "rationals"

# Doubles beside: the nearest, and the volume of the exact result of the doubles as they are.
run intersection tetrahedron.off tenth.off -o rounded.off --json
expect_status 0
expect_in "the file" "$(cat rounded.off)" '0.1'
finish
