// SPDX-License-Identifier: Apache-2.0
/// Regions from meshes: validated, oriented, with planes interned and edges matched.
#ifndef CLEAVE_MESH_TO_REGION_HPP
#define CLEAVE_MESH_TO_REGION_HPP

#include <cleave/execution/executor_ref.hpp>
#include <cleave/mesh/mesh_error.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/self_intersections.hpp>
#include <cleave/mesh/triangle_boundary.hpp>
#include <cleave/mesh/validate.hpp>
#include <cleave/mesh/weld.hpp>
#include <cleave/region/make.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Options of `to_region`.
struct ToRegionOptions {
    Strictness strictness = Strictness::tolerant;
    const MeshOrigin* origin = nullptr;  ///< for messages that name file and line
    MeshReport* report = nullptr;        ///< receives what validation found, errors or not
    /// Whether to validate. Without it the mesh must be closed, oriented and free of non-planar faces.
    bool validate = true;
    /// Whether to refuse a mesh whose faces cross or overlap each other. Costs some 3 microseconds a triangle; without
    /// it, what comes of such a mesh is closed but otherwise unspecified.
    bool check_self_intersections = false;
    ProgressReporter* progress = nullptr;  ///< told about that check; may cancel, which throws Cancelled
    ExecutorRef executor{};                ///< where independent work runs; the result is the same for every executor
};

namespace detail {

/// Turns one mesh into a boundary.
template <class T>
class MeshConverter {
public:
    explicit MeshConverter(const PolygonMesh<T>& mesh) : mesh_(&mesh), points_(kernel_), builder_(kernel_) {}

    Boundary<3> convert(const MeshReport& report) {
        ids_.reserve(mesh_->points.size());
        kernel_.reserve_points(mesh_->points.size());
        kernel_.planes.reserve(mesh_->face_count());
        builder_.reserve(mesh_->face_count(), mesh_->corners.size());
        for (const auto& x : mesh_->points) ids_.push_back(points_(add_point<T, 3>(kernel_, x)));
        auto non_planar = report.non_planar_faces.begin();
        for (std::uint32_t f = 0; f < mesh_->face_count(); ++f) {
            const bool split = non_planar != report.non_planar_faces.end() && *non_planar == f;
            if (split) ++non_planar;
            read_polygon(f);
            if (polygon_.size() < 3) continue;
            if (polygon_.size() == 3)
                add_triangle({polygon_[0], polygon_[1], polygon_[2]}, f);
            else if (split)
                add_fan(f);
            else
                add_polygon(f);
        }
        return freeze(kernel_, builder_.finish(), false, points_);
    }

    Kernel<3>& kernel() { return kernel_; }

private:
    /// The distinct corners of face f in order.
    void read_polygon(std::uint32_t f) {
        polygon_.clear();
        for (const std::uint32_t corner : mesh_->face(f)) {
            const PointId p = ids_[corner];
            if (polygon_.empty() || polygon_.back() != p) polygon_.push_back(p);
        }
        while (polygon_.size() > 1 && polygon_.front() == polygon_.back()) polygon_.pop_back();
    }

    void add_triangle(const std::array<PointId, 3>& t, std::uint32_t f) {
        if (const std::optional<PlaneId> plane = kernel_.join(std::span<const PointId, 3>(t)))
            builder_.add(*plane, t, {0, f});
    }

    /// The fan from the corner with the lowest index: the same triangles whatever corner the file starts with.
    void add_fan(std::uint32_t f) {
        std::rotate(polygon_.begin(), std::min_element(polygon_.begin(), polygon_.end()), polygon_.end());
        for (std::size_t i = 1; i + 1 < polygon_.size(); ++i)
            add_triangle({polygon_[0], polygon_[i], polygon_[i + 1]}, f);
    }

    /// A planar polygon, convex or not: its plane is that of any corner triple not on a line, oriented by its area.
    void add_polygon(std::uint32_t f) {
        std::optional<PlaneId> plane;
        for (std::size_t i = 1; i + 1 < polygon_.size() && !plane; ++i)
            plane = kernel_.join(std::array<PointId, 3>{polygon_[0], polygon_[i], polygon_[i + 1]});
        for (std::size_t i = 2; i + 1 < polygon_.size() && !plane; ++i)
            plane = kernel_.join(std::array<PointId, 3>{polygon_[1], polygon_[i], polygon_[i + 1]});
        if (!plane) return;  // no area
        const int drop = dominant_axis(kernel_, unoriented(*plane));
        Sign area = projected_area(drop);
        if (area == Sign::zero) return;
        Sign normal = kernel_.planes.exact(unoriented(*plane))[std::size_t(drop)].sign();
        if (is_flipped(*plane)) normal = -normal;
        builder_.add(area == normal ? *plane : flipped(*plane), polygon_, {0, f});
    }

    /// The sign of twice the polygon's area, projected along axis `drop`.
    Sign projected_area(int drop) {
        const auto u = std::size_t((drop + 1) % 3);
        const auto v = std::size_t((drop + 2) % 3);
        Rational sum(0);
        for (std::size_t i = 0; i < polygon_.size(); ++i) {
            const Homogeneous<3> a = kernel_.coordinates(polygon_[i]);
            const Homogeneous<3> b = kernel_.coordinates(polygon_[i + 1 == polygon_.size() ? 0 : i + 1]);
            sum += number_traits<Rational>::from_fraction(Integer(a[u] * b[v] - a[v] * b[u]), Integer(a[3] * b[3]));
        }
        return number_traits<Rational>::sign(sum);
    }

    const PolygonMesh<T>* mesh_;
    Kernel<3> kernel_;
    PointInterner<3> points_;
    PolyhedronBuilder builder_;
    std::vector<PointId> ids_, polygon_;
};

/// Whether no face passes a point twice.
inline bool has_simple_faces(const Boundary<3>& boundary) {
    std::vector<PointId> points;
    for (std::size_t l = 0; l + 1 < boundary.faces.loop_first.size(); ++l) {
        points.clear();
        for (const Corner& c : boundary.faces.loop(l)) points.push_back(c.point);
        std::sort(points.begin(), points.end());
        if (std::adjacent_find(points.begin(), points.end()) != points.end()) return false;
    }
    return true;
}

}  // namespace detail

/// The solid that a closed, outward-oriented mesh bounds. Coordinates are taken exactly as they are. Every face keeps
/// its corners; sources count faces. Faces without area are left out and non-planar ones split into triangles, unless
/// strict. A mesh without faces gives the empty set.
/// Requires: the mesh does not intersect itself (checked on request; `resolve` takes meshes that do).
/// Throws: MeshError with all defects (open, misoriented or unbalanced edges, bad indices, ...); SelfIntersectionError
/// for faces that cross or overlap, if asked for; ShapeError for a mesh turned inside out.
/// Cost: O(n log n); one exact plane per face.
template <class N = Rational, class T>
[[nodiscard]] Region<3, N> to_region(const PolygonMesh<T>& mesh, const ToRegionOptions& options = {}) {
    Boundary<3> boundary;
    std::optional<Sign> volume;
    if (options.validate) {
        const ExecutorRef executor = detail::executor_for(mesh, options.executor);
        detail::MeshValidation<T> validation(mesh, executor);
        MeshReport report;
        bool are_distinct = false;
        executor.invoke([&] { report = validation.run(); },
                        [&] {
                            if constexpr (std::is_same_v<T, double>)
                                are_distinct =
                                    validation.has_triangles_only() && are_surely_distinct<double>(mesh.points);
                        });
        if (options.report != nullptr) *options.report = report;
        if (!report.is_valid(options.strictness))
            throw make_mesh_error(std::move(report), mesh, options.strictness, options.origin);
        if (options.check_self_intersections) require_no_self_intersections(mesh, options.origin, options.progress);
        const bool conforms =
            report.t_junctions.empty() && report.zero_area_faces.empty() && report.too_few_corners.empty();
        bool is_made = false;
        if constexpr (std::is_same_v<T, double>) {
            if (conforms && validation.has_triangles_only()) {
                boundary = validation.is_balanced() && are_distinct
                               ? detail::triangle_boundary(mesh, validation.used_points(), executor)
                               : detail::welded_triangle_boundary(mesh, executor);
                volume = validation.volume_sign();
                is_made = true;
            }
        }
        if (!is_made) {
            boundary = detail::MeshConverter<T>(mesh).convert(report);
            boundary.is_conforming = conforms && detail::has_simple_faces(boundary);
        }
    } else {
        if (options.check_self_intersections) require_no_self_intersections(mesh, options.origin, options.progress);
        boundary = detail::MeshConverter<T>(mesh).convert({});
    }
    if (!boundary.faces.faces.empty()) {
        const std::string file =
            options.origin == nullptr || options.origin->file.empty() ? std::string() : options.origin->file + ": ";
        if (!volume) volume = detail::enclosed_volume_sign(boundary);
        if (volume == Sign::minus)
            throw ShapeError(file +
                             "the mesh is inside out (its volume is negative): reverse the order of the corners " +
                             "in every face");
        if (volume == Sign::zero) throw ShapeError(file + "the mesh encloses no volume");
    }
    return Region<3, N>(std::move(boundary));
}

CLEAVE_END_NAMESPACE

#endif
