# SPDX-License-Identifier: Apache-2.0
# Meshes whose faces cross: resolved by each rule, found by --check-crossings, and refused where they are no surfaces.
source "$(dirname "${BASH_SOURCE[0]}")/../support/cli.sh"

# both A B: two OFF files of cubes as one mesh.
both() {
    awk 'FNR == 1 { ++file; next }
         FNR == 2 { next }
         FNR <= 10 { points[file] = points[file] $0 "\n"; next }
         { shift_by = file == 1 ? 0 : 8; faces[file] = faces[file] $1; for (i = 2; i <= NF; ++i) faces[file] = faces[file] " " $i + shift_by; faces[file] = faces[file] "\n" }
         END { printf "OFF\n16 12 0\n%s%s%s%s", points[1], points[2], faces[1], faces[2] }' "$1" "$2"
}

cube 0 0 0 2 >a.off
cube 1 1 1 2 >b.off
cube 2 2 2 1 >corner.off
awk 'NR > 10 { print $1, $5, $4, $3, $2; next } { print }' b.off >inverted.off
both a.off b.off >crossing.off
both a.off inverted.off >mixed.off
both a.off a.off >twice.off
both a.off corner.off >touching.off

# expect_volume VOLUME ARGUMENT...: of what the program makes of its arguments, which name no output.
expect_volume() {
    local volume=$1
    shift
    run "$@" -o out.off --json
    expect_status 0
    expect_equal "the error stream" "$err" ""
    expect_in "the line" "$out" '"op":"resolve","rule":' '"operands":[{"file":"'"$2"'","vertices":16,"faces":12}]' \
        '"volume":"'"$volume"'"' '"closed":true'
    expect_file out.off
    rm -f out.off
}

expect_volume 15 resolve crossing.off
expect_volume 15 resolve crossing.off --rule positive
expect_volume 15 resolve crossing.off --rule non-zero
expect_volume 14 resolve crossing.off --rule even-odd
expect_volume 7 resolve mixed.off --rule positive
expect_volume 14 resolve mixed.off --rule non-zero
expect_volume 14 resolve mixed.off --rule even-odd
expect_volume 8 resolve twice.off
expect_volume 0 resolve twice.off --rule even-odd
expect_volume 9 resolve touching.off
expect_volume 15 resolve crossing.off --rational --strict

run resolve crossing.off -o whole.stl --rule non-zero
expect_status 0
expect_in "the report" "$out" "resolve by the non-zero rule" "crossing.off  16 vertices, 12 faces" "whole.stl" \
    "volume 15, closed, 1 component"
run info whole.stl
expect_in "the report" "$out" "volume 15"
run union whole.stl corner.off -o out.off --quiet --check-crossings
expect_status 0
expect_equal "the standard output" "$out" ""
rm out.off

# An outline that crosses itself is dealt with and reported.
printf 'OFF\n8 6 0\n0 0 0\n2 2 0\n2 0 0\n0 2 0\n0 0 1\n2 2 1\n2 0 1\n0 2 1\n4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n' >tie.off
run resolve tie.off -o out.off --rule non-zero
expect_status 0
expect_in "the report" "$out" "volume 2, closed"
expect_in "the note" "$err" "note: tie.off: 2 flat faces whose outlines cross themselves were split into triangles"
rm out.off

# What is no closed surface has no winding numbers.
sed '$d' crossing.off | sed '2s/12/11/' >open.off
run resolve open.off -o out.off
expect_status 1
expect_in "the message" "$err" "cleave: open.off: " "4 open edges"
expect_no_file out.off
run resolve missing.off -o out.off
expect_status 1
expect_in "the message" "$err" "missing.off" "No such file"
expect_no_file out.off

# --check-crossings names the faces, wherever the mesh is read.
for command in "union crossing.off a.off -o out.off" "difference a.off crossing.off -o out.off --json" \
    "eval a|b a=crossing.off b=b.off -o out.off" "info crossing.off" "check crossing.off" "check crossing.off --quiet"; do
    # shellcheck disable=SC2086
    run $command --check-crossings
    expect_status 1
    expect_equal "the standard output" "$out" ""
    expect_in "the message" "$err" "cleave: crossing.off: the mesh intersects itself" "6 pairs of faces cross or overlap" \
        "face 1 (line 20) crosses face 8 (line 27)" "and 3 more" "resolve"
    expect_no_file out.off
done
run check twice.off --check-crossings
expect_status 1
expect_in "the message" "$err" "face 0 (line 19) overlaps face 6 (line 25)"
run check crossing.off --check-crossings --json
expect_status 1
expect_in "the line" "$out" '"valid":false' '"crossings":6' '"message":"crossing.off: '
for file in a touching whole; do
    [ $file = whole ] && suffix=stl || suffix=off
    run check $file.$suffix --check-crossings
    expect_status 0
    expect_in "the report" "$out" "bounds a solid, no faces cross"
done
run check touching.off --check-crossings --json
expect_status 0
expect_in "the line" "$out" '"valid":true' '"crossings":0' '"message":null'
# Nobody is told who did not ask.
run check crossing.off
expect_status 0
run check crossing.off --json
expect_in "the line" "$out" '"valid":true'
case "$out" in *crossings\"*) fail "$command_line: told about crossings" ;; esac

expect_usage_error "resolve takes one file, found 2" resolve a.off b.off -o out.off
expect_usage_error "resolve takes one file, found 0" resolve -o out.off
expect_usage_error "the name of the output is missing" resolve a.off
expect_usage_error "--rule" resolve a.off -o out.off --rule odd
expect_usage_error "STL cannot hold the fractions" resolve a.off -o out.stl --rational
expect_usage_error "--check-crossings" resolve a.off -o out.off --check-crossings
finish
