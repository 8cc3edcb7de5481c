// SPDX-License-Identifier: Apache-2.0
/// Merging: two trees over the same space become one, whose cells are the common parts of theirs. What a common cell is
/// labelled with is a parameter, the *rule*; with `bool` labels and the rule of a Boolean operation the merged tree is
/// the operation's result.
///
/// The merge walks both trees at once, carrying the cell. A cut that misses the cell is passed over without a trace, so
/// no empty cell is ever made; where one tree has come to a leaf that decides, or the other one is still whole, nothing
/// more is cut. [Naylor-Amanatides-Thibault-1990] partition one tree by the other's cuts instead, from sub-hyperplanes;
/// carrying the cell needs no copies of trees, and its tests are exact about emptiness.
#ifndef CLEAVE_BSP_MERGE_HPP
#define CLEAVE_BSP_MERGE_HPP

#include <cleave/base/operation.hpp>
#include <cleave/bsp/cells.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/execution/progress.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The leaf rule of a Boolean operation on `bool` labels.
class BooleanRule {
public:
    explicit BooleanRule(Operation operation)
        : BooleanRule([operation](bool a, bool b) { return apply(operation, a, b); }) {}

    /// From any function of two `bool`s.
    template <std::predicate<bool, bool> F>
    explicit BooleanRule(F&& f) {
        for (const bool a : {false, true})
            for (const bool b : {false, true}) table_[index(a, b)] = f(a, b);
    }

    [[nodiscard]] bool operator()(bool a, bool b) const noexcept { return table_[index(a, b)]; }
    /// The result where it follows from the first operand alone: what is inside A is inside its union with anything.
    [[nodiscard]] std::optional<bool> first_decides(bool a) const noexcept {
        if (table_[index(a, false)] != table_[index(a, true)]) return std::nullopt;
        return table_[index(a, false)];
    }
    [[nodiscard]] std::optional<bool> second_decides(bool b) const noexcept {
        if (table_[index(false, b)] != table_[index(true, b)]) return std::nullopt;
        return table_[index(false, b)];
    }

private:
    static constexpr std::size_t index(bool a, bool b) noexcept { return (a ? 2U : 0U) + (b ? 1U : 0U); }

    std::array<bool, 4> table_{};
};

namespace detail {

template <CellClip M, class A, class B, class Rule>
class TreeMerger {
public:
    using Plane = typename M::plane_type;
    using Cell = typename M::cell_type;
    using Label = std::remove_cvref_t<std::invoke_result_t<Rule&, const A&, const B&>>;

    TreeMerger(M& model, const PlaneTree<Plane, A>& a, const PlaneTree<Plane, B>& b, Rule& rule)
        : model_(model), a_(a), b_(b), rule_(rule) {}

    PlaneTree<Plane, Label> run(ProgressReporter* progress) {
        open_.push_back(Task{model_.universe(), a_.root(), b_.root(), true, true, Branch{}, ChildSide::minus});
        while (!open_.empty()) {
            if (progress != nullptr) progress->advance();
            Task task = std::move(open_.back());
            open_.pop_back();
            merge(std::move(task));
        }
        return PlaneTree<Plane, Label>(std::move(to_));
    }

private:
    /// A cell, the branches that meet there, and where the result will hang. `whole_a`: the cell is all of a's cell,
    /// because no cut of b has reduced it.
    struct Task {
        Cell cell;
        Branch a;
        Branch b;
        bool whole_a;
        bool whole_b;
        Branch parent;
        ChildSide side;
    };

    static constexpr bool has_first = requires(Rule & r, const A& a) { r.first_decides(a); };
    static constexpr bool has_second = requires(Rule & r, const B& b) { r.second_decides(b); };

    void merge(Task t) {
        for (;;) {
            if (t.a.is_leaf()) {
                if constexpr (has_first) {
                    if (auto l = rule_.first_decides(a_.label(t.a))) return hang(t, to_.add_leaf(*std::move(l)));
                }
            }
            if (t.b.is_leaf()) {
                if constexpr (has_second) {
                    if (auto l = rule_.second_decides(b_.label(t.b))) return hang(t, to_.add_leaf(*std::move(l)));
                }
            }
            if (t.a.is_leaf() && t.b.is_leaf()) {
                return hang(t, to_.add_leaf(rule_(a_.label(t.a), b_.label(t.b))));
            }
            if (t.a.is_leaf() && t.whole_b) {
                const A& label = a_.label(t.a);
                return hang(t, copy_subtree(b_, t.b, to_, [&](const B& x) { return rule_(label, x); }));
            }
            if (t.b.is_leaf() && t.whole_a) {
                const B& label = b_.label(t.b);
                return hang(t, copy_subtree(a_, t.a, to_, [&](const A& x) { return rule_(x, label); }));
            }
            // A cut of b that misses the cell costs no split; with none left, a may be copied as a whole.
            if (t.b.is_node() && !t.whole_b) {
                const FacetSide s = model_.cell_side(b_.cut(t.b), t.cell);
                if (s != FacetSide::crossing) {
                    t.b = b_.child(t.b, s == FacetSide::minus ? ChildSide::minus : ChildSide::plus);
                    continue;
                }
            }
            const bool by_a = t.a.is_node();
            const Plane& h = by_a ? a_.cut(t.a) : b_.cut(t.b);
            auto s = model_.split_cell(h, t.cell);
            if (s.side != FacetSide::crossing) {
                const ChildSide side = s.side == FacetSide::minus ? ChildSide::minus : ChildSide::plus;
                (by_a ? t.a : t.b) = by_a ? a_.child(t.a, side) : b_.child(t.b, side);
                continue;
            }
            const Branch node = to_.add_node(h);
            hang(t, node);
            for (const ChildSide side : {ChildSide::plus, ChildSide::minus}) {
                open_.push_back(Task{side == ChildSide::minus ? *std::move(s.minus) : *std::move(s.plus),
                                     by_a ? a_.child(t.a, side) : t.a, by_a ? t.b : b_.child(t.b, side),
                                     t.whole_a && by_a, t.whole_b && !by_a, node, side});
            }
            return;
        }
    }

    void hang(const Task& t, Branch child) { to_.hang(t.parent, t.side, child); }

    M& model_;
    const PlaneTree<Plane, A>& a_;
    const PlaneTree<Plane, B>& b_;
    Rule& rule_;
    TreeParts<Plane, Label> to_;
    std::vector<Task> open_;
};

}  // namespace detail

/// The tree whose label at each point is `rule(label in a, label in b)`.
///
/// A rule may also say `first_decides(label)` and `second_decides(label)`, an optional result that does not depend on
/// the other operand (see `BooleanRule`); such cells are not cut further.
/// Requires: neither tree has empty cells. Returns: a tree without empty cells, numbered parents first; equal
///   neighbours are left for `collapse` to join. The cuts of a come before those of b.
/// Cost: for each cell of a not decided by a alone, a walk down b with a side test of the cell at each node passed
///   and a split at each one that crosses it. Subtrees of a in which b does not cut are copied without any test.
template <CellClip M, class A, class B, class Rule>
requires std::invocable<Rule&, const A&, const B&>
[[nodiscard]] auto merge(M& model, const PlaneTree<typename M::plane_type, A>& a,
                         const PlaneTree<typename M::plane_type, B>& b, Rule rule,
                         ProgressReporter* progress = nullptr) {
    return detail::TreeMerger<M, A, B, Rule>(model, a, b, rule).run(progress);
}

CLEAVE_END_NAMESPACE

#endif
