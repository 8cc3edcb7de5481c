// SPDX-License-Identifier: Apache-2.0
/// Cross-sections: the part of a region at one position on an axis, as a region of one dimension less.
#ifndef CLEAVE_REGION_SECTION_HPP
#define CLEAVE_REGION_SECTION_HPP

#include <cleave/base/contract.hpp>
#include <cleave/geometry/coordinates.hpp>
#include <cleave/region/region.hpp>
#include <cleave/region/tree.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The section of a region with the hyperplane x_axis = position, in the other coordinates in their order. Where faces
/// lie in that hyperplane the sets on its two sides differ: the section is the limit from below then, so that a slab
/// a <= x <= b has its full section at b and none at a. (`section` of the mirror image is the limit from above.)
/// Requires: 0 <= axis < D. Throws: NumberError for a position that is infinite or NaN.
/// Cost: that of `to_tree`, and of `to_region` for the cuts that meet the hyperplane.
template <int D, class N>
requires(D >= 2) [[nodiscard]] Region<D - 1, N> section(const Region<D, N>& region, int axis,
                                                        const std::type_identity_t<N>& position) {
    CLEAVE_REQUIRES(0 <= axis && axis < D);
    using Trace = Plane<D - 1, Integer>;
    struct Task {
        Branch from;
        Branch parent;
        ChildSide side;
    };
    const auto along = std::size_t(axis);
    const Fraction at = exact_fraction(position);
    const BspTree<D, Integer> tree = to_tree(Region<D, Integer>(region));
    TreeParts<Trace> parts;
    std::vector<Task> open{{tree.root(), Branch{}, ChildSide::minus}};
    while (!open.empty()) {
        const Task t = open.back();
        open.pop_back();
        if (t.from.is_leaf()) {
            parts.hang(t.parent, t.side, parts.add_leaf(tree.label(t.from)));
            continue;
        }
        const auto& c = tree.cut(t.from).coefficients();
        typename Trace::Coefficients trace;
        for (std::size_t i = 0, j = 0; i < std::size_t(D); ++i)
            if (i != along) trace[j++] = c[i] * at.den;
        trace[std::size_t(D) - 1] = c[along] * at.num + c[std::size_t(D)] * at.den;
        if (std::any_of(trace.begin(), trace.end() - 1, [](const Integer& x) { return !x.is_zero(); })) {
            const Branch node = parts.add_node(Trace(std::move(trace)));
            parts.hang(t.parent, t.side, node);
            open.push_back({tree.plus(t.from), node, ChildSide::plus});
            open.push_back({tree.minus(t.from), node, ChildSide::minus});
        } else {
            // The cut is parallel to the hyperplane, which is all on one side of it; just below, if they coincide.
            Sign s = trace.back().sign();
            if (s == Sign::zero) s = -c[along].sign();
            open.push_back({s == Sign::minus ? tree.minus(t.from) : tree.plus(t.from), t.parent, t.side});
        }
    }
    return Region<D - 1, N>(to_region(BspTree<D - 1, Integer>(std::move(parts))));
}

CLEAVE_END_NAMESPACE

#endif
