// SPDX-License-Identifier: Apache-2.0
/// Meshes from regions: closed, conforming triangles, with exact or correctly rounded coordinates.
#ifndef CLEAVE_MESH_FROM_REGION_HPP
#define CLEAVE_MESH_FROM_REGION_HPP

#include <cleave/base/error.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/triangulate.hpp>
#include <cleave/number/interval.hpp>
#include <cleave/region/build.hpp>
#include <cleave/region/conform.hpp>
#include <cleave/region/region.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
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

/// Predicates in the plane of one face, on the points of a boundary loaded at `first` into a kernel.
class FacePlane {
public:
    FacePlane(Kernel<3>& kernel, PointId first, PlaneId f) : kernel_(&kernel), first_(first) {
        const int drop = dominant_axis(kernel, unoriented(f));
        const Sign up = kernel.planes.exact(unoriented(f))[std::size_t(drop)].sign();
        const bool reversed = (up == Sign::minus) != is_flipped(f);
        u_ = (drop + 1) % 3;
        v_ = (drop + 2) % 3;
        if (reversed) std::swap(u_, v_);
    }

    /// The lexicographic order of the projected points.
    [[nodiscard]] bool less(PointId p, PointId q) const {
        if (p == q) return false;
        const Sign s = kernel_->compare(u_, first_ + p, first_ + q);
        return s != Sign::zero ? s == Sign::minus : kernel_->compare(v_, first_ + p, first_ + q) == Sign::minus;
    }

    /// The turn p, q, r as seen from outside.
    [[nodiscard]] Sign orient(PointId p, PointId q, PointId r) const {
        if (p == q || q == r || p == r) return Sign::zero;
        for (int attempt = 0; attempt < 2; ++attempt) {
            const std::optional<Sign> s = filtered(p, q, r);
            if (s) return *s;
            if (attempt == 0)
                for (const PointId x : {p, q, r}) kernel_->refine(first_ + x);
        }
        return exact(p, q, r);
    }

private:
    [[nodiscard]] Interval coordinate(PointId p, int axis) const {
        const auto& record = kernel_->point(first_ + p);
        const double x = record.approximation[std::size_t(axis)];
        return record.error == 0 ? Interval(x) : Interval(x) + Interval(-record.error, record.error);
    }

    [[nodiscard]] std::optional<Sign> filtered(PointId p, PointId q, PointId r) const {
        for (const PointId x : {p, q, r})
            if (!(kernel_->point(first_ + x).error < std::numeric_limits<double>::infinity())) return std::nullopt;
        const Interval a = coordinate(q, u_) - coordinate(p, u_);
        const Interval b = coordinate(r, v_) - coordinate(p, v_);
        const Interval c = coordinate(q, v_) - coordinate(p, v_);
        const Interval d = coordinate(r, u_) - coordinate(p, u_);
        return (a * b - c * d).sign();
    }

    [[nodiscard]] Sign exact(PointId p, PointId q, PointId r) const {
        const Homogeneous<3> a = kernel_->coordinates(first_ + p);
        const Homogeneous<3> b = kernel_->coordinates(first_ + q);
        const Homogeneous<3> c = kernel_->coordinates(first_ + r);
        const auto minor = [&](const Homogeneous<3>& x, const Homogeneous<3>& y, int i, int j) {
            WideInteger m(x[std::size_t(i)] * WideInteger(y[std::size_t(j)]));
            sub_product(m, x[std::size_t(j)], y[std::size_t(i)]);
            return m;
        };
        WideInteger det = minor(b, c, u_, v_) * WideInteger(a[3]);
        det -= minor(a, c, u_, v_) * WideInteger(b[3]);
        det += minor(a, b, u_, v_) * WideInteger(c[3]);
        return det.sign();
    }

    Kernel<3>* kernel_;
    PointId first_;
    int u_ = 0;
    int v_ = 1;
};

/// Conforming triangles of a region's boundary as indices of its points, with the source of each.
struct ConformingTriangles {
    std::vector<IndexTriangle> triangles;
    std::vector<Source> sources;
};

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
            const std::span<const PointId> loop = conformer.loop(l);
            corners.insert(corners.end(), loop.begin(), loop.end());
            first.push_back(static_cast<std::uint32_t>(corners.size()));
        }
        if (corners.size() == 3) {
            out.triangles.push_back({corners[0], corners[1], corners[2]});
        } else {
            const FacePlane plane(kernel, loaded.first_point, loaded.plane(face.plane));
            const bool done = triangulator.triangulate(
                corners, first,
                [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) { return plane.orient(p, q, r); },
                [&](std::uint32_t p, std::uint32_t q) { return plane.less(p, q); }, out.triangles);
            if (!done)
                throw Error("face " + std::to_string(&face - boundary.faces.faces.data()) +
                            " of the region has crossing edges: an operand intersected itself; check the operands");
        }
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
    const Boundary<3>& boundary = region.boundary();
    Kernel<3> kernel;
    const LoadedBoundary<3> loaded = load(boundary, kernel);
    ConformingTriangles conforming = triangulate_boundary(kernel, boundary, loaded);
    ExportedMesh<double> out;
    std::vector<std::array<double, 3>> points(boundary.points.size());
    for (PointId p = 0; p < points.size(); ++p) {
        kernel.refine(loaded.first_point + p);
        points[p] = kernel.point(loaded.first_point + p).approximation;
        for (double& x : points[p]) x += 0.0;  // one zero
        for (const double x : points[p])
            if (!std::isfinite(x)) throw NumberError("a coordinate of the result is beyond the range of doubles");
    }
    std::vector<PointId> order(points.size());
    for (PointId p = 0; p < order.size(); ++p) order[p] = p;
    std::sort(order.begin(), order.end(),
              [&](PointId p, PointId q) { return std::pair(points[p], p) < std::pair(points[q], q); });
    std::vector<PointId> same(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool repeats = i > 0 && points[order[i]] == points[order[i - 1]];
        same[order[i]] = repeats ? same[order[i - 1]] : order[i];
        out.rounding.points_merged += repeats ? 1U : 0U;
    }
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
