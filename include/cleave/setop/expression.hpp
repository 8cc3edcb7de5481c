// SPDX-License-Identifier: Apache-2.0
/// Boolean expressions of regions that are evaluated as a whole: one arrangement instead of one for each operator.
#ifndef CLEAVE_SETOP_EXPRESSION_HPP
#define CLEAVE_SETOP_EXPRESSION_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/base/contract.hpp>
#include <cleave/region/region.hpp>
#include <cleave/setop/apply.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A Boolean expression of regions. Operators on it build a tree and cost next to nothing; `evaluate` does the work,
/// once for all operators: `evaluate(Expression<3>(a) - (b | c))` with Expressions b, c. A value; copies share the
/// tree.
///
/// Copies of one region count as one operand wherever they occur.
template <int D, class N = Rational>
class Expression {
public:
    using region_type = Region<D, N>;

    /// An operand. Implicit: an expression may begin anywhere.
    Expression(region_type region)  // NOLINT(google-explicit-constructor)
        : node_(std::make_shared<const Node>(Node{Kind::operand, std::move(region), {}, 0})) {}

    /// The points that at least m of the parts contain: m = 1 is the union, m = parts.size() the intersection, m = 0
    /// all of space.
    [[nodiscard]] static Expression at_least(unsigned m, std::span<const Expression> parts) {
        if (m == 0) return Expression(region_type::full());
        if (m > parts.size()) return Expression(region_type::empty());
        return Expression(Kind::at_least, {parts.begin(), parts.end()}, m);
    }

    [[nodiscard]] friend Expression operator|(const Expression& a, const Expression& b) {
        return joined(Kind::or_, a, b);
    }
    [[nodiscard]] friend Expression operator&(const Expression& a, const Expression& b) {
        return joined(Kind::and_, a, b);
    }
    [[nodiscard]] friend Expression operator^(const Expression& a, const Expression& b) {
        return joined(Kind::xor_, a, b);
    }
    [[nodiscard]] friend Expression operator-(const Expression& a, const Expression& b) { return a & ~b; }
    [[nodiscard]] friend Expression operator~(const Expression& a) {
        if (a.node_->kind == Kind::not_) return a.node_->parts.front();
        return Expression(Kind::not_, {a}, 0);
    }
    Expression& operator|=(const Expression& b) { return *this = *this | b; }
    Expression& operator&=(const Expression& b) { return *this = *this & b; }
    Expression& operator^=(const Expression& b) { return *this = *this ^ b; }
    Expression& operator-=(const Expression& b) { return *this = *this - b; }

    /// The different regions in the expression, in the order in which they first occur.
    [[nodiscard]] std::vector<region_type> operands() const {
        std::vector<region_type> found;
        collect(found);
        return found;
    }

    /// The value, by `evaluate_function(function, operands)` for any Boolean function of at most 64 regions.
    /// An expression of more is evaluated in parts; how they are chosen follows from the operands alone.
    template <class EvaluateFunction>
    [[nodiscard]] region_type value(EvaluateFunction&& evaluate_function) const {
        const std::vector<region_type> found = operands();
        if (found.size() <= BooleanFunction::max_arity && !has_inner_count())
            return node_->kind == Kind::operand ? node_->region : evaluate_function(function(found), found);
        std::vector<Expression> parts;
        for (const Expression& part : node_->parts) parts.push_back(part.reduced(evaluate_function));
        switch (node_->kind) {
            case Kind::operand:
                break;
            case Kind::not_:
                return complement(parts.front().node_->region);
            case Kind::at_least:
                return count(parts, evaluate_function);
            case Kind::or_:
            case Kind::and_:
            case Kind::xor_:
                return fold(parts, evaluate_function);
        }
        return node_->region;
    }

private:
    enum class Kind : std::uint8_t { operand, or_, and_, xor_, not_, at_least };

    struct Node {
        Kind kind;
        region_type region;  // of an operand
        std::vector<Expression> parts;
        unsigned threshold;  // of at_least
    };

    Expression(Kind kind, std::vector<Expression> parts, unsigned threshold)
        : node_(std::make_shared<const Node>(Node{kind, region_type(), std::move(parts), threshold})) {}

    /// Operators of one kind in a row become one node, so that a long union is wide and not deep.
    static Expression joined(Kind kind, const Expression& a, const Expression& b) {
        std::vector<Expression> parts;
        for (const Expression* e : {&a, &b}) {
            if (e->node_->kind == kind)
                parts.insert(parts.end(), e->node_->parts.begin(), e->node_->parts.end());
            else
                parts.push_back(*e);
        }
        return Expression(kind, std::move(parts), 0);
    }

    static std::size_t index_of(const std::vector<region_type>& regions, const region_type& r) {
        return std::size_t(
            std::find_if(regions.begin(), regions.end(),
                         [&](const region_type& other) { return other.shared_boundary() == r.shared_boundary(); }) -
            regions.begin());
    }

    void collect(std::vector<region_type>& found) const {
        if (node_->kind == Kind::operand) {
            if (index_of(found, node_->region) == found.size()) found.push_back(node_->region);
            return;
        }
        for (const Expression& part : node_->parts) part.collect(found);
    }

    /// Whether counts occur that a BooleanFunction cannot say: inside other operators, or of parts that are not all
    /// different operands.
    [[nodiscard]] bool has_inner_count(bool is_outermost = true) const {
        if (node_->kind == Kind::at_least) {
            if (!is_outermost) return true;
            std::vector<region_type> found;
            for (const Expression& part : node_->parts) {
                if (part.node_->kind != Kind::operand || index_of(found, part.node_->region) != found.size())
                    return true;
                found.push_back(part.node_->region);
            }
            return false;
        }
        return std::any_of(node_->parts.begin(), node_->parts.end(),
                           [](const Expression& part) { return part.has_inner_count(false); });
    }

    /// Requires: at most 64 operands, no inner counts.
    [[nodiscard]] BooleanFunction function(const std::vector<region_type>& operands) const {
        const auto arity = static_cast<unsigned>(operands.size());
        switch (node_->kind) {
            case Kind::operand:
                return BooleanFunction::operand(static_cast<unsigned>(index_of(operands, node_->region)), arity);
            case Kind::not_:
                return ~node_->parts.front().function(operands);
            case Kind::at_least:
                return BooleanFunction::at_least(node_->threshold, arity);
            case Kind::or_:
            case Kind::and_:
            case Kind::xor_:
                break;
        }
        BooleanFunction f = node_->parts.front().function(operands);
        for (std::size_t i = 1; i < node_->parts.size(); ++i) {
            const BooleanFunction g = node_->parts[i].function(operands);
            f = node_->kind == Kind::or_ ? f | g : node_->kind == Kind::and_ ? f & g : f ^ g;
        }
        return f;
    }

    /// The same as an operand, unless it is small enough to be a part of something larger.
    template <class EvaluateFunction>
    [[nodiscard]] Expression reduced(EvaluateFunction&& evaluate_function) const {
        const bool keep = (node_->kind == Kind::or_ || node_->kind == Kind::and_ || node_->kind == Kind::xor_) &&
                          !has_inner_count() && operands().size() <= BooleanFunction::max_arity / 4;
        return keep ? *this : Expression(value(evaluate_function));
    }

    /// Joins parts by this node's operator, neighbours in space two by two: what a part hides of another is gone before
    /// the next one sees it, so that this takes about half the time of arrangements of 64 operands.
    template <class EvaluateFunction>
    [[nodiscard]] region_type fold(const std::vector<Expression>& parts, EvaluateFunction&& evaluate_function) const {
        std::vector<region_type> regions;
        for (const Expression& part : parts) regions.push_back(part.value(evaluate_function));
        sort_by_place(regions);
        while (regions.size() > 1) {
            std::vector<region_type> next;
            for (std::size_t i = 0; i + 1 < regions.size(); i += 2)
                next.push_back(Expression(node_->kind, {regions[i], regions[i + 1]}, 0).value(evaluate_function));
            if (regions.size() % 2 == 1) next.push_back(regions.back());
            regions = std::move(next);
        }
        return regions.front();
    }

    /// Sorts along a curve that keeps near places together [Morton-1966]: by the bits of the coordinates of the boxes'
    /// centres in turn.
    static void sort_by_place(std::vector<region_type>& regions) {
        using Box = Bounds<D>;
        Box all;
        for (const region_type& r : regions) all.include(r.surface().bounds);
        const auto place = [&](const Box& box) {
            constexpr int bits = std::min(52, 63 / D);
            std::array<std::uint64_t, D> cell{};
            for (std::size_t x = 0; x < D; ++x) {
                const double share = (box.lo[x] / 2 + box.hi[x] / 2 - all.lo[x]) / (all.hi[x] - all.lo[x]);
                // Where a box has no centre, any place will do.
                if (share >= 0 && share <= 1)
                    cell[x] = static_cast<std::uint64_t>(share * double((std::uint64_t(1) << bits) - 1));
            }
            std::uint64_t key = 0;
            for (int bit = bits; bit-- > 0;)
                for (const std::uint64_t c : cell) key = key << 1U | (c >> unsigned(bit) & 1U);
            return key;
        };
        std::vector<std::pair<std::uint64_t, std::size_t>> order;
        for (std::size_t i = 0; i < regions.size(); ++i) order.emplace_back(place(regions[i].surface().bounds), i);
        std::sort(order.begin(), order.end());
        std::vector<region_type> sorted;
        for (const auto& [key, i] : order) sorted.push_back(std::move(regions[i]));
        regions = std::move(sorted);
    }

    /// Counts parts, each as an operand of its own. Up to 64 parts are counted at once; beyond, the sets that at least
    /// 1, 2, ..., m of the parts so far contain are kept, and each further part moves them up.
    template <class EvaluateFunction>
    [[nodiscard]] region_type count(const std::vector<Expression>& parts, EvaluateFunction&& evaluate_function) const {
        std::vector<region_type> regions;
        for (const Expression& part : parts) regions.push_back(part.value(evaluate_function));
        if (regions.size() <= BooleanFunction::max_arity)
            return evaluate_function(BooleanFunction::at_least(node_->threshold, static_cast<unsigned>(regions.size())),
                                     regions);
        std::vector<region_type> reached(node_->threshold, region_type::empty());
        for (const region_type& r : regions) {
            for (std::size_t m = reached.size(); m-- > 0;) {
                const Expression below = m == 0 ? Expression(r) : Expression(r) & Expression(reached[m - 1]);
                reached[m] = (Expression(reached[m]) | below).value(evaluate_function);
            }
        }
        return reached.back();
    }

    std::shared_ptr<const Node> node_;
};

/// The value of an expression. Throws: Cancelled where progress was asked to stop. Cost: that of `evaluate` for one
/// Boolean function of all its regions; with more than 64 different ones it is evaluated in parts.
template <int D, class N>
[[nodiscard]] Region<D, N> evaluate(const Expression<D, N>& expression, const OperationOptions& options = {}) {
    return expression.value([&](const BooleanFunction& function, std::span<const Region<D, N>> operands) {
        return evaluate<D, N>(function, operands, options);
    });
}

CLEAVE_END_NAMESPACE

#endif
