// SPDX-License-Identifier: Apache-2.0
/// Meshes: points and polygons, the form in which solids come and go.
///
///     polygon_mesh    the mesh itself, with double or rational coordinates
///     to_region       the solid that a mesh bounds
///     from_region     the mesh of a solid, exact or rounded (boundary_points, boundary_triangles)
///     resolve         the solid that a mesh describes by a winding rule where it runs through itself
///     self_intersections  which faces of a mesh cross or overlap each other
///     validate        does a mesh bound a set; if not, why and where (mesh_report, mesh_error)
///     face_shape      flat, without area, not flat; faces in triangles
///     triangulate     polygon sets with holes into triangles, every vertex used
///     weld            equal points become one
///     point_tests     the exact tests behind all of these
///     edge_balance    the closedness test (edge_buckets)
#ifndef CLEAVE_MESH_HPP
#define CLEAVE_MESH_HPP

#include <cleave/mesh/boundary_points.hpp>
#include <cleave/mesh/boundary_triangles.hpp>
#include <cleave/mesh/edge_balance.hpp>
#include <cleave/mesh/edge_buckets.hpp>
#include <cleave/mesh/face_shape.hpp>
#include <cleave/mesh/from_region.hpp>
#include <cleave/mesh/mesh_error.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/point_tests.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/resolve.hpp>
#include <cleave/mesh/self_intersections.hpp>
#include <cleave/mesh/tabulate.hpp>
#include <cleave/mesh/to_region.hpp>
#include <cleave/mesh/triangle_boundary.hpp>
#include <cleave/mesh/triangulate.hpp>
#include <cleave/mesh/validate.hpp>
#include <cleave/mesh/weld.hpp>

#endif
