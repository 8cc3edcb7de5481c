// SPDX-License-Identifier: Apache-2.0
#include <cleave/base/boolean_function.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"
#include "support/property.hpp"

#include <bit>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

using support::property;

using cleave::BooleanFunction;
using cleave::Operation;
using Bits = BooleanFunction::Bits;

namespace {

/// The value of an operation on k operands, by its definition.
bool by_definition(Operation operation, unsigned k, Bits bits) {
    const Bits mask = k == 64 ? ~Bits(0) : (Bits(1) << k) - 1;
    const Bits others = bits & mask & ~Bits(1);
    switch (operation) {
        case Operation::union_:
            return (bits & mask) != 0;
        case Operation::intersection:
            return (bits & mask) == mask;
        case Operation::difference:
            return (bits & 1) != 0 && others == 0;
        case Operation::symmetric_difference:
            return std::popcount(bits & mask) % 2 == 1;
    }
    return false;
}

/// The same function through another path: over 7 operands there is no truth table.
BooleanFunction some_expression(unsigned arity) {
    const auto x = [arity](unsigned i) { return BooleanFunction::operand(i, arity); };
    return (x(0) - x(1)) | (x(2) & ~(x(3) ^ x(4)));
}

/// A function and the same by its definition, for points of 64 bits.
struct Known {
    BooleanFunction function;
    std::function<bool(Bits)> plain;
};

/// A count, a parity, a constant or an operand.
Known draw_leaf(support::Dice& dice, unsigned arity) {
    const Bits all = arity == 64 ? ~Bits(0) : (Bits(1) << arity) - 1;
    const unsigned m = unsigned(dice.below(int(arity) + 2));
    const unsigned i = unsigned(dice.below(int(arity)));
    switch (dice.below(12)) {
        case 0:
            return {BooleanFunction::at_least(m, arity), [=](Bits b) { return unsigned(std::popcount(b & all)) >= m; }};
        case 1:
            return {BooleanFunction::symmetric_difference(arity),
                    [=](Bits b) { return std::popcount(b & all) % 2 != 0; }};
        case 2:
            return {BooleanFunction::union_(arity), [=](Bits b) { return (b & all) != 0; }};
        case 3:
            return {BooleanFunction::intersection(arity), [=](Bits b) { return (b & all) == all; }};
        case 4:
            return {BooleanFunction::constant(m % 2 != 0, arity), [=](Bits) { return m % 2 != 0; }};
        default:
            return {BooleanFunction::operand(i, arity), [=](Bits b) { return (b >> i & 1U) != 0; }};
    }
}

Known joined(int how, const Known& f, const Known& g) {
    switch (how) {
        case 0:
            return {f.function | g.function, [=](Bits b) { return f.plain(b) || g.plain(b); }};
        case 1:
            return {f.function & g.function, [=](Bits b) { return f.plain(b) && g.plain(b); }};
        case 2:
            return {f.function - g.function, [=](Bits b) { return f.plain(b) && !g.plain(b); }};
        default:
            return {f.function ^ g.function, [=](Bits b) { return f.plain(b) != g.plain(b); }};
    }
}

/// An expression of so many leaves. `kinds`: how many of the four operations occur. `lean`: which part is a leaf, 0 the
/// second, 1 the first, 2 neither in particular.
Known draw_expression(support::Dice& dice, unsigned arity, int leaves, int kinds, int lean) {
    if (leaves == 1) {
        Known f = draw_leaf(dice, arity);
        if (dice.below(4) != 0) return f;
        return {~f.function, [plain = f.plain](Bits b) { return !plain(b); }};
    }
    const int first = lean == 0 ? leaves - 1 : lean == 1 ? 1 : dice.between(1, leaves - 1);
    const Known f = draw_expression(dice, arity, first, kinds, lean);
    const Known g = draw_expression(dice, arity, leaves - first, kinds, lean);
    return joined(kinds == 1 ? dice.below(100) == 0 ? 1 : 0 : dice.below(kinds), f, g);
}

void check_points(support::Dice& dice, const Known& known, int count) {
    const auto word = [&] {
        Bits b = 0;
        for (int n = 0; n < 8; ++n) b = b << 8U | Bits(dice.below(256));
        return b;
    };
    for (int n = 0; n < count; ++n) {
        Bits b = word();
        for (int k = dice.below(6); k > 0; --k) b &= word();  // few bits, or
        if (dice.below(2) == 0) b = ~b;                       // many
        if (dice.below(10) == 0) b = 0;
        REQUIRE(known.function(b) == known.plain(b));
        REQUIRE(known.function.value_if_known(b, ~Bits(0)) == known.plain(b));
    }
}

}  // namespace

TEST_CASE("boolean_function: the four operations on two operands are their truth tables") {
    for (const Operation operation : cleave::all_operations) {
        const BooleanFunction f = BooleanFunction::from(operation, 2);
        for (unsigned bits = 0; bits < 4; ++bits) {
            const bool a = (bits & 1) != 0;
            const bool b = (bits & 2) != 0;
            CHECK(f(bits) == cleave::apply(operation, a, b));
        }
    }
}

TEST_CASE("boolean_function: the operations on one to nine operands agree with their definitions") {
    for (const Operation operation : cleave::all_operations) {
        for (unsigned k = 1; k <= 9; ++k) {
            const BooleanFunction f = BooleanFunction::from(operation, k);
            REQUIRE(f.arity() == k);
            for (Bits bits = 0; bits < (Bits(1) << k); ++bits) {
                REQUIRE(f(bits) == by_definition(operation, k, bits));
            }
        }
    }
}

TEST_CASE("boolean_function: 64 operands are all used") {
    const Bits all = ~Bits(0);
    const BooleanFunction both = BooleanFunction::intersection(64);
    const BooleanFunction any = BooleanFunction::union_(64);
    const BooleanFunction parity = BooleanFunction::symmetric_difference(64);
    CHECK(both(all));
    CHECK_FALSE(parity(all));
    CHECK_FALSE(any(0));
    for (unsigned i = 0; i < 64; ++i) {
        const Bits bit = Bits(1) << i;
        CHECK(any(bit));
        CHECK_FALSE(both(all ^ bit));
        CHECK(parity(bit));
        CHECK(BooleanFunction::operand(i, 64)(bit));
        CHECK_FALSE(BooleanFunction::operand(i, 64)(all ^ bit));
    }
}

TEST_CASE("boolean_function: at_least counts operands") {
    for (unsigned k = 1; k <= 8; ++k) {
        for (unsigned m = 0; m <= k + 1; ++m) {
            const BooleanFunction f = BooleanFunction::at_least(m, k);
            for (Bits bits = 0; bits < (Bits(1) << k); ++bits) {
                REQUIRE(f(bits) == (static_cast<unsigned>(std::popcount(bits)) >= m));
            }
        }
    }
}

TEST_CASE("boolean_function: an expression has the same values with and without a truth table") {
    const BooleanFunction small = some_expression(5);
    const BooleanFunction large = some_expression(7);
    for (Bits bits = 0; bits < 32; ++bits) {
        const auto x = [bits](unsigned i) { return ((bits >> i) & 1) != 0; };
        const bool expected = (x(0) && !x(1)) || (x(2) && x(3) == x(4));
        CHECK(small(bits) == expected);
        CHECK(large(bits) == expected);
        CHECK(large(bits | 96) == expected);
        CHECK((~small)(bits) == !expected);
        CHECK((~large)(bits) == !expected);
    }
}

TEST_CASE("boolean_function: bits beyond the arity are ignored") {
    CHECK_FALSE(BooleanFunction::union_(2)(Bits(4) | (Bits(1) << 63)));
    CHECK_FALSE(BooleanFunction::union_(7)(Bits(1) << 63));
    CHECK(BooleanFunction::intersection(2)(~Bits(0)));
}

TEST_CASE("boolean_function: the boundary rule sees operand i exactly where its bit changes the value") {
    const BooleanFunction f = BooleanFunction::difference(3);
    const auto emitted = [&f](Bits others, unsigned i) { return f(others) != f(others | (Bits(1) << i)); };
    CHECK(emitted(0, 0));
    CHECK_FALSE(emitted(2, 0));
    CHECK(emitted(1, 1));
    CHECK_FALSE(emitted(0, 1));
    CHECK_FALSE(emitted(1 | 4, 1));
}

TEST_CASE("boolean_function: a value is known exactly where no unknown bit can change it, up to six operands") {
    std::vector<BooleanFunction> functions = {some_expression(5), BooleanFunction::at_least(2, 5),
                                              BooleanFunction::difference(5), BooleanFunction::constant(true, 5)};
    const BooleanFunction x = BooleanFunction::operand(0, 5);
    functions.push_back(x | ~x);
    for (const BooleanFunction& f : functions) {
        for (Bits known = 0; known < 32; ++known) {
            for (Bits bits = 0; bits < 32; ++bits) {
                bool seen[2] = {false, false};
                for (Bits other = 0; other < 32; ++other) seen[f((bits & known) | (other & ~known)) ? 1 : 0] = true;
                const std::optional<bool> expected = seen[0] && seen[1] ? std::nullopt : std::optional<bool>(seen[1]);
                REQUIRE(f.value_if_known(bits, known) == expected);
            }
        }
    }
}

TEST_CASE("boolean_function: beyond six operands a known value is right, and read-once expressions miss none") {
    const std::vector<BooleanFunction> functions = {some_expression(7), BooleanFunction::at_least(3, 7),
                                                    BooleanFunction::difference(7),
                                                    BooleanFunction::symmetric_difference(7)};
    for (const BooleanFunction& f : functions) {
        for (Bits known = 0; known < 128; ++known) {
            for (Bits bits = 0; bits < 128; bits += 3) {
                bool seen[2] = {false, false};
                const Bits unknown = ~known & 127;
                for (Bits choice = unknown;; choice = (choice - 1) & unknown) {
                    seen[f((bits & known) | choice) ? 1 : 0] = true;
                    if (choice == 0) break;
                }
                const std::optional<bool> expected = seen[0] && seen[1] ? std::nullopt : std::optional<bool>(seen[1]);
                REQUIRE(f.value_if_known(bits, known) == expected);
            }
        }
    }
}

TEST_CASE("boolean_function: operators are the Boolean algebra, for random expressions of nine operands") {
    property("De Morgan, and difference is intersection with the complement", [](Bits a, Bits b, Bits point) {
        const auto member = [](Bits set) {
            BooleanFunction f = BooleanFunction::constant(false, 9);
            for (unsigned i = 0; i < 9; ++i) {
                if (((set >> i) & 1) != 0) f = f ^ BooleanFunction::operand(i, 9);
            }
            return f;
        };
        const BooleanFunction f = member(a);
        const BooleanFunction g = member(b);
        RC_ASSERT((~(f | g))(point) == (~f & ~g)(point));
        RC_ASSERT((f - g)(point) == (f(point) && !g(point)));
        RC_ASSERT((f ^ g)(point) == (f(point) != g(point)));
    });
}

TEST_CASE("boolean_function: random expressions have the values of their parts, by every way of evaluation") {
    support::Dice dice(64);
    for (int n = 0; n < 4000; ++n) {
        const unsigned arity = dice.below(3) == 0 ? unsigned(dice.between(1, 9)) : unsigned(dice.between(7, 64));
        const int leaves = dice.below(8) == 0 ? dice.between(60, 90) : dice.between(1, 8);
        check_points(dice, draw_expression(dice, arity, leaves, dice.between(1, 4), dice.below(3)), 40);
    }
}

TEST_CASE("boolean_function: chains of one operation, and programs of any depth") {
    support::Dice dice(7);
    const auto operand = [](unsigned i) {
        return Known{BooleanFunction::operand(i, 64), [=](Bits b) { return (b >> i & 1U) != 0; }};
    };
    for (int how = 0; how < 4; ++how) {
        for (const bool from_left : {true, false}) {
            Known chain = operand(0);
            for (unsigned i = 1; i < 140; ++i) {
                const Known next = operand(i * 5 % 64);
                chain = from_left ? joined(how, chain, next) : joined(how, next, chain);
                if (i % 7 == 0 || (60 < i && i < 70)) check_points(dice, chain, 20);
                for (unsigned k = 0; k < 64; ++k) {
                    REQUIRE(chain.function(Bits(1) << k) == chain.plain(Bits(1) << k));
                    REQUIRE(chain.function(~(Bits(1) << k)) == chain.plain(~(Bits(1) << k)));
                }
            }
        }
    }
}
