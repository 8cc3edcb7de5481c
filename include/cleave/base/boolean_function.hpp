// SPDX-License-Identifier: Apache-2.0
/// Boolean functions of up to 64 operands: the value of a set expression at a point, from one bit per operand.
///
/// A facet of operand i belongs to the boundary of the result iff the function's value differs between its two sides,
/// so this is all that an n-ary set operation needs to know of the expression it evaluates.
#ifndef CLEAVE_BASE_BOOLEAN_FUNCTION_HPP
#define CLEAVE_BASE_BOOLEAN_FUNCTION_HPP

#include <cleave/base/contract.hpp>
#include <cleave/base/operation.hpp>

#include <algorithm>
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
/// Kept as a program in postfix order. Up to six operands the 64-bit truth table is computed as well, and evaluation is
/// one shift; beyond, unions, intersections and differences are one comparison of masks, and other programs run on a
/// stack of bits in one word.
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
        if (match_) return ((bits & match_->of) == match_->value) != match_->negated;
        return depth_ <= word_depth ? run_in_word(bits) : run(bits, ~Bits(0)).low;
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

    /// The bits `of` are those of `value`; negated: they are not. With no bits, true and false.
    struct Match {
        Bits of;
        Bits value;
        bool negated;

        friend Match operator!(Match a) { return {a.of, a.value, !a.negated}; }
        /// Both, where that is a match again.
        friend std::optional<Match> operator&(Match a, Match b) {
            if (a.of == 0) return a.negated ? a : b;
            if (b.of == 0) return b.negated ? b : a;
            for (Match* m : {&a, &b})
                if (m->negated && std::has_single_bit(m->of)) *m = {m->of, m->value ^ m->of, false};
            if (a.negated || b.negated) return std::nullopt;
            if (((a.value ^ b.value) & a.of & b.of) != 0) return Match{0, 0, true};
            return Match{a.of | b.of, a.value | b.value, false};
        }
    };

    static constexpr unsigned table_arity = 6;
    static constexpr std::size_t word_depth = 64;

    BooleanFunction(unsigned arity, std::vector<Step> steps) : arity_(arity), steps_(std::move(steps)) {
        CLEAVE_REQUIRES(arity <= max_arity);
        find_depth();
        if (arity_ > table_arity) {
            match_ = match();
            return;
        }
        for (Bits bits = 0; bits < (Bits(1) << arity_); ++bits) table_ |= Bits(run(bits, ~Bits(0)).low) << bits;
    }

    /// How many values the program has at once.
    void find_depth() {
        std::size_t depth = 0;
        for (const Step& step : steps_) {
            if (is_count(step)) depth_ = std::max(depth_, ++depth);
            if (step.kind == Kind::or_ || step.kind == Kind::and_ || step.kind == Kind::xor_) --depth;
        }
    }

    /// The program as one match, if each of its steps gives one.
    [[nodiscard]] std::optional<Match> match() const {
        std::vector<Match> stack;
        for (const Step& step : steps_) {
            std::optional<Match> m;
            if (is_count(step)) {
                m = match_of(step);
            } else if (step.kind == Kind::not_) {
                m = !stack.back();
                stack.pop_back();
            } else {
                const Match b = stack.back();
                stack.pop_back();
                const Match a = stack.back();
                stack.pop_back();
                if (step.kind == Kind::and_) m = a & b;
                if (step.kind == Kind::or_) m = (!a) & (!b);
                if (step.kind == Kind::or_ && m) m = !*m;
            }
            if (!m) return std::nullopt;
            stack.push_back(*m);
        }
        return stack.back();
    }

    [[nodiscard]] static std::optional<Match> match_of(const Step& step) {
        const auto size = static_cast<unsigned>(std::popcount(step.operands));
        if (step.kind == Kind::parity) return std::nullopt;
        if (step.threshold == 0) return Match{0, 0, false};
        if (step.threshold > size) return Match{0, 0, true};
        if (step.threshold == size) return Match{step.operands, step.operands, false};
        if (step.threshold == 1) return Match{step.operands, 0, true};
        return std::nullopt;
    }

    /// Whether a step pushes a value.
    [[nodiscard]] static bool is_count(const Step& step) noexcept {
        return step.kind == Kind::at_least || step.kind == Kind::parity;
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

    /// Runs the program on a stack of bits. Requires: its depth is at most `word_depth`.
    [[nodiscard]] bool run_in_word(Bits bits) const noexcept {
        Bits stack = 0;  // the lowest bit is the top
        for (const Step& step : steps_) {
            if (is_count(step)) {
                stack = stack << 1U | Bits(count(step, bits, ~Bits(0)).low);
                continue;
            }
            if (step.kind == Kind::not_) {
                stack ^= 1U;
                continue;
            }
            const Bits top = stack & 1U;
            stack >>= 1U;
            stack = step.kind == Kind::or_    ? stack | top
                    : step.kind == Kind::and_ ? stack & (~Bits(1) | top)
                                              : stack ^ top;
        }
        return (stack & 1U) != 0;
    }

    /// Runs the program, with the bits outside `known` unknown.
    [[nodiscard]] Partial run(Bits bits, Bits known) const {
        std::vector<Partial> stack;
        stack.reserve(depth_);
        for (const Step& step : steps_) {
            if (is_count(step)) {
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
    Bits table_ = 0;              // bit b is the value at bits b, for arity <= table_arity
    std::optional<Match> match_;  // beyond
    std::size_t depth_ = 0;
};

CLEAVE_END_NAMESPACE

#endif
