# SPDX-License-Identifier: Apache-2.0
# Expressions on the command line: values, and what makes no sense.
source "$(dirname "${BASH_SOURCE[0]}")/../support/cli.sh"

cube 0 0 0 2 >a.off
cube 1 1 1 2 >b.off
cube 0 0 0 1 >c.off

value() { # VOLUME EXPRESSION NAME=FILE...
    local volume=$1
    shift
    rm -f out.off
    run eval "$@" -o out.off --json
    expect_status 0
    expect_in "the line for $1" "$out" '"op":"eval","expression":"'"$1"'"' '"volume":"'"$volume"'"' '"closed":true'
    expect_file out.off
}

value 15 'a | b' a=a.off b=b.off
value 1 'a & b' a=a.off b=b.off
value 14 'a^b' a=a.off b=b.off
value 6 '(a - b) - c' a=a.off b=b.off c=c.off
value 6 'a - (b | c)' a=a.off b=b.off c=c.off
value 8 'part' part=a.off
value 7 'x & ~y' x=a.off y=b.off
# The same file under two names is two operands.
value 8 'x & y' x=a.off y=a.off
value 0 'x ^ y' x=a.off y=a.off
for engine in automatic localised boundary-filter tree-merge; do
    run eval 'a - (b | c)' a=a.off b=b.off c=c.off -o out.off --json --engine "$engine"
    expect_status 0
    expect_in "the line" "$out" '"volume":"6"'
done
run eval 'a - (b | c)' a=a.off b=b.off c=c.off -o out.off
expect_status 0
expect_in "the text" "$out" "a - (b | c) of 3 operands" "volume 6" "closed"

# What has no bounds has no mesh.
rm -f out.off
run eval '~a' a=a.off -o out.off
expect_status 1
expect_in "the message" "$err" "unbounded"
expect_no_file out.off

expect_usage_error "at character 4 of the expression" eval 'a -' a=a.off -o out.off
expect_usage_error "never closed" eval '(a' a=a.off -o out.off
expect_usage_error "the expression names 'b', which is no operand: add b=FILE" eval 'a | b' a=a.off -o out.off
expect_usage_error "the operand 'b' is not in the expression" eval 'a' a=a.off b=b.off -o out.off
expect_usage_error "'b.off' is not NAME=FILE" eval 'a' a=a.off b.off -o out.off
expect_usage_error "'=b.off' is not NAME=FILE" eval 'a' a=a.off =b.off -o out.off
expect_usage_error "'2=b.off' is not NAME=FILE" eval 'a' a=a.off 2=b.off -o out.off
expect_usage_error "given twice" eval 'a' a=a.off a=b.off -o out.off
expect_usage_error "NAME=FILE for each" eval 'a' -o out.off
expect_usage_error "-o OUT" eval 'a' a=a.off
run eval 'a | b' a=a.off b=missing.off -o out.off
expect_status 1
expect_in "the message" "$err" "missing.off"
expect_no_file out.off
finish
