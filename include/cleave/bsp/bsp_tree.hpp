// SPDX-License-Identifier: Apache-2.0
/// `BspTree<D, N, Label>`: the tree whose cuts are planes of D-space. The one header of this folder that sees geometry.
#ifndef CLEAVE_BSP_BSP_TREE_HPP
#define CLEAVE_BSP_BSP_TREE_HPP

#include <cleave/bsp/tree.hpp>
#include <cleave/geometry/plane.hpp>

CLEAVE_BEGIN_NAMESPACE

/// A binary space partition of D-space by planes with coefficients of type N. With `bool` labels it is a set of points
/// (true is inside); other labels make it a map of space.
template <int D, ExactRing N, class Label = bool>
requires(D >= 1) using BspTree = PlaneTree<Plane<D, N>, Label>;

CLEAVE_END_NAMESPACE

#endif
