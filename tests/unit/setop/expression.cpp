// SPDX-License-Identifier: Apache-2.0
#include <cleave/setop/expression.hpp>
//
#include <cleave/query/measure.hpp>
#include <cleave/setop/compare.hpp>
#include <cleave/setop/engines.hpp>
#include <cleave/setop/expression_text.hpp>
#include <cleave/setop/operators.hpp>
#include <cleave/shape/box.hpp>

#include "support/catch.hpp"
#include "support/convex_regions.hpp"

#include <map>
#include <string>
#include <vector>

using namespace cleave;
using namespace support;

namespace {

template <int D>
std::vector<Region<D>> random_regions(Dice& dice, std::size_t n) {
    std::vector<Region<D>> regions;
    for (std::size_t i = 0; i < n; ++i)
        regions.push_back(region_of<D>(random_convex<D>(dice, dice.below(3) != 0).planes));
    return regions;
}

/// A random expression and its value by single operations.
template <int D>
std::pair<Expression<D>, Region<D>> random_expression(Dice& dice, const std::vector<Region<D>>& regions, int depth) {
    if (depth == 0 || dice.below(6) == 0) {
        const Region<D>& r = regions[std::size_t(dice.below(int(regions.size())))];
        return {Expression<D>(r), r};
    }
    auto a = random_expression<D>(dice, regions, depth - 1);
    auto b = random_expression<D>(dice, regions, depth - 1);
    switch (dice.below(6)) {
        case 0:
            return {a.first | b.first, a.second | b.second};
        case 1:
            return {a.first & b.first, a.second & b.second};
        case 2:
            return {a.first - b.first, a.second - b.second};
        case 3:
            return {a.first ^ b.first, a.second ^ b.second};
        case 4:
            return {~a.first, ~a.second};
        default: {
            auto c = random_expression<D>(dice, regions, 0);
            const std::vector<Expression<D>> parts{a.first, b.first, c.first};
            return {Expression<D>::at_least(2, parts),
                    (a.second & b.second) | (a.second & c.second) | (b.second & c.second)};
        }
    }
}

/// What an expression is read as: fully bracketed.
struct Text {
    std::string text;
    friend Text operator|(const Text& a, const Text& b) { return {"(" + a.text + "|" + b.text + ")"}; }
    friend Text operator&(const Text& a, const Text& b) { return {"(" + a.text + "&" + b.text + ")"}; }
    friend Text operator-(const Text& a, const Text& b) { return {"(" + a.text + "-" + b.text + ")"}; }
    friend Text operator^(const Text& a, const Text& b) { return {"(" + a.text + "^" + b.text + ")"}; }
    friend Text operator~(const Text& a) { return {"~" + a.text}; }
};

std::string read(const std::string& text) {
    return parse_expression(text, [](std::string_view name) { return Text{std::string(name)}; }).text;
}

}  // namespace

TEST_CASE("expression: nothing is done until it is evaluated; then all of it at once") {
    const Region<2> a = box<2>({0, 0}, {4, 4});
    const Region<2> b = box<2>({1, 1}, {2, 2});
    const Region<2> c = box<2>({2, 2}, {3, 5});
    const Expression<2> e = Expression<2>(a) - (Expression<2>(b) | c);
    CHECK(e.operands().size() == 3);
    int calls = 0;
    const Region<2> value = e.value([&](const BooleanFunction& f, std::span<const Region<2>> operands) {
        ++calls;
        CHECK(f.arity() == 3);
        CHECK(operands.size() == 3);
        return evaluate<2, Rational>(f, operands);
    });
    CHECK(calls == 1);
    CHECK(equal(value, a - (b | c)));
    CHECK(measure(evaluate(e)) == Rational(16 - 1 - 2));
    for (const Engine engine : all_engines) CHECK(equal(evaluate(engine, e), value));
    CHECK(evaluate(Expression<2>(a)).shared_boundary() == a.shared_boundary());
    CHECK(evaluate(Expression<2>(a) ^ a).is_empty());
    CHECK(equal(evaluate(~~Expression<2>(a)), a));
    Expression<2> running(a);
    running |= c;
    running &= b;
    running ^= c;
    running -= a;
    CHECK(equal(evaluate(running), (((a | c) & b) ^ c) - a));
    CHECK(running.operands().size() == 3);
}

TEST_CASE("expression: covered at least m times") {
    std::vector<Expression<1>> parts;
    for (int i = 0; i < 5; ++i) parts.emplace_back(box<1>({i}, {i + 3}));  // [0, 3], [1, 4], ..., [4, 7]
    CHECK(evaluate(Expression<1>::at_least(0, parts)).is_full());
    CHECK(equal(evaluate(Expression<1>::at_least(1, parts)), box<1>({0}, {7})));
    CHECK(equal(evaluate(Expression<1>::at_least(2, parts)), box<1>({1}, {6})));
    CHECK(equal(evaluate(Expression<1>::at_least(3, parts)), box<1>({2}, {5})));
    CHECK(evaluate(Expression<1>::at_least(4, parts)).is_empty());
    CHECK(evaluate(Expression<1>::at_least(6, parts)).is_empty());
    // A part that occurs twice counts twice, and parts may be expressions.
    const std::vector<Expression<1>> twice{parts[0], parts[0], parts[1] | parts[4]};
    CHECK(equal(evaluate(Expression<1>::at_least(2, twice)), box<1>({0}, {3})));
    CHECK(equal(evaluate(Expression<1>::at_least(3, twice)), box<1>({1}, {3})));
}

TEST_CASE("expression: random ones have the value of their operators") {
    for (unsigned seed = 0; seed < scaled(40); ++seed) {
        INFO("seed " << seed);
        Dice dice(seed);
        const std::vector<Region<2>> flat = random_regions<2>(dice, 4);
        const auto [e, value] = random_expression<2>(dice, flat, 4);
        CHECK(equal(evaluate(e), value));
        const std::vector<Region<3>> solid = random_regions<3>(dice, 3);
        const auto [f, solid_value] = random_expression<3>(dice, solid, 2);
        CHECK(equal(evaluate(f), solid_value));
        CHECK(equal(evaluate(Engine::tree_merge, f), solid_value));
    }
}

TEST_CASE("expression: more operands than a function takes") {
    const int n = 200;
    std::vector<Expression<1>> parts;
    Expression<1> sum(box<1>({0}, {1}));
    Expression<1> odd(box<1>({0}, {1}));
    Expression<1> common(box<1>({-1000}, {1000}));
    Expression<1> rest(box<1>({-1000}, {1000}));
    for (int i = 0; i < n; ++i) {
        const Region<1> r = box<1>({2 * i}, {2 * i + 3});  // neighbours share one unit
        parts.emplace_back(r);
        sum |= r;
        odd ^= r;
        rest -= r;
        common &= box<1>({-1000 + i}, {1000 - i});
    }
    CHECK(sum.operands().size() == std::size_t(n) + 1);
    int calls = 0;
    const Region<1> all = sum.value([&](const BooleanFunction& f, std::span<const Region<1>> operands) {
        ++calls;
        return evaluate<1, Rational>(f, operands);
    });
    CHECK(calls == n);  // two by two
    CHECK(equal(all, box<1>({0}, {2 * n + 1})));
    // Units [0, 1], [2, 3], [4, 5], ... are covered twice, all others once, the last one among them.
    CHECK(measure(evaluate(odd)) == Rational(n + 1));
    CHECK(equal(evaluate(rest), box<1>({-1000}, {1000}) - all));
    CHECK(equal(evaluate(common), box<1>({-1000 + n - 1}, {1000 - n + 1})));
    CHECK(measure(evaluate(Expression<1>::at_least(2, parts))) == Rational(n - 1));
}

TEST_CASE("expression text: precedences are those of C++") {
    CHECK(read("a") == "a");
    CHECK(read(" a-b | c ") == "((a-b)|c)");
    CHECK(read("a|b&c") == "(a|(b&c))");
    CHECK(read("a - b - c") == "((a-b)-c)");
    CHECK(read("a & b - c") == "(a&(b-c))");
    CHECK(read("a ^ b | c ^ d & e") == "((a^b)|(c^(d&e)))");
    CHECK(read("~a - ~~b") == "(~a-~~b)");
    CHECK(read("~(a|b)&c") == "(~(a|b)&c)");
    CHECK(read("((part_1))-_drill2") == "(part_1-_drill2)");
    CHECK(read("a\n|\tb") == "(a|b)");
}

TEST_CASE("expression text: what is no expression is refused with its place") {
    const std::map<std::string, std::pair<std::size_t, std::string>> wrong{
        {"", {0, "at character 1 of the expression: it ends where a name is expected"}},
        {"a -", {3, "at character 4 of the expression: it ends where a name is expected"}},
        {"a b", {2, "at character 3 of the expression: an operator | & - ^ is missing before 'b'"}},
        {"(a | b", {0, "at character 1 of the expression: this '(' is never closed"}},
        {"a | b)", {5, "at character 6 of the expression: there is no '(' to this ')'"}},
        {"a || b", {3, "at character 4 of the expression: a name is expected, not '| b'"}},
        {"2a", {0, "at character 1 of the expression: a name is expected, not '2a'"}},
        {"a + b", {2, "at character 3 of the expression: an operator | & - ^ is missing before '+ b'"}},
        {"()", {1, "at character 2 of the expression: a name is expected, not ')'"}},
    };
    for (const auto& [text, expected] : wrong) {
        INFO(text);
        try {
            static_cast<void>(read(text));
            CHECK(false);
        } catch (const ExpressionError& error) {
            CHECK(error.position() == expected.first);
            CHECK(error.what() == expected.second);
        }
    }
    CHECK_THROWS_AS(read(std::string(100000, '(')), ExpressionError);
    CHECK_THROWS_AS(read(std::string(100000, '~') + "a"), ExpressionError);
    CHECK(read(std::string(150, '(') + "a" + std::string(150, ')')) == "a");
    CHECK(is_expression_name("a1_"));
    CHECK(!is_expression_name("1a"));
    CHECK(!is_expression_name(""));
    CHECK(!is_expression_name("a-b"));
}
