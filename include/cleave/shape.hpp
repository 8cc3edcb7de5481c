// SPDX-License-Identifier: Apache-2.0
/// Solids made from a few numbers: boxes, simplices, convex hulls, prisms, extrusions, discs and spheres. All exact,
/// all regions like any other; what has no interior is the empty set.
#ifndef CLEAVE_SHAPE_HPP
#define CLEAVE_SHAPE_HPP

#include <cleave/shape/box.hpp>
#include <cleave/shape/extrude.hpp>
#include <cleave/shape/hull.hpp>
#include <cleave/shape/polar_hull.hpp>
#include <cleave/shape/prism.hpp>
#include <cleave/shape/rational_point.hpp>
#include <cleave/shape/simplex.hpp>
#include <cleave/shape/sphere.hpp>

#endif
