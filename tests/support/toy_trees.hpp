// SPDX-License-Identifier: Apache-2.0
/// Toy trees that need no builder, and the comparison of a tree with the grid oracle, point by point.
#ifndef CLEAVE_TESTS_SUPPORT_TOY_TREES_HPP
#define CLEAVE_TESTS_SUPPORT_TOY_TREES_HPP

#include "support/toy_space.hpp"

#include <cleave/bsp/classify.hpp>
#include <cleave/bsp/tree.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace toy {

template <class Label = bool>
using Tree = cleave::PlaneTree<Plane, Label>;

/// Whether the tree's answer is the oracle's at each point of the half-integer grid on and around the cells.
template <std::size_t D>
[[nodiscard]] bool agrees(const Tree<>& tree, const Grid<D>& grid) {
    Space<D> space;
    bool same = true;
    grid.for_each_point([&](const Point<D>& p) { same = same && classify(space, tree, p) == grid.locate(p); });
    return same;
}

/// A chain of `depth` cuts on a line: cut k is the point k; [k - 1, k] has the label of k's parity.
/// With `on_minus` each cut has the rest of the chain on its minus side, otherwise on its plus side.
[[nodiscard]] inline Tree<> chain(std::size_t depth, bool on_minus) {
    cleave::TreeParts<Plane> parts;
    cleave::Branch rest = parts.add_leaf(depth % 2 == 1);
    for (std::size_t k = depth; k-- > 0;) {
        const cleave::Branch leaf = parts.add_leaf(k % 2 == 1);
        const cleave::Branch node =
            parts.add_node(Plane{0, static_cast<Integer>(k), on_minus ? cleave::Sign::minus : cleave::Sign::plus});
        parts.nodes.back().minus = on_minus ? rest : leaf;
        parts.nodes.back().plus = on_minus ? leaf : rest;
        rest = node;
    }
    parts.root = rest;
    return Tree<>(std::move(parts));
}

/// The tree with a cut between any two cells of the grid [0, size)^D and around it, needed or not: no cell is empty,
/// and most cuts are superfluous. `label(cell)` is also asked for cells outside the grid, at coordinates -1 and size.
template <std::size_t D, class LabelOf>
[[nodiscard]] auto grid_tree(Integer size, LabelOf&& label) {
    using Corner = std::array<Integer, D>;
    using Label = std::remove_cvref_t<std::invoke_result_t<LabelOf&, const Corner&>>;
    cleave::TreeParts<Plane, Label> parts;
    struct Part {
        Corner low;
        Corner high;
        cleave::Branch parent;
        cleave::ChildSide side;
    };
    Corner low{};
    Corner high{};
    low.fill(-1);
    high.fill(size + 1);
    std::vector<Part> open{{low, high, {}, {}}};
    while (!open.empty()) {
        const Part part = open.back();
        open.pop_back();
        std::size_t axis = 0;
        for (std::size_t i = 1; i < D; ++i) {
            if (part.high[i] - part.low[i] > part.high[axis] - part.low[axis]) axis = i;
        }
        const Integer middle = part.low[axis] + (part.high[axis] - part.low[axis]) / 2;
        const bool unit = part.high[axis] - part.low[axis] == 1;
        const cleave::Branch b =
            unit ? parts.add_leaf(label(part.low)) : parts.add_node(Plane{axis, middle, cleave::Sign::plus});
        if (part.parent.is_none()) {
            parts.root = b;
        } else {
            parts.nodes[part.parent.index()].child(part.side) = b;
        }
        if (unit) continue;
        Part below{part.low, part.high, b, cleave::ChildSide::minus};
        Part above{part.low, part.high, b, cleave::ChildSide::plus};
        below.high[axis] = middle;
        above.low[axis] = middle;
        open.push_back(above);
        open.push_back(below);
    }
    return Tree<Label>(std::move(parts));
}

/// The same with the cells of a grid as labels.
template <std::size_t D>
[[nodiscard]] Tree<> grid_tree(const Grid<D>& grid) {
    return grid_tree<D>(grid.size(), [&](const std::array<Integer, D>& c) { return grid.cell(c); });
}

}  // namespace toy

#endif
