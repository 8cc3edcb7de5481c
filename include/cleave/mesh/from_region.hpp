// SPDX-License-Identifier: Apache-2.0
/// Meshes from regions: closed, conforming triangles, with exact or correctly rounded coordinates.
#ifndef CLEAVE_MESH_FROM_REGION_HPP
#define CLEAVE_MESH_FROM_REGION_HPP

#include <cleave/base/error.hpp>
#include <cleave/geometry/kernel_turn.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/triangulate.hpp>
#include <cleave/mesh/weld.hpp>
#include <cleave/region/build.hpp>
#include <cleave/region/conform.hpp>
#include <cleave/region/region.hpp>
#include <cleave/region/surface_operands.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A region without a mesh: it is unbounded, so its boundary would be that of its complement.
class UnboundedError : public Error {
public:
    using Error::Error;
};

/// What rounding to doubles did.
struct RoundingReport {
    std::size_t points_merged = 0;    ///< points that round to the same doubles as another
    std::size_t faces_vanished = 0;   ///< triangles that lost a corner that way, or met their opposite
    std::size_t faces_flattened = 0;  ///< triangles whose rounded corners lie on a line
};

/// A mesh with the source of each of its faces.
template <class T>
struct ExportedMesh {
    PolygonMesh<T> mesh;
    std::vector<Source> sources;  ///< per face: the operand and face of the last operation that it came from
    RoundingReport rounding;
};

/// Predicates in the plane of one face, on points of a kernel.
class FacePlane {
public:
    FacePlane(Kernel<3>& kernel, PlaneId f) : kernel_(&kernel), projection_(projection_of(kernel, f)) {}

    /// The lexicographic order of the projected points.
    [[nodiscard]] bool less(PointId p, PointId q) const {
        if (p == q) return false;
        const Sign s = kernel_->compare(projection_.u, p, q);
        return s != Sign::zero ? s == Sign::minus : kernel_->compare(projection_.v, p, q) == Sign::minus;
    }

    /// The turn p, q, r as seen from outside.
    [[nodiscard]] Sign orient(PointId p, PointId q, PointId r) const { return turn(*kernel_, p, q, r, projection_); }

private:
    Kernel<3>* kernel_;
    Projection projection_;
};

/// Conforming triangles of a region's boundary as indices of its points, with the source of each.
struct ConformingTriangles {
    std::vector<IndexTriangle> triangles;
    std::vector<Source> sources;
};

namespace detail {

/// The triangles of one short loop by cutting ears that contain no other corner, not even on their edges. Returns:
/// whether that worked; it may not where the loop passes a point twice. Cost: cubic, but cheaper than a sweep for a few
/// corners.
inline bool cut_ears(const FacePlane& tests, std::span<const std::uint32_t> corners, std::vector<IndexTriangle>& out) {
    constexpr std::size_t most = 8;
    if (corners.size() > most) return false;
    std::array<std::uint32_t, most> rest{};
    std::copy(corners.begin(), corners.end(), rest.begin());
    std::size_t n = corners.size();
    const std::size_t before = out.size();
    const auto is_ear = [&](std::size_t i) {
        const std::uint32_t p = rest[(i + n - 1) % n];
        const std::uint32_t q = rest[i];
        const std::uint32_t r = rest[(i + 1) % n];
        if (tests.orient(p, q, r) != Sign::plus) return false;
        for (std::size_t k = 2; k + 1 < n; ++k) {
            const std::uint32_t x = rest[(i + k) % n];
            if (tests.orient(p, q, x) != Sign::minus && tests.orient(q, r, x) != Sign::minus &&
                tests.orient(r, p, x) != Sign::minus)
                return false;
        }
        return true;
    };
    for (; n > 3; --n) {
        std::size_t i = 0;
        while (i < n && !is_ear(i)) ++i;
        if (i == n) break;
        out.push_back({rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]});
        std::copy(rest.begin() + std::ptrdiff_t(i) + 1, rest.begin() + std::ptrdiff_t(n),
                  rest.begin() + std::ptrdiff_t(i));
    }
    if (n == 3 && tests.orient(rest[0], rest[1], rest[2]) == Sign::plus) {
        out.push_back({rest[0], rest[1], rest[2]});
        return true;
    }
    out.resize(before);
    return false;
}

/// The triangles of one face from its loops, given as kernel points; `number` is the face's, for the message.
inline void triangulate_face(Triangulator& triangulator, Kernel<3>& kernel, PlaneId plane,
                             std::span<const std::uint32_t> corners, std::span<const std::uint32_t> first,
                             std::size_t number, std::vector<IndexTriangle>& out) {
    const FacePlane tests(kernel, plane);
    if (first.size() == 2 && cut_ears(tests, corners, out)) return;
    const bool done = triangulator.triangulate(
        corners, first, [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) { return tests.orient(p, q, r); },
        [&](std::uint32_t p, std::uint32_t q) { return tests.less(p, q); }, out);
    if (!done)
        throw Error("face " + std::to_string(number) +
                    " of the region has crossing edges: an operand intersected itself; check the operands");
}

}  // namespace detail

/// Triangulates the faces of a loaded boundary so that they conform. Every vertex that lies on an edge is used.
inline ConformingTriangles triangulate_boundary(Kernel<3>& kernel, const Boundary<3>& boundary,
                                                const LoadedBoundary<3>& loaded) {
    Conformer conformer(kernel, boundary, loaded);
    Triangulator triangulator;
    ConformingTriangles out;
    out.triangles.reserve(boundary.faces.faces.size());
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> first;
    for (const FaceList::Face& face : boundary.faces.faces) {
        corners.clear();
        first.assign(1, 0);
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            for (const PointId p : conformer.loop(l)) corners.push_back(loaded.first_point + p);
            first.push_back(static_cast<std::uint32_t>(corners.size()));
        }
        const std::size_t begin = out.triangles.size();
        if (corners.size() == 3)
            out.triangles.push_back({corners[0], corners[1], corners[2]});
        else
            detail::triangulate_face(triangulator, kernel, loaded.plane(face.plane), corners, first,
                                     std::size_t(&face - boundary.faces.faces.data()), out.triangles);
        for (std::size_t t = begin; t < out.triangles.size(); ++t)
            for (std::uint32_t& p : out.triangles[t]) p -= loaded.first_point;
        out.sources.resize(out.triangles.size(), face.source);
    }
    return out;
}

/// The same for a boundary that conforms as it is: only faces that are not triangles go into a kernel.
inline ConformingTriangles triangulate_conforming(SurfaceOperands& operands) {
    const Boundary<3>& boundary = operands.boundary(0);
    Triangulator triangulator;
    ConformingTriangles out;
    out.triangles.reserve(boundary.faces.faces.size());
    out.sources.reserve(boundary.faces.faces.size());
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> first;
    for (const FaceList::Face& face : boundary.faces.faces) {
        if (face.loop_count == 1) {
            const std::span<const Corner> loop = boundary.faces.loop(face.first_loop);
            if (loop.size() == 3) {
                out.triangles.push_back({loop[0].point, loop[1].point, loop[2].point});
                out.sources.push_back(face.source);
                continue;
            }
        }
        corners.clear();
        first.assign(1, 0);
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            for (const Corner& c : boundary.faces.loop(l)) corners.push_back(operands.point(0, c.point));
            first.push_back(static_cast<std::uint32_t>(corners.size()));
        }
        const auto number = static_cast<std::uint32_t>(&face - boundary.faces.faces.data());
        const std::size_t begin = out.triangles.size();
        detail::triangulate_face(triangulator, operands.kernel(), operands.plane(0, number), corners, first, number,
                                 out.triangles);
        for (std::size_t t = begin; t < out.triangles.size(); ++t)
            for (std::uint32_t& p : out.triangles[t]) p = operands.origin(p);
        out.sources.resize(out.triangles.size(), face.source);
    }
    return out;
}

namespace detail {

template <int D, class N>
void require_bounded(const Region<D, N>& region) {
    if (!region.is_bounded())
        throw UnboundedError("an unbounded region has no mesh; take its complement, or intersect it with a box");
}

/// Drops triangles that lost a corner by rounding and pairs of opposite ones, so that directed edges stay balanced.
inline void drop_vanished(std::vector<IndexTriangle>& triangles, std::vector<Source>& sources, RoundingReport& report) {
    struct Keyed {
        IndexTriangle sorted;
        bool odd;
        std::uint32_t index;
    };
    std::vector<Keyed> keyed;
    std::vector<bool> gone(triangles.size(), false);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        IndexTriangle t = triangles[i];
        if (t[0] == t[1] || t[1] == t[2] || t[0] == t[2]) {
            gone[i] = true;
            continue;
        }
        bool odd = false;
        if (t[0] > t[1]) std::swap(t[0], t[1]), odd = !odd;
        if (t[1] > t[2]) std::swap(t[1], t[2]), odd = !odd;
        if (t[0] > t[1]) std::swap(t[0], t[1]), odd = !odd;
        keyed.push_back({t, odd, i});
    }
    std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) {
        return std::pair(a.sorted, a.index) < std::pair(b.sorted, b.index);
    });
    for (std::size_t i = 0; i < keyed.size();) {
        std::size_t j = i;
        std::vector<std::uint32_t> open[2];
        for (; j < keyed.size() && keyed[j].sorted == keyed[i].sorted; ++j) {
            auto& opposite = open[keyed[j].odd ? 0 : 1];
            if (opposite.empty()) {
                open[keyed[j].odd ? 1 : 0].push_back(keyed[j].index);
            } else {
                gone[opposite.back()] = gone[keyed[j].index] = true;
                opposite.pop_back();
            }
        }
        i = j;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (gone[i]) continue;
        triangles[kept] = triangles[i];
        sources[kept++] = sources[i];
    }
    report.faces_vanished += triangles.size() - kept;
    triangles.resize(kept);
    sources.resize(kept);
}

template <class T>
PolygonMesh<T> assemble(std::vector<std::array<T, 3>> points, const std::vector<IndexTriangle>& triangles) {
    PolygonMesh<T> mesh;
    std::vector<std::uint32_t> map(points.size(), no_id);
    mesh.corners.reserve(3 * triangles.size());
    mesh.first.reserve(triangles.size() + 1);
    for (const IndexTriangle& t : triangles) {
        for (const std::uint32_t p : t) {
            if (map[p] == no_id) {
                map[p] = static_cast<std::uint32_t>(mesh.points.size());
                mesh.points.push_back(std::move(points[p]));
            }
            mesh.corners.push_back(map[p]);
        }
        mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    return mesh;
}

}  // namespace detail

/// The boundary as triangles with correctly rounded coordinates. The mesh is closed: points that round alike are one,
/// triangles that lose a corner go, and so do pairs of opposite ones. It has no T-junctions.
/// Requires: the region is bounded; throws UnboundedError otherwise. Empty gives a mesh without faces.
/// Cost: O(n log n); exact arithmetic only for constructed points.
template <class N>
[[nodiscard]] ExportedMesh<double> to_exported_mesh(const Region<3, N>& region) {
    detail::require_bounded(region);
    ExportedMesh<double> out;
    ConformingTriangles conforming;
    std::vector<std::array<double, 3>> points;
    const auto round = [&](std::size_t count, auto&& rounded) {
        points.resize(count);
        for (PointId p = 0; p < count; ++p) {
            points[p] = rounded(p);
            for (double& x : points[p]) {
                x += 0.0;  // one zero
                if (!std::isfinite(x)) throw NumberError("a coordinate of the result is beyond the range of doubles");
            }
        }
    };
    if (region.surface().is_conforming) {
        const Boundary<3>* const boundary = &region.surface();
        SurfaceOperands operands({&boundary, 1});
        conforming = triangulate_conforming(operands);
        round(boundary->points.size(), [&](PointId p) {
            if (boundary->points[p].rounded) return boundary->points[p].approximation;
            const PointId q = operands.point(0, p);
            operands.kernel().refine(q);
            return operands.kernel().point(q).approximation;
        });
    } else {
        const Boundary<3>& boundary = region.boundary();
        Kernel<3> kernel;
        const LoadedBoundary<3> loaded = load(boundary, kernel);
        conforming = triangulate_boundary(kernel, boundary, loaded);
        round(boundary.points.size(), [&](PointId p) {
            kernel.refine(loaded.first_point + p);
            return kernel.point(loaded.first_point + p).approximation;
        });
    }
    const std::vector<std::uint32_t> same = first_equal_points<double>(points);
    for (std::uint32_t p = 0; p < same.size(); ++p) out.rounding.points_merged += same[p] != p ? 1U : 0U;
    if (out.rounding.points_merged != 0) {
        for (IndexTriangle& t : conforming.triangles)
            for (std::uint32_t& p : t) p = same[p];
        detail::drop_vanished(conforming.triangles, conforming.sources, out.rounding);
    }
    out.mesh = detail::assemble(std::move(points), conforming.triangles);
    out.sources = std::move(conforming.sources);
    return out;
}

/// The mesh of `to_exported_mesh` alone.
template <class N>
[[nodiscard]] Mesh to_mesh(const Region<3, N>& region) {
    return to_exported_mesh(region).mesh;
}

/// The boundary as triangles with exact coordinates, conforming: no T-junctions, nothing rounded.
/// Requires: the region is bounded; throws UnboundedError otherwise.
template <class N>
[[nodiscard]] ExportedMesh<Rational> to_exported_rational_mesh(const Region<3, N>& region) {
    detail::require_bounded(region);
    const Boundary<3>& boundary = region.boundary();
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(boundary, kernel);
    ConformingTriangles conforming = triangulate_boundary(kernel, boundary, loaded);
    std::vector<std::array<Rational, 3>> points(boundary.points.size());
    for (PointId p = 0; p < points.size(); ++p) {
        const Homogeneous<3> x = kernel.coordinates(loaded.first_point + p);
        for (std::size_t i = 0; i < 3; ++i) points[p][i] = number_traits<Rational>::from_fraction(x[i], x[3]);
    }
    ExportedMesh<Rational> out;
    out.mesh = detail::assemble(std::move(points), conforming.triangles);
    out.sources = std::move(conforming.sources);
    return out;
}

/// The mesh of `to_exported_rational_mesh` alone.
template <class N>
[[nodiscard]] RationalMesh to_rational_mesh(const Region<3, N>& region) {
    return to_exported_rational_mesh(region).mesh;
}

CLEAVE_END_NAMESPACE

#endif
