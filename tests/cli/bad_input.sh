# SPDX-License-Identifier: Apache-2.0
# Every kind of bad input: exit status 1, a message that names what and where, no output and nothing half-written.
source "$(dirname "${BASH_SOURCE[0]}")/../support/cli.sh"

cube 0 0 0 2 >good.off

# expect_refused FILE PART...: as either operand, in info and in check.
expect_refused() {
    local file=$1
    shift
    run union "$file" good.off -o out.off --json
    expect_status 1
    expect_equal "the standard output" "$out" ""
    expect_in "the message" "$err" "cleave: " "$@"
    expect_no_file out.off
    run difference good.off "$file" -o out.stl --quiet
    expect_status 1
    expect_in "the message" "$err" "$@"
    expect_no_file out.stl
    run info "$file"
    expect_status 1
    expect_in "the message" "$err" "$@"
    run check "$file"
    expect_status 1
    expect_in "the message" "$err" "$@"
}

expect_refused missing.off "missing.off" "No such file"
mkdir folder.off
expect_refused folder.off "folder.off" "is a directory"
cp good.off good.xyz
expect_refused good.xyz "good.xyz" "unknown extension" ".off, .obj or .stl"
cp good.off good
expect_refused good "good" "no extension"
: >empty.off
expect_refused empty.off "empty.off" "is empty"

sed '$d' good.off | sed '2s/6/5/' >open.off
expect_refused open.off "open.off" "4 open edges" "from point" "line" "add the missing face"
awk 'NR > 10 { print $1, $5, $4, $3, $2; next } { print }' good.off >inside_out.off
expect_refused inside_out.off "inside_out.off" "inside out" "reverse"
awk 'NR == 11 { print $1, $5, $4, $3, $2; next } { print }' good.off >mixed.off
expect_refused mixed.off "mixed.off" "edges whose two faces run the same way" "face" "reverse one of the faces"
sed '5s/.*/nan 0 0/' good.off >nan.off
expect_refused nan.off "nan.off:5" "nan" "vertex 2"
sed '5s/.*/1e999 0 0/' good.off >huge.off
expect_refused huge.off "huge.off:5" "1e999"
sed '5s/.*/zero 0 0/' good.off >word.off
expect_refused word.off "word.off:5" "zero"
sed '12s/.*/4 4 5 7 60/' good.off >index.off
expect_refused index.off "index.off:12" "60" "face 1"
head -c 90 good.off >truncated.off
expect_refused truncated.off "truncated.off:" "the end of the"
sed '2s/.*/800000000 6 0/' good.off >count.off
expect_refused count.off "count.off:11" "vertex 8"
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >sheet.off
expect_refused sheet.off "sheet.off" "3 open edges"
printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n' >flat.off
expect_refused flat.off "flat.off" "encloses no volume"
head -c 100 /dev/zero >zeros.stl
expect_refused zeros.stl "zeros.stl" "STL"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >index.obj
expect_refused index.obj "index.obj:4" "9"
cat good.off <(echo rubbish) >rubbish.off
expect_refused rubbish.off "rubbish.off:17" "rubbish"
if [ "$(id -u)" -ne 0 ]; then
    cp good.off secret.off
    chmod 000 secret.off
    expect_refused secret.off "secret.off" "Permission denied"
fi

# What only --strict refuses; without it, it is dealt with and reported.
awk 'NR == 2 { print 9, 7, 0; next } NR == 11 { print "1 0 0"; print; next } { print } END { print "3 0 8 1" }' \
    good.off >zero_area.off
sed '10s/.*/2 2 2.5/' good.off >bent.off
for file in zero_area bent; do
    words="1 face without area was left out"
    [ "$file" != bent ] || words="1 face that is not flat was split into triangles"
    run union "$file.off" good.off -o out.off
    expect_status 0
    expect_in "the note" "$err" "note: $file.off: " "$words"
    expect_file out.off
    rm out.off
    run union "$file.off" good.off -o out.off --quiet
    expect_status 0
    expect_equal "the error stream" "$err" ""
    rm out.off
    run check "$file.off"
    expect_status 0
    run union "$file.off" good.off -o out.off --strict
    expect_status 1
    expect_in "the message" "$err" "$file.off" "face" "strict"
    expect_no_file out.off
    run info "$file.off" --strict
    expect_status 1
    run check "$file.off" --strict --json
    expect_status 1
    expect_in "the line" "$out" '"valid":false' '"message":"'"$file.off"
done
run check zero_area.off --json
expect_in "the line" "$out" '"valid":true,"closed":true' '"zero_area_faces":1'
run check open.off --json
expect_status 1
expect_in "the line" "$out" '"vertices":8,"faces":5,"valid":false,"closed":false' '"open_edges":4'
run check inside_out.off --json
expect_in "the line" "$out" '"valid":false,"closed":true' 'inside out'

# Outputs that cannot be.
run union good.off good.off -o out.ply
expect_status 1
expect_in "the message" "$err" "out.ply" "unknown extension"
expect_no_file out.ply
# ... which is said before anything is read.
run union missing.off good.off -o out.ply
expect_in "the message" "$err" "out.ply"
run union good.off good.off -o no/such/folder/out.off
expect_status 1
expect_in "the message" "$err" "no/such/folder/out.off" "No such file or directory"
run union good.off good.off -o folder.off
expect_status 1
expect_in "the message" "$err" "folder.off" "is a directory"
if [ "$(id -u)" -ne 0 ]; then
    mkdir locked
    chmod 555 locked
    run union good.off good.off -o locked/out.off
    expect_status 1
    expect_in "the message" "$err" "locked/out.off" "Permission denied"
fi
# An older file of that name survives.
cp good.off old.off
run union good.off open.off -o old.off
expect_status 1
cmp -s good.off old.off || fail "an older output was changed by a run that failed"
finish
