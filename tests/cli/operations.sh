# SPDX-License-Identifier: Apache-2.0
# Each subcommand on cubes whose results are known, its line of JSON to the letter (all but the times).
source "$(dirname "${BASH_SOURCE[0]}")/../support/cli.sh"

cube 0 0 0 2 >a.off
cube 1 1 1 2 >b.off
cube 2 0 0 2 >t.off
cube 0.5 0.5 0.5 1 >inner.off

digits_40() { # 40 significant digits of an integer
    local zeros=0000000000000000000000000000000000000000
    printf '%s.%s' "$1" "${zeros:0:$((40 - ${#1}))}"
}

operand() { # FILE VOLUME
    printf '{"file":"%s","vertices":8,"faces":6,"volume":"%s","volume_40":"%s","volume_mod":"%s"}' \
        "$1" "$2" "$(digits_40 "$2")" "$2"
}

seconds_pattern='"seconds":\{"read":[0-9.e-]+,"prepare":[0-9.e-]+,"operate":[0-9.e-]+,"export":[0-9.e-]+,"write":[0-9.e-]+\}\}$'

# expect_result NAME OPERANDS VERTICES FACES VOLUME COMPONENTS [ENGINE]
expect_result() {
    expect_status 0
    local digits
    digits=$(digits_40 "$5")
    [ "$5" != 0 ] || digits=0
    expect_equal "the line" "$(printf '%s' "$out" | sed -E 's/"seconds".*//; s/"threads":[0-9]+/"threads":N/')" \
        '{"op":"'"$1"'","engine":"'"${7:-localised}"'","threads":N,"operands":['"$2"'],"result":{"vertices":'"$3"',"faces":'"$4"',"volume":"'"$5"'","volume_40":"'"$digits"'","volume_mod":"'"$5"'","closed":true,"components":'"$6"'},'
    [[ "$out" =~ $seconds_pattern ]] || fail "$command_line: no times in $out"
    expect_equal "the number of lines" "$(wc -l <stdout.txt | tr -d ' ')" 1
    expect_equal "the error stream" "$err" ""
    expect_file out.off
    expect_equal "the counts in the file" "$(sed -n 2p out.off)" "$3 $4 0"
    rm out.off
}

ab="$(operand a.off 8),$(operand b.off 8)"
run union a.off b.off -o out.off --json
expect_result union "$ab" 20 36 15 1
run intersection a.off b.off -o out.off --json
expect_result intersection "$ab" 8 12 1 1
run difference a.off b.off -o out.off --json
expect_result difference "$ab" 14 24 7 1
run symmetric-difference a.off b.off -o out.off --json
expect_result symmetric-difference "$ab" 22 48 14 2
run xor a.off b.off -o out.off --json
expect_result symmetric-difference "$ab" 22 48 14 2
run xor a.off b.off --engine boundary-filter --output out.off --json
expect_result symmetric-difference "$ab" 22 48 14 2 boundary-filter
run xor a.off b.off --engine localised --output out.off --json
expect_result symmetric-difference "$ab" 22 48 14 2 localised
run xor a.off b.off --engine tree-merge --output out.off --json
expect_result symmetric-difference "$ab" 22 48 14 2 tree-merge
run union -o out.off --json a.off b.off --engine automatic
expect_result union "$ab" 20 36 15 1

# Coincident faces, touching, nothing left.
aa="$(operand a.off 8),$(operand a.off 8)"
run difference a.off a.off -o out.off --json
expect_result difference "$aa" 0 0 0 0
run union a.off a.off -o out.off --json
expect_result union "$aa" 8 12 8 1
run union a.off t.off -o out.off --json
expect_result union "$(operand a.off 8),$(operand t.off 8)" 12 20 16 1
run intersection a.off t.off -o out.off --json
expect_result intersection "$(operand a.off 8),$(operand t.off 8)" 0 0 0 0
# A cavity: two surfaces, one component.
run difference a.off inner.off -o out.off --json
expect_result difference "$(operand a.off 8),$(operand inner.off 1)" 16 24 7 1

# Three operands: A minus all others; parity.
abt="$(operand a.off 8),$(operand b.off 8),$(operand t.off 8)"
run difference a.off b.off t.off -o out.off --json
expect_in "the line" "$out" '"volume":"7"'
run xor a.off b.off a.off -o out.off --json
expect_in "the line" "$out" '"volume":"8"' '"components":1'
run xor a.off b.off t.off -o out.off --json
expect_in "the line" "$out" "\"operands\":[$abt]" '"volume":"20"'
run intersection a.off b.off t.off -o out.off --json
expect_in "the line" "$out" '"volume":"0"' '"volume_40":"0"' '"components":0'

# More operands than one function takes: 150 cubes in a row, each sharing half with the next.
many=()
for i in $(seq 0 149); do
    cube "$i" 0 0 2 >"row$i.off"
    many+=("row$i.off")
done
run union "${many[@]}" -o out.off --json
expect_in "the line" "$out" '"volume":"604"' '"closed":true,"components":1'
run xor "${many[@]}" -o out.off --json
expect_in "the line" "$out" '"volume":"8"' '"components":2'
run intersection "${many[@]}" -o out.off --json
expect_in "the line" "$out" '"volume":"0"'
run difference "${many[@]}" -o out.off --json
expect_in "the line" "$out" '"volume":"4"'

# In and out in every format; the text says what the line says.
for extension in off obj stl OFF; do
    run union a.off b.off -o "u.$extension"
    expect_status 0
    expect_in "the text" "$out" "union of 2 operands" "20 vertices, 36 faces, volume 15, closed, 1 component" "seconds: read"
    run info "u.$extension" --json
    expect_status 0
    expect_equal "the line" "$out" \
        '[{"file":"u.'"$extension"'","vertices":20,"faces":36,"volume":"15","volume_40":"15.00000000000000000000000000000000000000","volume_mod":"15"}]'
    run difference "u.$extension" b.off -o d.off --json
    expect_in "the line" "$out" '"volume":"7"'
    run check "u.$extension"
    expect_status 0
    expect_equal "the text" "$out" "u.$extension: 20 vertices, 36 faces, bounds a solid"
done
run info a.off b.off
expect_status 0
expect_equal "the text" "$out" "a.off  8 vertices, 6 faces, volume 8
b.off  8 vertices, 6 faces, volume 8"

# An operand may be the output.
cp a.off same.off
run union same.off b.off -o same.off --json
expect_status 0
expect_in "the line" "$out" '"file":"same.off","vertices":8' '"volume":"15"'
run info same.off --json
expect_in "the line" "$out" '"faces":36,"volume":"15"'

# A volume that is no integer: doubles are the rationals they are, decimals are not asked to be.
cube 0 0 0 0.1 >tenth.off
run info tenth.off --json
expect_in "the line" "$out" '"volume":"46768052394588901170963202449162931770298562773/46768052394588893382517914646921056628989841375232"' \
    '"volume_40":"0.001000000000000000166533453693773490308008"'
finish
