// SPDX-License-Identifier: Apache-2.0
/// `validate`: does a mesh bound a set, and if not, why and where. All decisions are exact.
///
/// A mesh bounds a set where its faces' edges, as directed segments, cancel out along every line. That allows four
/// faces at an edge, faces without area that close the gap between a long edge and shorter ones, and T-junctions whose
/// edges lie exactly on one line; all of these are reported. Points at equal coordinates are one point. Whether faces
/// cross each other is not asked here.
#ifndef CLEAVE_MESH_VALIDATE_HPP
#define CLEAVE_MESH_VALIDATE_HPP

#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/mesh/edge_balance.hpp>
#include <cleave/mesh/edge_buckets.hpp>
#include <cleave/mesh/face_shape.hpp>
#include <cleave/mesh/mesh_error.hpp>
#include <cleave/mesh/mesh_report.hpp>
#include <cleave/mesh/point_tests.hpp>
#include <cleave/mesh/polygon_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
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

/// What one pass over points says of them all.
struct PointScan {
    bool is_finite = true;
    double magnitude = 0;  ///< the largest absolute value of a coordinate, where all are finite
};

[[nodiscard]] inline PointScan scan_points(std::span<const std::array<double, 3>> points) {
    std::array<double, 3> largest{};
    std::array<double, 3> zero{};
    for (const std::array<double, 3>& p : points)
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = std::fabs(p[i]);
            largest[i] = largest[i] < x ? x : largest[i];
            zero[i] += x * 0;  // NaN for infinity and NaN, and stays it
        }
    return {zero[0] + zero[1] + zero[2] == 0, std::max({largest[0], largest[1], largest[2]})};
}

/// What a pass over some faces leaves open.
struct FaceScan {
    bool indices_exist = true;
    double volume = 0;                  ///< six times that of the cones from the origin over the triangles, as computed
    std::vector<std::uint32_t> others;  ///< all but triangles with an area
};

/// Requires: finite points.
[[nodiscard]] inline FaceScan scan_faces(const PolygonMesh<double>& mesh, std::size_t begin, std::size_t end) {
    FaceScan scan;
    const std::size_t points = mesh.points.size();
    for (std::size_t f = begin; f < end; ++f) {
        const std::uint32_t first = mesh.first[f];
        if (mesh.first[f + 1] - first != 3) {
            scan.others.push_back(static_cast<std::uint32_t>(f));
            continue;
        }
        const std::uint32_t* const c = mesh.corners.data() + first;
        if (std::max({c[0], c[1], c[2]}) >= points) {
            scan.indices_exist = false;
            continue;
        }
        const std::array<double, 3>& p = mesh.points[c[0]];
        const TriangleNormal normal = triangle_normal(p, mesh.points[c[1]], mesh.points[c[2]]);
        scan.volume += p[0] * normal.n[0] + p[1] * normal.n[1] + p[2] * normal.n[2];
        if (!normal.is_nonzero) scan.others.push_back(static_cast<std::uint32_t>(f));
    }
    return scan;
}

/// Faces by what is wrong with them, ascending.
struct FaceDefects {
    std::vector<std::uint32_t> crossing, few_corners, repeated, no_area, not_planar;
};

template <class T>
[[nodiscard]] FaceDefects check_faces(const PolygonMesh<T>& mesh, FaceShapes<T>& shapes,
                                      std::span<const std::uint32_t> faces) {
    FaceDefects defects;
    for (const std::uint32_t f : faces) {
        const auto face = mesh.face(f);
        const FaceShape shape = shapes.shape(face);
        switch (shape) {
            case FaceShape::flat:
                break;
            case FaceShape::too_few_corners:
                defects.few_corners.push_back(f);
                break;
            case FaceShape::zero_area:
                defects.no_area.push_back(f);
                break;
            case FaceShape::not_planar:
                defects.not_planar.push_back(f);
                break;
            case FaceShape::crossing:
                defects.crossing.push_back(f);
                break;
        }
        if (face.size() > 3 && shape != FaceShape::too_few_corners && shapes.repeats_a_corner(face))
            defects.repeated.push_back(f);
    }
    return defects;
}

/// The executor for work on a mesh: no other, where the work is done before another thread would have woken up.
template <class T>
[[nodiscard]] ExecutorRef executor_for(const PolygonMesh<T>& mesh, ExecutorRef executor) {
    constexpr std::size_t few_corners = std::size_t(1) << 14U;
    return mesh.corners.size() < few_corners ? ExecutorRef() : executor;
}

/// `validate`, with what else its passes found out.
template <class T>
class MeshValidation {
public:
    explicit MeshValidation(const PolygonMesh<T>& mesh, ExecutorRef executor)
        : mesh_(&mesh), executor_(executor_for(mesh, executor)) {
        bool ascends = true;
        bool triangles = true;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            ascends = ascends && mesh.first[f] <= mesh.first[f + 1];
            triangles = triangles && mesh.first[f + 1] - mesh.first[f] == 3;
        }
        if (!ascends) throw ContractViolation("mesh: the array `first` does not ascend");
        if (!mesh.first.empty() && (mesh.first.front() != 0 || mesh.first.back() != mesh.corners.size()))
            throw ContractViolation("mesh: the array `first` does not span all corners");
        has_triangles_only_ = triangles;
    }

    /// Looks at everything. Call once.
    [[nodiscard]] MeshReport run() {
        MeshReport report;
        report.point_count = mesh_->point_count();
        report.face_count = mesh_->face_count();
        bool is_complete = scan_points();
        if (is_complete) {
            bool indices_exist = true;
            executor_.invoke([&] { indices_exist = buckets_.gather(*mesh_); }, [&] { scan_faces(); });
            is_complete = indices_exist;
        }
        if (!is_complete) {
            check_points(*mesh_, report);
            check_indices(*mesh_, report);
            report.complete = false;
            return report;
        }
        if (buckets_.used_points().size() < mesh_->points.size()) check_indices(*mesh_, report);
        is_balanced_ = are_edges_balanced(buckets_, mesh_->points.size(), executor_);
        if (!is_balanced_) check_welded_edges(*mesh_, report);
        check_other_faces(report);
        return report;
    }

    /// Whether every face has three corners.
    [[nodiscard]] bool has_triangles_only() const noexcept { return has_triangles_only_; }

    /// Whether each edge cancels out against opposite ones with the mesh's own indices.
    [[nodiscard]] bool is_balanced() const noexcept { return is_balanced_; }

    /// The points that faces use, in the order of their first corners. Requires: a complete report.
    [[nodiscard]] std::span<const std::uint32_t> used_points() const noexcept { return buckets_.used_points(); }

    /// The sign of the enclosed volume, where doubles prove it. Requires: a closed mesh of triangles of doubles.
    ///
    /// Proof. Let M be the largest coordinate, u = 2^-53, F the number of faces. A component of a normal is at most
    /// 8 M^2, and off by 48 u M^2; a triangle's term is at most 24 M^3, and off by 216 u M^3 with the rounding of its
    /// own three products and two sums. n sums add n u times the magnitudes of all terms. The bound below is twice
    /// that; 2^-900 stands for what underflows. Whatever overflows stays infinite or NaN.
    [[nodiscard]] std::optional<Sign> volume_sign() const {
        const double faces = double(mesh_->face_count());
        const double sums = std::min(faces, double(face_grain)) + double(scans_.size());
        const double m = points_.magnitude;
        const double bound = 24 * faces * (m * m * m) * (16 + sums) * 0x1p-52 + 0x1p-900;
        double volume = 0;
        for (const FaceScan& scan : scans_) volume += scan.volume;
        if (filtering::always_fails || !std::isfinite(volume)) return std::nullopt;
        if (volume > bound) return Sign::plus;
        if (-volume > bound) return Sign::minus;
        return std::nullopt;
    }

private:
    static constexpr std::size_t face_grain = std::size_t(1) << 13U;
    static constexpr std::size_t other_grain = std::size_t(1) << 8U;  // larger faces are triangulated

    /// Returns: whether all are finite.
    [[nodiscard]] bool scan_points() {
        if constexpr (std::is_same_v<T, double>) {
            points_ = detail::scan_points(mesh_->points);
        } else if constexpr (std::is_floating_point_v<T>) {
            MeshReport report;
            check_points(*mesh_, report);
            points_.is_finite = report.points_not_finite.empty();
        }
        return points_.is_finite;
    }

    void scan_faces() {
        const std::size_t n = mesh_->face_count();
        scans_.resize(chunk_count(n, face_grain));
        for_each_chunk(executor_, n, face_grain, [&](std::size_t begin, std::size_t end, std::size_t c) {
            if constexpr (std::is_same_v<T, double>) {
                scans_[c] = detail::scan_faces(*mesh_, begin, end);
            } else {
                scans_[c].others.resize(end - begin);
                std::iota(scans_[c].others.begin(), scans_[c].others.end(), static_cast<std::uint32_t>(begin));
            }
        });
    }

    void check_other_faces(MeshReport& report) {
        std::vector<std::uint32_t> others;
        for (const FaceScan& scan : scans_) others.insert(others.end(), scan.others.begin(), scan.others.end());
        if (others.empty()) return;
        const FaceShapes<T> shapes(mesh_->points);
        std::vector<FaceDefects> defects(chunk_count(others.size(), other_grain));
        for_each_chunk(executor_, others.size(), other_grain, [&](std::size_t begin, std::size_t end, std::size_t c) {
            FaceShapes<T> own = shapes;
            defects[c] = check_faces(*mesh_, own, std::span(others).subspan(begin, end - begin));
        });
        const auto append = [](std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from) {
            to.insert(to.end(), from.begin(), from.end());
        };
        for (const FaceDefects& d : defects) {
            append(report.crossing_outlines, d.crossing);
            append(report.too_few_corners, d.few_corners);
            append(report.repeated_corners, d.repeated);
            append(report.zero_area_faces, d.no_area);
            append(report.non_planar_faces, d.not_planar);
        }
    }

    const PolygonMesh<T>* mesh_;
    ExecutorRef executor_;
    PointScan points_;
    EdgeBuckets buckets_;
    std::vector<FaceScan> scans_;
    bool has_triangles_only_ = false;
    bool is_balanced_ = false;
};

}  // namespace detail

/// Everything that is wrong with a mesh, or odd about it. Points that are not finite or corners that refer to no point
/// leave the other checks undone (`MeshReport::complete`).
/// Requires: `first` starts at 0, ascends, and ends at the number of corners (throws ContractViolation otherwise).
/// Cost: O(n) for n corners; some 25 ns a triangle of doubles without defects. Large meshes on several threads.
template <class T>
[[nodiscard]] MeshReport validate(const PolygonMesh<T>& mesh, ExecutorRef executor = {}) {
    return detail::MeshValidation<T>(mesh, executor).run();
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
