// SPDX-License-Identifier: Apache-2.0
/// The far point: one place at infinity that is on no plane, so that every regular set contains it or does not.
#ifndef CLEAVE_REGION_FAR_POINT_HPP
#define CLEAVE_REGION_FAR_POINT_HPP

#include <cleave/bsp/tree.hpp>
#include <cleave/geometry/plane_table.hpp>

#include <cstddef>

CLEAVE_BEGIN_NAMESPACE

/// The side of a plane on which the *far point* lies, where (t, t^2, ..., t^D) comes to stay as t grows: the sign of
/// the last non-zero entry of the normal. Never zero. `Boundary::value_at_infinity` says whether it belongs to the set,
/// so that value of a Boolean combination follows from those of the operands.
template <int D>
[[nodiscard]] Sign side_of_far_point(const PlaneTable<D>& planes, PlaneId h) {
    std::size_t i = D;
    Sign s = Sign::zero;
    while (s == Sign::zero) s = planes.exact(unoriented(h))[--i].sign();
    return is_flipped(h) ? -s : s;
}

/// The label of the cell that the far point lies in (see `side_of_far_point`).
template <int D, class Label>
[[nodiscard]] Label value_at_far_point(const PlaneTable<D>& planes, const PlaneTree<PlaneId, Label>& tree) {
    Branch at = tree.root();
    while (at.is_node()) at = side_of_far_point(planes, tree.cut(at)) == Sign::minus ? tree.minus(at) : tree.plus(at);
    return tree.label(at);
}

CLEAVE_END_NAMESPACE

#endif
