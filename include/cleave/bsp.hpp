// SPDX-License-Identifier: Apache-2.0
/// Binary space partitions: the tree, how it is built from facets, how it is walked, asked and simplified.
///
/// | header                | holds                                                                       |
/// |-----------------------|-----------------------------------------------------------------------------|
/// | `bsp/tree.hpp`        | `PlaneTree`: nodes with cuts, leaves with labels, in flat arrays            |
/// | `bsp/bsp_tree.hpp`    | `BspTree<D, N, Label>`: the same with the planes of D-space                 |
/// | `bsp/visit.hpp`       | walks: parents first, children first, from near to far                      |
/// | `bsp/pivot.hpp`       | which plane cuts next: first, fewest splits, balanced, structural           |
/// | `bsp/facet_tree.hpp`  | a tree that keeps the facets in its cuts                                    |
/// | `bsp/build.hpp`       | from facets to a tree                                                       |
/// | `bsp/lazy_tree.hpp`   | a tree that is built only where something reaches it                        |
/// | `bsp/classify.hpp`    | where a point lies                                                          |
/// | `bsp/complement.hpp`  | new labels, and the complement                                              |
/// | `bsp/collapse.hpp`    | superfluous cuts dropped                                                    |
/// | `bsp/cells.hpp`       | cells of branches, sub-hyperplanes, the part of a tree inside a cell        |
/// | `bsp/merge.hpp`       | two trees become one, by any rule for common cells                          |
/// | `bsp/tree_boundary.hpp` | the boundary of a tree's set                                              |
/// | `bsp/trim.hpp`        | cuts without boundary dropped                                               |
/// | `bsp/statistics.hpp`  | counts and depths                                                           |
/// | `bsp/invariant.hpp`   | checkers                                                                    |
///
/// All algorithms are templates over a `Clip` model (`clip/concepts.hpp`) and name neither numbers nor dimensions; none
/// of them recurses. `docs/explanation/trees.md` explains them.
#ifndef CLEAVE_BSP_HPP
#define CLEAVE_BSP_HPP

#include <cleave/bsp/bsp_tree.hpp>
#include <cleave/bsp/build.hpp>
#include <cleave/bsp/cells.hpp>
#include <cleave/bsp/classify.hpp>
#include <cleave/bsp/collapse.hpp>
#include <cleave/bsp/complement.hpp>
#include <cleave/bsp/facet_tree.hpp>
#include <cleave/bsp/invariant.hpp>
#include <cleave/bsp/lazy_tree.hpp>
#include <cleave/bsp/merge.hpp>
#include <cleave/bsp/pivot.hpp>
#include <cleave/bsp/statistics.hpp>
#include <cleave/bsp/tree.hpp>
#include <cleave/bsp/tree_boundary.hpp>
#include <cleave/bsp/trim.hpp>
#include <cleave/bsp/visit.hpp>

#endif
