// SPDX-License-Identifier: Apache-2.0
/// Questions about regions: exact measures and centroids, vertices and facet planes, shells and components.
#ifndef CLEAVE_QUERY_HPP
#define CLEAVE_QUERY_HPP

#include <cleave/query/boundary_edges.hpp>
#include <cleave/query/centroid.hpp>
#include <cleave/query/components.hpp>
#include <cleave/query/cone_simplices.hpp>
#include <cleave/query/contacts.hpp>
#include <cleave/query/face_contours.hpp>
#include <cleave/query/measure.hpp>
#include <cleave/query/measure_fraction.hpp>
#include <cleave/query/measure_terms.hpp>
#include <cleave/query/representation.hpp>
#include <cleave/query/residue_system.hpp>
#include <cleave/query/shells.hpp>

#endif
