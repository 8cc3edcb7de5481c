// SPDX-License-Identifier: Apache-2.0
/// Facets and how planes cut them: the contract between geometry and binary space partitioning, and its models.
///
/// | header            | holds                                                                                     |
/// |-------------------|-------------------------------------------------------------------------------------------|
/// | clip/concepts     | `Clip` and its refinements, `FacetSide`, `Split`                                          |
/// | clip/defaults     | `clip` from `split`, `split` from `clip`                                                  |
/// | clip/facet        | `Facet<D, N>` for D = 1, 2, 3: fields, `flip`, ridges, `is_valid`                         |
/// | clip/make_facet   | facets from vertices                                                                      |
/// | clip/edge_plane   | the plane that goes with an edge                                                          |
/// | clip/facet_box    | boxes of facets                                                                           |
/// | clip/coincident   | facets in the cutting plane; from signs of vertices to the side of a facet                |
/// | clip/clip_1d      | a comparison                                                                              |
/// | clip/clip_2d      | the nine-case sign table                                                                  |
/// | clip/clip_3d      | signs of the vertices and one walk round the loop                                         |
/// | clip/loop         | that walk: five cases, no vertex ever dropped                                             |
/// | clip/clip_model   | `ClipModel<D, N>`: all of it as a model, for a user's number                              |
/// | clip/kernel_clip  | the model over the indexed kernel                                                         |
/// | clip/polytope     | convex polytopes of any dimension by vertex incidences, and their cuts                    |
/// | clip/polytope_clip | facets and cells of any dimension as a model                                             |
/// | clip/propose      | structural cuts from boxes                                                                |
/// | clip/face         | `Face<D, N>`: polygons with holes on one plane, and their facets                          |
/// | clip/cut_face     | cutting a face into facets along lines of its own edges                                   |
#ifndef CLEAVE_CLIP_HPP
#define CLEAVE_CLIP_HPP

#include <cleave/clip/clip_1d.hpp>
#include <cleave/clip/clip_2d.hpp>
#include <cleave/clip/clip_3d.hpp>
#include <cleave/clip/clip_model.hpp>
#include <cleave/clip/coincident.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/clip/cut_face.hpp>
#include <cleave/clip/defaults.hpp>
#include <cleave/clip/edge_plane.hpp>
#include <cleave/clip/face.hpp>
#include <cleave/clip/facet.hpp>
#include <cleave/clip/facet_box.hpp>
#include <cleave/clip/kernel_clip.hpp>
#include <cleave/clip/loop.hpp>
#include <cleave/clip/make_facet.hpp>
#include <cleave/clip/pencil.hpp>
#include <cleave/clip/polytope.hpp>
#include <cleave/clip/polytope_clip.hpp>
#include <cleave/clip/propose.hpp>

#endif
