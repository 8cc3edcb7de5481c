// SPDX-License-Identifier: Apache-2.0
/// Trimming: a cut is dropped where one of its two subtrees also tells the labels on the other side.
///
/// `collapse` compares subtrees node by node; trimming compares what they say, cell by cell, so it finds cuts that
/// carry no boundary wherever they are: structural cuts, and those whose facets an operation has removed. It is valid
/// because no cell is empty: a branch that is kept stands for a larger cell afterwards, and its cuts still run through
/// it.
#ifndef CLEAVE_BSP_TRIM_HPP
#define CLEAVE_BSP_TRIM_HPP

#include <cleave/bsp/cells.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/clip/concepts.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

template <CellClip M, class Label>
class TreeTrimmer {
public:
    using Plane = typename M::plane_type;
    using Cell = typename M::cell_type;
    using Tree = PlaneTree<Plane, Label>;

    TreeTrimmer(M& model, const Tree& tree) : model_(model), from_(tree) {}

    Tree run() {
        std::vector<Visit> open;
        open.push_back(Visit{from_.root(), model_.universe(), {}, {}, false});
        while (!open.empty()) {
            Visit& v = open.back();
            if (v.branch.is_leaf()) {
                done_.push_back(parts_.add_leaf(from_.label(v.branch)));
                open.pop_back();
            } else if (v.entered) {
                join(v);
                open.pop_back();
            } else {
                auto s = model_.split_cell(from_.cut(v.branch), v.cell);
                CLEAVE_CHECK_CONTRACT("requirement", s.side == FacetSide::crossing);
                v.minus = *std::move(s.minus);
                v.plus = *std::move(s.plus);
                v.entered = true;
                Visit minus{from_.minus(v.branch), v.minus, {}, {}, false};
                Visit plus{from_.plus(v.branch), v.plus, {}, {}, false};
                open.push_back(std::move(plus));
                open.push_back(std::move(minus));
            }
        }
        parts_.root = done_.back();
        // What was dropped is still in the arrays: copy what hangs together.
        const Tree all(std::move(parts_));
        TreeParts<Plane, Label> kept;
        kept.root = copy_subtree(all, all.root(), kept, [](const Label& x) { return x; });
        return Tree(std::move(kept));
    }

private:
    struct Visit {
        Branch branch;
        Cell cell;
        Cell minus;
        Cell plus;
        bool entered;
    };

    /// The two subtrees of the visited node are the last two done, minus before plus.
    void join(const Visit& v) {
        const Branch plus = done_.back();
        done_.pop_back();
        const Branch minus = done_.back();
        if (agree(plus, minus, v.minus)) {
            done_.back() = plus;
        } else if (agree(minus, plus, v.plus)) {
            done_.back() = minus;
        } else {
            const Branch node = parts_.add_node(from_.cut(v.branch));
            parts_.nodes.back().minus = minus;
            parts_.nodes.back().plus = plus;
            done_.back() = node;
        }
    }

    /// Whether two branches have the same labels all over the cell. Disagreement is usually found in the first cells.
    bool agree(Branch a, Branch b, const Cell& cell) {
        std::vector<Pair> open;
        open.push_back(Pair{cell, a, b});
        while (!open.empty()) {
            Pair p = std::move(open.back());
            open.pop_back();
            if (p.a == p.b) continue;
            if (p.a.is_leaf() && p.b.is_leaf()) {
                if (!(parts_.leaves[p.a.index()].label == parts_.leaves[p.b.index()].label)) return false;
                continue;
            }
            const bool by_a = p.a.is_node();
            const TreeNode<Plane>& n = parts_.nodes[by_a ? p.a.index() : p.b.index()];
            auto s = model_.split_cell(n.cut, p.cell);
            const Branch other = by_a ? p.b : p.a;
            if (s.side != FacetSide::crossing) {
                open.push_back(Pair{std::move(p.cell), s.side == FacetSide::minus ? n.minus : n.plus, other});
                continue;
            }
            open.push_back(Pair{*std::move(s.plus), n.plus, other});
            open.push_back(Pair{*std::move(s.minus), n.minus, other});
        }
        return true;
    }

    struct Pair {
        Cell cell;
        Branch a;
        Branch b;
    };

    M& model_;
    const Tree& from_;
    TreeParts<Plane, Label> parts_;
    std::vector<Branch> done_;
};

}  // namespace detail

/// The same map from space to labels without the cuts that one of their own subtrees makes superfluous.
/// Requires: no cell is empty. Returns: a tree without empty cells, and without a node that could be replaced by one of
///   its children. Cost: one comparison of subtrees over a cell per node, up to the product of their sizes where they
///   do agree.
template <CellClip M, std::equality_comparable Label>
[[nodiscard]] PlaneTree<typename M::plane_type, Label> trim(M& model,
                                                            const PlaneTree<typename M::plane_type, Label>& tree) {
    return detail::TreeTrimmer<M, Label>(model, tree).run();
}

CLEAVE_END_NAMESPACE

#endif
