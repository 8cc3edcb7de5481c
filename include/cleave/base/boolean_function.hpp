// SPDX-License-Identifier: Apache-2.0
/// Boolean functions of up to 64 operands: the value of a set expression at a point, from one bit per operand.
///
/// A facet of operand i belongs to the boundary of the result iff the function's value differs between its two sides,
/// so this is all that an n-ary set operation needs to know of the expression it evaluates.
#ifndef CLEAVE_BASE_BOOLEAN_FUNCTION_HPP
#define CLEAVE_BASE_BOOLEAN_FUNCTION_HPP

#include <cleave/base/contract.hpp>
#include <cleave/base/operation.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// An expression over the bits 0 .. arity()-1. Immutable; copies may be used from several threads.
///
/// Built from operands, counts and parities of sets of operands, and combined by `| & - ^ ~`:
/// `BooleanFunction::operand(0, 3) - BooleanFunction::operand(1, 3)`.
///
/// Kept as a program in postfix order; up to six operands the 64-bit truth table is computed as well, and evaluation
/// is one shift.
class BooleanFunction {
public:
    /// Bit i says whether the point belongs to operand i. Bits from arity() on are ignored.
    using Bits = std::uint64_t;

    static constexpr unsigned max_arity = 64;

    /// The function that is 1 wherever operand i is. Requires: i < arity <= 64.
    [[nodiscard]] static BooleanFunction operand(unsigned i, unsigned arity) {
        CLEAVE_REQUIRES(i < arity);
        return BooleanFunction(arity, {Step{Kind::at_least, Bits(1) << i, 1}});
    }

    /// The same value everywhere.
    [[nodiscard]] static BooleanFunction constant(bool value, unsigned arity) {
        return BooleanFunction(arity, {Step{Kind::at_least, 0, value ? 0u : 1u}});
    }

    /// 1 where at least m of the operands are. m = 1 is the union, m = arity the intersection.
    [[nodiscard]] static BooleanFunction at_least(unsigned m, unsigned arity) {
        return BooleanFunction(arity, {Step{Kind::at_least, mask(arity), m}});
    }

    [[nodiscard]] static BooleanFunction union_(unsigned arity) { return at_least(1, arity); }

    [[nodiscard]] static BooleanFunction intersection(unsigned arity) { return at_least(arity, arity); }

    /// The first operand minus all others.
    [[nodiscard]] static BooleanFunction difference(unsigned arity) {
        CLEAVE_REQUIRES(arity >= 1);
        return operand(0, arity) & ~BooleanFunction(arity, {Step{Kind::at_least, mask(arity) & ~Bits(1), 1}});
    }

    /// 1 where an odd number of operands are.
    [[nodiscard]] static BooleanFunction symmetric_difference(unsigned arity) {
        return BooleanFunction(arity, {Step{Kind::parity, mask(arity), 0}});
    }

    /// The operation applied to all operands at once. Requires: 1 <= arity <= 64.
    [[nodiscard]] static BooleanFunction from(Operation operation, unsigned arity) {
        switch (operation) {
            case Operation::union_:
                return union_(arity);
            case Operation::intersection:
                return intersection(arity);
            case Operation::difference:
                return difference(arity);
            case Operation::symmetric_difference:
                return symmetric_difference(arity);
        }
        return constant(false, arity);
    }

    [[nodiscard]] unsigned arity() const noexcept { return arity_; }

    /// The value at a point that belongs to exactly the operands in `bits`.
    [[nodiscard]] bool operator()(Bits bits) const {
        if (arity_ <= table_arity) return ((table_ >> (bits & mask(arity_))) & 1) != 0;
        return run(bits, ~Bits(0)).low;
    }

    /// The value that the function has for every choice of the bits outside `known`, or nullopt if none is certain.
    /// Exact up to six operands; beyond, an answer is always right, but a constant may go unnoticed where an operand
    /// occurs more than once (x | ~x).
    [[nodiscard]] std::optional<bool> value_if_known(Bits bits, Bits known) const {
        if (arity_ <= table_arity) return table_value(bits, known);
        const Partial result = run(bits, known);
        return result.low == result.high ? std::optional<bool>(result.low) : std::nullopt;
    }

    [[nodiscard]] friend BooleanFunction operator~(const BooleanFunction& f) {
        std::vector<Step> steps = f.steps_;
        steps.push_back({Kind::not_, 0, 0});
        return BooleanFunction(f.arity_, std::move(steps));
    }

    /// Requires: equal arity, here and in the other three.
    [[nodiscard]] friend BooleanFunction operator|(const BooleanFunction& f, const BooleanFunction& g) {
        return join(f, g, Kind::or_);
    }
    [[nodiscard]] friend BooleanFunction operator&(const BooleanFunction& f, const BooleanFunction& g) {
        return join(f, g, Kind::and_);
    }
    [[nodiscard]] friend BooleanFunction operator^(const BooleanFunction& f, const BooleanFunction& g) {
        return join(f, g, Kind::xor_);
    }
    [[nodiscard]] friend BooleanFunction operator-(const BooleanFunction& f, const BooleanFunction& g) {
        return f & ~g;
    }

private:
    /// at_least and parity push a value, not_ replaces the top of the stack, the others join the two topmost.
    enum class Kind : std::uint8_t { at_least, parity, not_, or_, and_, xor_ };

    struct Step {
        Kind kind;
        Bits operands;       // the set counted by at_least and parity
        unsigned threshold;  // of at_least
    };

    /// Kleene's three-valued logic: false is {0, 0}, true {1, 1}, unknown {0, 1}.
    struct Partial {
        bool low;
        bool high;
        friend Partial operator|(Partial a, Partial b) { return {a.low || b.low, a.high || b.high}; }
        friend Partial operator&(Partial a, Partial b) { return {a.low && b.low, a.high && b.high}; }
        friend Partial operator!(Partial a) { return {!a.high, !a.low}; }
        friend Partial operator^(Partial a, Partial b) { return (a & !b) | ((!a) & b); }
    };

    static constexpr unsigned table_arity = 6;

    BooleanFunction(unsigned arity, std::vector<Step> steps) : arity_(arity), steps_(std::move(steps)) {
        CLEAVE_REQUIRES(arity <= max_arity);
        if (arity_ > table_arity) return;
        for (Bits bits = 0; bits < (Bits(1) << arity_); ++bits) table_ |= Bits(run(bits, ~Bits(0)).low) << bits;
    }

    [[nodiscard]] static constexpr Bits mask(unsigned arity) noexcept {
        return arity >= max_arity ? ~Bits(0) : (Bits(1) << arity) - 1;
    }

    /// The value of a counting step.
    [[nodiscard]] static Partial count(const Step& step, Bits bits, Bits known) noexcept {
        const auto least = static_cast<unsigned>(std::popcount(step.operands & bits & known));
        const auto open = static_cast<unsigned>(std::popcount(step.operands & ~known));
        if (step.kind == Kind::at_least) return {least >= step.threshold, least + open >= step.threshold};
        const bool odd = least % 2 != 0;
        return open == 0 ? Partial{odd, odd} : Partial{false, true};
    }

    [[nodiscard]] static BooleanFunction join(const BooleanFunction& f, const BooleanFunction& g, Kind kind) {
        CLEAVE_REQUIRES(f.arity_ == g.arity_);
        std::vector<Step> steps = f.steps_;
        steps.insert(steps.end(), g.steps_.begin(), g.steps_.end());
        steps.push_back({kind, 0, 0});
        return BooleanFunction(f.arity_, std::move(steps));
    }

    /// Runs the program, with the bits outside `known` unknown.
    [[nodiscard]] Partial run(Bits bits, Bits known) const {
        std::vector<Partial> stack;
        stack.reserve(steps_.size());
        for (const Step& step : steps_) {
            if (step.kind == Kind::at_least || step.kind == Kind::parity) {
                stack.push_back(count(step, bits, known));
                continue;
            }
            const Partial top = stack.back();
            if (step.kind == Kind::not_) {
                stack.back() = !top;
                continue;
            }
            stack.pop_back();
            Partial& below = stack.back();
            below = step.kind == Kind::or_ ? below | top : step.kind == Kind::and_ ? below & top : below ^ top;
        }
        return stack.back();
    }

    [[nodiscard]] std::optional<bool> table_value(Bits bits, Bits known) const {
        const Bits free = mask(arity_) & ~known;
        const Bits fixed = bits & known & mask(arity_);
        const bool value = (*this)(fixed);
        // Every subset of the free bits, the empty one last.
        for (Bits choice = free; choice != 0; choice = (choice - 1) & free) {
            if ((*this)(fixed | choice) != value) return std::nullopt;
        }
        return value;
    }

    unsigned arity_;
    std::vector<Step> steps_;
    Bits table_ = 0;  // bit b is the value at bits b, for arity <= table_arity
};

CLEAVE_END_NAMESPACE

#endif
