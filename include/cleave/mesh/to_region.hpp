// SPDX-License-Identifier: Apache-2.0
/// Regions from meshes: validated, oriented, with planes interned and edges matched.
#ifndef CLEAVE_MESH_TO_REGION_HPP
#define CLEAVE_MESH_TO_REGION_HPP

#include <cleave/mesh/mesh_error.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/self_intersections.hpp>
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

    /// The boundary of a mesh of triangles of doubles, as it is: planes are made when something asks for them.
    /// Requires: edges match from end to end, and every triangle has an area.
    static Boundary<3> convert_triangles(const PolygonMesh<T>& mesh) requires(std::is_same_v<T, double>) {
        const std::vector<std::uint32_t> first_equal = first_equal_points<T>(mesh.points);
        Boundary<3> out;
        out.is_complete = false;
        out.is_conforming = true;
        std::vector<PointId> ids(mesh.points.size(), no_id);
        out.points.reserve(mesh.points.size());
        out.faces.faces.reserve(mesh.face_count());
        out.faces.loop_first.reserve(mesh.face_count() + 1);
        out.faces.corners.reserve(mesh.corners.size());
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
            std::array<Corner, 3> loop;
            for (std::size_t c = 0; c < 3; ++c) {
                PointId& p = ids[first_equal[mesh.corners[3 * std::size_t(f) + c]]];
                if (p == no_id) {
                    p = static_cast<PointId>(out.points.size());
                    PointRecord<3>& r = out.points.emplace_back();
                    r.approximation = mesh.points[mesh.corners[3 * std::size_t(f) + c]];
                    for (std::size_t x = 0; x < 3; ++x) {
                        r.approximation[x] += 0.0;  // one zero
                        out.bounds.lo[x] = std::min(out.bounds.lo[x], r.approximation[x]);
                        out.bounds.hi[x] = std::max(out.bounds.hi[x], r.approximation[x]);
                    }
                }
                loop[c] = {p, no_id};
            }
            out.faces.begin_face(no_id, {0, f});
            out.faces.add_loop(loop);
        }
        return out;
    }

    /// Whether `convert_triangles` may take the mesh.
    static bool is_plain(const PolygonMesh<T>& mesh, const MeshReport& report) {
        if (!std::is_same_v<T, double> || mesh.corners.size() != 3 * mesh.face_count()) return false;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            if (mesh.first[f + 1] - mesh.first[f] != 3) return false;
        return report.t_junctions.empty() && report.zero_area_faces.empty() && report.too_few_corners.empty();
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

/// The sign of the volume that a boundary encloses, by doubles with a bound, then exactly.
inline Sign enclosed_volume_sign(const Boundary<3>& boundary) {
    double sum = 0;
    double magnitude = 0;
    std::size_t terms = 0;
    const auto each = [&](auto&& term) {
        for (std::size_t l = 0; l + 1 < boundary.faces.loop_first.size(); ++l) {
            const std::span<const Corner> loop = boundary.faces.loop(l);
            for (std::size_t i = 1; i + 1 < loop.size(); ++i) term(loop[0].point, loop[i].point, loop[i + 1].point);
        }
    };
    bool exact_points = true;
    each([&](PointId p, PointId q, PointId r) {
        const auto& a = boundary.points[p].approximation;
        const auto& b = boundary.points[q].approximation;
        const auto& c = boundary.points[r].approximation;
        exact_points = exact_points && boundary.points[p].error == 0 && boundary.points[q].error == 0 &&
                       boundary.points[r].error == 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = b[(i + 1) % 3] * c[(i + 2) % 3];
            const double y = b[(i + 2) % 3] * c[(i + 1) % 3];
            sum += a[i] * (x - y);
            magnitude += std::abs(a[i]) * (std::abs(x) + std::abs(y));
        }
        terms += 3;
    });
    // n additions and three operations a term: relative error below (n + 4) u of the magnitudes; twice that is safe.
    const double bound = magnitude * (double(terms) + 8) * 0x1p-52 + 0x1p-900;
    if (exact_points && sum > bound) return Sign::plus;
    if (exact_points && -sum > bound) return Sign::minus;
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(boundary, kernel);
    std::vector<Rational> parts;
    each([&](PointId p, PointId q, PointId r) {
        const Homogeneous<3> a = kernel.coordinates(loaded.first_point + p);
        const Homogeneous<3> b = kernel.coordinates(loaded.first_point + q);
        const Homogeneous<3> c = kernel.coordinates(loaded.first_point + r);
        WideInteger det;
        for (std::size_t i = 0; i < 3; ++i) {
            WideInteger minor(b[(i + 1) % 3] * WideInteger(c[(i + 2) % 3]));
            sub_product(minor, b[(i + 2) % 3], c[(i + 1) % 3]);
            add_product(det, a[i], minor);
        }
        parts.push_back(number_traits<Rational>::from_fraction(Integer(det), Integer(WideInteger(a[3]) * b[3] * c[3])));
    });
    for (std::size_t n = parts.size(); n > 1; n = (n + 1) / 2)  // in pairs, so that denominators grow late
        for (std::size_t i = 0; i < n / 2; ++i) {
            Rational s = parts[i] + parts[n - 1 - i];
            parts[i] = s;
        }
    return parts.empty() ? Sign::zero : number_traits<Rational>::sign(parts.front());
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
    MeshReport report;
    if (options.validate) {
        report = validate(mesh);
        if (options.report != nullptr) *options.report = report;
        if (!report.is_valid(options.strictness))
            throw make_mesh_error(std::move(report), mesh, options.strictness, options.origin);
    }
    if (options.check_self_intersections) require_no_self_intersections(mesh, options.origin, options.progress);
    Boundary<3> boundary;
    bool converted = false;
    if constexpr (std::is_same_v<T, double>) {
        if (options.validate && detail::MeshConverter<T>::is_plain(mesh, report)) {
            boundary = detail::MeshConverter<T>::convert_triangles(mesh);
            converted = true;
        }
    }
    if (!converted) {
        boundary = detail::MeshConverter<T>(mesh).convert(report);
        boundary.is_conforming = options.validate && report.t_junctions.empty() && report.zero_area_faces.empty() &&
                                 report.too_few_corners.empty() && detail::has_simple_faces(boundary);
    }
    if (!boundary.faces.faces.empty()) {
        const std::string file =
            options.origin == nullptr || options.origin->file.empty() ? std::string() : options.origin->file + ": ";
        const Sign volume = detail::enclosed_volume_sign(boundary);
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
