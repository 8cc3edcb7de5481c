// SPDX-License-Identifier: Apache-2.0
/// `validate`: does a mesh bound a set, and if not, why and where. All decisions are exact.
///
/// A mesh bounds a set where its faces' edges, as directed segments, cancel out along every line. That allows four
/// faces at an edge, faces without area that close the gap between a long edge and shorter ones, and T-junctions whose
/// edges lie exactly on one line; all of these are reported. Points at equal coordinates are one point. Whether faces
/// cross each other is not asked here.
#ifndef CLEAVE_MESH_VALIDATE_HPP
#define CLEAVE_MESH_VALIDATE_HPP

#include <cleave/mesh/edge_balance.hpp>
#include <cleave/mesh/face_shape.hpp>
#include <cleave/mesh/mesh_error.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/polygon_mesh.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

template <class T>
void check_points(const PolygonMesh<T>& mesh, MeshReport& report) {
    if constexpr (std::is_floating_point_v<T>) {
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            const auto& p = mesh.points[i];
            if (!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))) {
                report.points_not_finite.push_back(static_cast<std::uint32_t>(i));
            }
        }
    }
}

template <class T>
void check_indices(const PolygonMesh<T>& mesh, MeshReport& report) {
    std::vector<char> used(mesh.points.size(), 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t c = 0; c < face.size(); ++c) {
            if (face[c] < used.size()) {
                used[face[c]] = 1;
            } else {
                report.indices_out_of_range.push_back(
                    {static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(c), face[c]});
            }
        }
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i] == 0) report.unused_points.push_back(static_cast<std::uint32_t>(i));
    }
}

template <class T>
void check_faces(const PolygonMesh<T>& mesh, MeshReport& report) {
    FaceShapes<T> shapes(mesh.points);
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
        const auto face = mesh.face(i);
        const auto f = static_cast<std::uint32_t>(i);
        const FaceShape shape = shapes.shape(face);
        switch (shape) {
            case FaceShape::flat:
                break;
            case FaceShape::too_few_corners:
                report.too_few_corners.push_back(f);
                break;
            case FaceShape::zero_area:
                report.zero_area_faces.push_back(f);
                break;
            case FaceShape::not_planar:
                report.non_planar_faces.push_back(f);
                break;
            case FaceShape::crossing:
                report.crossing_outlines.push_back(f);
                break;
        }
        if (face.size() > 3 && shape != FaceShape::too_few_corners && shapes.repeats_a_corner(face)) {
            report.repeated_corners.push_back(f);
        }
    }
}

}  // namespace detail

/// Everything that is wrong with a mesh, or odd about it. Points that are not finite or corners that refer to no point
/// leave the other checks undone (`MeshReport::complete`).
/// Requires: `first` starts at 0, ascends, and ends at the number of corners (throws ContractViolation otherwise).
/// Cost: O(n) for n corners; some 50 ns a triangle of doubles without defects.
template <class T>
[[nodiscard]] MeshReport validate(const PolygonMesh<T>& mesh) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.first[f] > mesh.first[f + 1]) throw ContractViolation("mesh: the array `first` does not ascend");
    }
    if (!mesh.first.empty() && (mesh.first.front() != 0 || mesh.first.back() != mesh.corners.size())) {
        throw ContractViolation("mesh: the array `first` does not span all corners");
    }
    MeshReport report;
    report.point_count = mesh.point_count();
    report.face_count = mesh.face_count();
    detail::check_points(mesh, report);
    detail::check_indices(mesh, report);
    report.complete = report.points_not_finite.empty() && report.indices_out_of_range.empty();
    if (!report.complete) return report;
    check_edges(mesh, report);
    detail::check_faces(mesh, report);
    return report;
}

/// The report of a mesh that is valid in the given mode. Throws: MeshError with the report, for any other; `origin`
/// lets its message name the file and lines.
template <class T>
MeshReport require_valid(const PolygonMesh<T>& mesh, Strictness strictness = Strictness::tolerant,
                         const MeshOrigin* origin = nullptr) {
    MeshReport report = validate(mesh);
    if (!report.is_valid(strictness)) throw make_mesh_error(std::move(report), mesh, strictness, origin);
    return report;
}

CLEAVE_END_NAMESPACE

#endif
