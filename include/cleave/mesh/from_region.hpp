// SPDX-License-Identifier: Apache-2.0
/// Meshes from regions: closed, conforming triangles, with exact or correctly rounded coordinates.
#ifndef CLEAVE_MESH_FROM_REGION_HPP
#define CLEAVE_MESH_FROM_REGION_HPP

#include <cleave/base/error.hpp>
#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/mesh/boundary_points.hpp>
#include <cleave/mesh/boundary_triangles.hpp>
#include <cleave/mesh/polygon_mesh.hpp>
#include <cleave/mesh/tabulate.hpp>
#include <cleave/mesh/triangulate.hpp>
#include <cleave/mesh/weld.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/region.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
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

/// Options of exports.
struct ToMeshOptions {
    ExecutorRef executor{};  ///< where independent work runs; the result is the same for every executor
};

namespace detail {

template <int D, class N>
void require_bounded(const Region<D, N>& region) {
    if (!region.is_bounded())
        throw UnboundedError("an unbounded region has no mesh; take its complement, or intersect it with a box");
}

/// The executor for work on a boundary: no other, where the work is done before another thread would have woken up.
[[nodiscard]] inline ExecutorRef executor_for(const Boundary<3>& boundary, ExecutorRef executor) {
    constexpr std::size_t few_faces = std::size_t(1) << 11U;
    return boundary.faces.faces.size() < few_faces ? ExecutorRef() : executor;
}

/// Drops triangles that lost a corner by rounding and pairs of opposite ones, so that directed edges stay balanced.
inline void drop_vanished(std::vector<PointId>& corners, std::vector<Source>& sources, RoundingReport& report) {
    struct Keyed {
        IndexTriangle sorted;
        bool odd;
        std::uint32_t index;
    };
    std::vector<Keyed> keyed;
    std::vector<bool> gone(sources.size(), false);
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        IndexTriangle t{corners[3 * std::size_t(i)], corners[3 * std::size_t(i) + 1], corners[3 * std::size_t(i) + 2]};
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
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (gone[i]) continue;
        std::copy_n(corners.begin() + std::ptrdiff_t(3 * i), 3, corners.begin() + std::ptrdiff_t(3 * kept));
        sources[kept++] = sources[i];
    }
    report.faces_vanished += sources.size() - kept;
    corners.resize(3 * kept);
    sources.resize(kept);
}

/// Makes a mesh of triangles given by points of a boundary, numbered in the order of their first corners; `point(p)` is
/// what comes of point p.
template <class Point>
auto number_points(std::vector<PointId> corners, std::size_t point_count, ExecutorRef executor, const Point& point) {
    using T = typename std::invoke_result_t<const Point&, PointId>::value_type;
    PolygonMesh<T> mesh;
    const std::size_t count = corners.size() / 3;
    const auto number = [&] {
        std::vector<std::uint32_t> id(point_count, no_id);
        std::vector<PointId> order(point_count + 1);  // what is not new is written to the place after the last one
        std::uint32_t used = 0;
        for (std::uint32_t& c : corners) {  // without a branch: which points are new nobody can predict
            const bool is_new = id[c] == no_id;
            order[used] = c;
            id[c] = is_new ? used : id[c];
            used += is_new ? 1U : 0U;
            c = id[c];
        }
        mesh.points = tabulate(executor, used, [&](std::size_t k) { return point(order[k]); });
    };
    executor.invoke(number, [&] {
        mesh.first = tabulate(count + 1, [](std::size_t f) { return static_cast<std::uint32_t>(3 * f); });
    });
    mesh.corners = std::move(corners);
    return mesh;
}

/// The correctly rounded points of a boundary. Most are what the boundary stores, and stay there.
class RoundedPoints {
public:
    /// Throws: NumberError where one is beyond the range of doubles.
    RoundedPoints(const Boundary<3>& boundary, ExecutorRef executor) : boundary_(&boundary) {
        constexpr std::size_t grain = std::size_t(1) << 12U;
        std::vector<Part> parts(chunk_count(boundary.points.size(), grain));
        for_each_chunk(executor, boundary.points.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t c) {
            std::optional<BoundaryPoints> points;
            for (std::size_t p = begin; p < end; ++p) {
                const PointRecord<3>& r = boundary.points[p];
                std::array<double, 3> x = r.approximation;
                if (!r.rounded) {
                    if (!points) points.emplace(boundary);
                    x = points->rounded(static_cast<PointId>(p));
                    parts[c].made.emplace_back(static_cast<PointId>(p), x);
                }
                if (r.error != 0 || !r.rounded) parts[c].inexact.push_back(static_cast<PointId>(p));
                parts[c].is_finite =
                    parts[c].is_finite && std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
            }
        });
        for (const Part& part : parts) {
            if (!part.is_finite) throw NumberError("a coordinate of the result is beyond the range of doubles");
            made_.insert(made_.end(), part.made.begin(), part.made.end());
            inexact_.insert(inexact_.end(), part.inexact.begin(), part.inexact.end());
        }
    }

    [[nodiscard]] std::size_t size() const noexcept { return boundary_->points.size(); }

    [[nodiscard]] std::array<double, 3> operator[](PointId p) const {
        const PointRecord<3>& r = boundary_->points[p];
        std::array<double, 3> x = r.approximation;
        if (!r.rounded)
            x = std::lower_bound(made_.begin(), made_.end(), p, [](const auto& m, PointId q) {
                    return m.first < q;
                })->second;
        for (double& c : x) c += 0.0;  // one zero
        return x;
    }

    /// True only where no two points round alike. Requires: no two points of the boundary are at one place.
    /// Cost: little where all but a few points are doubles, which cannot coincide with each other.
    [[nodiscard]] bool are_surely_distinct() const {
        if (inexact_.empty()) return true;
        const bool all = inexact_.size() > size() / 4;
        WeldMarks marks(all ? size() : 2 * inexact_.size());
        for (const PointId p : inexact_)
            if (!marks.insert(weld_hash((*this)[p]))) return false;
        auto next = inexact_.begin();
        for (PointId p = 0; p < size(); ++p) {
            if (next != inexact_.end() && *next == p) {
                ++next;
                continue;
            }
            if (marks.contains(weld_hash(boundary_->points[p].approximation))) return false;
        }
        return true;
    }

private:
    struct Part {
        std::vector<std::pair<PointId, std::array<double, 3>>> made;
        std::vector<PointId> inexact;
        bool is_finite = true;
    };

    const Boundary<3>* boundary_;
    std::vector<std::pair<PointId, std::array<double, 3>>> made_;  // of the points that are not stored rounded
    std::vector<PointId> inexact_;                                 // points that are not what they are rounded to
};

}  // namespace detail

/// The boundary as triangles with correctly rounded coordinates. The mesh is closed: points that round alike are one,
/// triangles that lose a corner go, and so do pairs of opposite ones. It has no T-junctions.
/// Requires: the region is bounded; throws UnboundedError otherwise. Empty gives a mesh without faces.
/// Cost: O(n log n); exact arithmetic only for constructed points.
template <class N>
[[nodiscard]] ExportedMesh<double> to_exported_mesh(const Region<3, N>& region, const ToMeshOptions& options = {}) {
    detail::require_bounded(region);
    const bool conforms = region.surface().is_conforming;
    const Boundary<3>& boundary = conforms ? region.surface() : region.boundary();
    const ExecutorRef executor = detail::executor_for(boundary, options.executor);
    ExportedMesh<double> out;
    ConformingTriangles conforming;
    std::optional<detail::RoundedPoints> points;
    bool are_distinct = false;
    executor.invoke(
        [&] {
            conforming =
                conforms ? triangulate_conforming(boundary, executor) : triangulate_boundary(boundary, executor);
        },
        [&] {
            points.emplace(boundary, executor);
            are_distinct = conforms && points->are_surely_distinct();
        });
    if (!are_distinct) {
        const auto count = static_cast<PointId>(points->size());
        const auto all = tabulate(count, [&](std::size_t p) { return (*points)[static_cast<PointId>(p)]; });
        const std::vector<std::uint32_t> same = first_equal_points<double>(all);
        for (PointId p = 0; p < count; ++p) out.rounding.points_merged += same[p] != p ? 1U : 0U;
        if (out.rounding.points_merged != 0) {
            for (PointId& p : conforming.corners) p = same[p];
            detail::drop_vanished(conforming.corners, conforming.sources, out.rounding);
        }
    }
    out.mesh = detail::number_points(std::move(conforming.corners), points->size(), executor,
                                     [&](PointId p) { return (*points)[p]; });
    out.sources = std::move(conforming.sources);
    return out;
}

/// The mesh of `to_exported_mesh` alone.
template <class N>
[[nodiscard]] Mesh to_mesh(const Region<3, N>& region, const ToMeshOptions& options = {}) {
    return to_exported_mesh(region, options).mesh;
}

/// The boundary as triangles with exact coordinates, conforming: no T-junctions, nothing rounded.
/// Requires: the region is bounded; throws UnboundedError otherwise.
template <class N>
[[nodiscard]] ExportedMesh<Rational> to_exported_rational_mesh(const Region<3, N>& region,
                                                               const ToMeshOptions& options = {}) {
    detail::require_bounded(region);
    const Boundary<3>& boundary = region.boundary();
    const ExecutorRef executor = detail::executor_for(boundary, options.executor);
    ConformingTriangles conforming = triangulate_boundary(boundary, executor);
    std::vector<std::array<Rational, 3>> points(boundary.points.size());
    constexpr std::size_t grain = std::size_t(1) << 10U;
    for_each_chunk(executor, points.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        BoundaryPoints exact(boundary);
        for (std::size_t p = begin; p < end; ++p) {
            const Homogeneous<3> x = exact.coordinates(static_cast<PointId>(p));
            for (std::size_t i = 0; i < 3; ++i) points[p][i] = number_traits<Rational>::from_fraction(x[i], x[3]);
        }
    });
    ExportedMesh<Rational> out;
    out.mesh = detail::number_points(std::move(conforming.corners), points.size(), executor,
                                     [&](PointId p) { return std::move(points[p]); });
    out.sources = std::move(conforming.sources);
    return out;
}

/// The mesh of `to_exported_rational_mesh` alone.
template <class N>
[[nodiscard]] RationalMesh to_rational_mesh(const Region<3, N>& region, const ToMeshOptions& options = {}) {
    return to_exported_rational_mesh(region, options).mesh;
}

CLEAVE_END_NAMESPACE

#endif
