// SPDX-License-Identifier: Apache-2.0
/// Regions: regular sets as values, how their boundaries are stored, and how they are made from coordinates.
#ifndef CLEAVE_REGION_HPP
#define CLEAVE_REGION_HPP

#include <cleave/region/boundary.hpp>
#include <cleave/region/build.hpp>
#include <cleave/region/canonical.hpp>
#include <cleave/region/conform.hpp>
#include <cleave/region/conforming.hpp>
#include <cleave/region/convex.hpp>
#include <cleave/region/convex_facets.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/region/facet_meeting.hpp>
#include <cleave/region/facet_pieces.hpp>
#include <cleave/region/facet_winding.hpp>
#include <cleave/region/facets.hpp>
#include <cleave/region/far_point.hpp>
#include <cleave/region/make.hpp>
#include <cleave/region/polytope_faces.hpp>
#include <cleave/region/region.hpp>
#include <cleave/region/resolve.hpp>
#include <cleave/region/resolve_segments.hpp>
#include <cleave/region/section.hpp>
#include <cleave/region/surface_operands.hpp>
#include <cleave/region/transform.hpp>
#include <cleave/region/tree.hpp>

#endif
