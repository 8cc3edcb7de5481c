// SPDX-License-Identifier: Apache-2.0
/// Exact geometry in any dimension: points, oriented planes, their joins, meets and relations, boxes and maps.
///
/// | header                   | holds                                                                              |
/// |--------------------------|------------------------------------------------------------------------------------|
/// | geometry/point           | `Point<D, N>` in homogeneous coordinates, the order of points                      |
/// | geometry/plane           | `Plane<D, N>`: n.x + c = 0, plus = outside; `flip`                                 |
/// | geometry/cross_point     | `join`, the plane through D points; `meet`, the point on D planes                  |
/// | geometry/side            | the side test                                                                      |
/// | geometry/relation        | crossing, same, opposite, parallel, antiparallel                                   |
/// | geometry/plane_relation  | the enumeration of these                                                           |
/// | geometry/canonical       | primitive and canonical coefficients                                               |
/// | geometry/interning       | equal planes and points get equal ids                                              |
/// | geometry/coordinates     | numbers of any kind over one denominator                                           |
/// | geometry/line            | lines, and what planes cut from them                                               |
/// | geometry/affine_map      | exact affine maps of points and planes, rational rotations                         |
/// | geometry/box             | closed boxes, of doubles or exact                                                  |
/// | geometry/point_box       | boxes of doubles around exact points                                               |
/// | geometry/box_hierarchy   | which boxes meet a box, which pairs of boxes meet                                  |
/// | geometry/kernel          | the indexed kernel: interned planes, lazily exact points, filtered predicates      |
/// | geometry/handles         | its handles                                                                        |
/// | geometry/plane_table     | its planes                                                                         |
/// | geometry/point_record    | what it knows of a point                                                           |
/// | geometry/residues        | minors and doubles modulo 2^61-1                                                   |
/// | geometry/bounds          | boxes around points known up to an error                                           |
/// | geometry/rounded_meet    | correctly rounded coordinates of its points without an integer                      |
/// | geometry/grid_meet       | the same in machine words, for planes of small coefficients that meet at a double | |
/// geometry/box_pairs, geometry/rough_box | which boxes meet, with boxes of doubles or, faster, of floats           |
/// | geometry/double_predicates, geometry/double_plane | orientation of points of doubles, planes through them       |
/// | geometry/kernel_lines    | its lines                                                                          |
/// | geometry/kernel_turn     | orientation of its points in a projection                                          |
/// | geometry/point_interner  | the identity of its points                                                         |
/// | geometry/segment_pairs   | which segments of two sets in the plane may meet                                   |
///
/// Points and planes are homogeneous, so all of it works over a ring: `mpz_class`, `Integer`, `FixedInt<Bits>`. A field
/// appears only where a coordinate is asked for.
#ifndef CLEAVE_GEOMETRY_HPP
#define CLEAVE_GEOMETRY_HPP

#include <cleave/geometry/affine_map.hpp>
#include <cleave/geometry/bounds.hpp>
#include <cleave/geometry/box.hpp>
#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/geometry/box_pairs.hpp>
#include <cleave/geometry/canonical.hpp>
#include <cleave/geometry/coordinates.hpp>
#include <cleave/geometry/cross_point.hpp>
#include <cleave/geometry/double_plane.hpp>
#include <cleave/geometry/double_predicates.hpp>
#include <cleave/geometry/grid_meet.hpp>
#include <cleave/geometry/handles.hpp>
#include <cleave/geometry/interning.hpp>
#include <cleave/geometry/kernel.hpp>
#include <cleave/geometry/kernel_box.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/kernel_turn.hpp>
#include <cleave/geometry/line.hpp>
#include <cleave/geometry/plane.hpp>
#include <cleave/geometry/plane_relation.hpp>
#include <cleave/geometry/plane_table.hpp>
#include <cleave/geometry/point.hpp>
#include <cleave/geometry/point_box.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/geometry/point_record.hpp>
#include <cleave/geometry/relation.hpp>
#include <cleave/geometry/residues.hpp>
#include <cleave/geometry/rounded_meet.hpp>
#include <cleave/geometry/segment_pairs.hpp>
#include <cleave/geometry/side.hpp>

#endif
