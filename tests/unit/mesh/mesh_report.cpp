// SPDX-License-Identifier: Apache-2.0
#include <cleave/mesh/mesh_report.hpp>

#include "support/catch.hpp"

#include <set>

using namespace cleave;

TEST_CASE("mesh_report: an empty report is that of a good mesh") {
    const MeshReport report;
    REQUIRE(report.is_closed());
    REQUIRE(report.is_valid(Strictness::strict));
    for (const MeshDefect kind : all_mesh_defects) REQUIRE(report.count(kind) == 0);
}

TEST_CASE("mesh_report: each kind is listed once") {
    REQUIRE(std::set<MeshDefect>(all_mesh_defects.begin(), all_mesh_defects.end()).size() == all_mesh_defects.size());
}

TEST_CASE("mesh_report: which kinds are errors in which mode") {
    for (const MeshDefect kind : all_mesh_defects) {
        MeshReport report;
        report.points_not_finite.resize(kind == MeshDefect::point_not_finite ? 1 : 0);
        report.indices_out_of_range.resize(kind == MeshDefect::index_out_of_range ? 1 : 0);
        report.open_edges.resize(kind == MeshDefect::open_edge ? 1 : 0);
        report.misoriented_edges.resize(kind == MeshDefect::misoriented_edge ? 1 : 0);
        report.unbalanced_edges.resize(kind == MeshDefect::unbalanced_edge ? 1 : 0);
        report.crossing_outlines.resize(kind == MeshDefect::crossing_outline ? 1 : 0);
        report.too_few_corners.resize(kind == MeshDefect::too_few_corners ? 1 : 0);
        report.repeated_corners.resize(kind == MeshDefect::repeated_corner ? 1 : 0);
        report.zero_area_faces.resize(kind == MeshDefect::zero_area ? 1 : 0);
        report.non_planar_faces.resize(kind == MeshDefect::not_planar ? 1 : 0);
        report.t_junctions.resize(kind == MeshDefect::t_junction ? 1 : 0);
        report.unused_points.resize(kind == MeshDefect::unused_point ? 1 : 0);
        for (const MeshDefect other : all_mesh_defects) REQUIRE(report.count(other) == (other == kind ? 1U : 0U));
        const bool always = static_cast<int>(kind) <= static_cast<int>(MeshDefect::crossing_outline);
        const bool never = kind == MeshDefect::t_junction || kind == MeshDefect::unused_point;
        REQUIRE(report.is_valid(Strictness::tolerant) == !always);
        REQUIRE(report.is_valid(Strictness::strict) == never);
        REQUIRE(is_error(kind, Strictness::tolerant) == always);
        REQUIRE(is_error(kind, Strictness::strict) == !never);
        const bool edges = kind == MeshDefect::open_edge || kind == MeshDefect::misoriented_edge ||
                           kind == MeshDefect::unbalanced_edge;
        REQUIRE(report.is_closed() == !edges);
    }
}
