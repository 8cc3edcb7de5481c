// SPDX-License-Identifier: Apache-2.0
/// Boundaries from points: end points of intervals, oriented segments, oriented polygons.
#ifndef CLEAVE_REGION_BUILD_HPP
#define CLEAVE_REGION_BUILD_HPP

#include <cleave/geometry/double_plane.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A direction along axis i, as a homogeneous point of weight zero.
template <int D>
[[nodiscard]] Homogeneous<D> axis_direction(int axis) {
    Homogeneous<D> h;
    h[std::size_t(axis)] = Integer(1);
    return h;
}

/// The plane through three points of doubles, the plus side where they are counter-clockwise. Requires: they are not on
/// one line.
inline PlaneId intern_plane_through(PlaneTable<3>& planes, const std::array<double, 3>& p,
                                    const std::array<double, 3>& q, const std::array<double, 3>& r) {
    if (std::optional<PrimitivePlane> h = small_plane_through(p, q, r))
        return 2 * planes.intern_primitive(std::move(h->coefficients)) + (h->is_flipped ? 1U : 0U);
    return planes.intern(plane_through(p, q, r));
}

/// The plane through the edge from u to v of a face on plane f and the coordinate direction most across the face; the
/// face is on its minus side. For edges with no other plane that would do.
inline PlaneId plane_across(Kernel<3>& kernel, PlaneId f, PointId u, PointId v) {
    const int axis = dominant_axis(kernel, unoriented(f));
    const auto x = std::size_t(axis);
    if (kernel.point(u).is_of_doubles() && kernel.point(v).is_of_doubles()) {
        const std::array<double, 3>& p = kernel.point(u).approximation;
        std::array<double, 3> r = p;
        r[x] = p[x] == 0 ? 1 : 0;
        const PlaneId plane = intern_plane_through(kernel.planes, p, kernel.point(v).approximation, r);
        // Its normal m is (v - u) x (r - u), and the face's own n lies across the edge: m . (n x (v - u)), what the
        // face is beside, has the sign of -n . (r - u).
        const bool same_way =
            (r[x] > p[x]) == ((kernel.planes.exact(unoriented(f))[x].sign() == Sign::plus) != is_flipped(f));
        return same_way ? plane : flipped(plane);
    }
    const std::optional<PlaneId> plane = kernel.join(
        std::array<Homogeneous<3>, 3>{kernel.coordinates(u), kernel.coordinates(v), axis_direction<3>(axis)});
    CLEAVE_ASSERT(plane.has_value());
    return orient_edge(kernel, f, *plane, u, v);
}

/// Builds the boundary of a polyhedron from polygons over a kernel's points. Every edge plane is that of a neighbour
/// that is not coplanar, or else the plane through the edge and the coordinate direction most across the face: never a
/// coplanar neighbour's, which would lose the vertices on that edge.
class PolyhedronBuilder {
public:
    explicit PolyhedronBuilder(Kernel<3>& kernel) : kernel_(&kernel) {}

    void reserve(std::size_t faces, std::size_t corners) {
        faces_.reserve(faces);
        edges_.reserve(corners);
    }

    /// Adds a planar polygon with its oriented plane. Requires: points are representatives, the polygon is simple.
    void add(PlaneId plane, std::span<const PointId> polygon, Source source) {
        const auto face = static_cast<std::uint32_t>(faces_.size());
        faces_.push_back({plane, static_cast<std::uint32_t>(edges_.size()), source});
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const PointId a = polygon[i];
            edges_.push_back({a, polygon[i + 1 == polygon.size() ? 0 : i + 1], face});
            kernel_->note_incidence(a, unoriented(plane));
        }
    }

    /// The list of faces with edge planes. Cost: a sort of the edges.
    [[nodiscard]] FaceList finish() {
        std::vector<std::uint32_t> order(edges_.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        const auto key = [&](std::uint32_t i) {
            const std::pair<PointId, PointId> ends = std::minmax(edges_[i].from, edges_[i].to);
            return (std::uint64_t(ends.first) << 32U) | ends.second;
        };
        std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted(edges_.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) sorted[i] = {key(i), i};
        std::sort(sorted.begin(), sorted.end());
        std::vector<PlaneId> planes(edges_.size(), no_id);
        for (std::size_t i = 0; i < sorted.size();) {
            std::size_t j = i;
            while (j < sorted.size() && sorted[j].first == sorted[i].first) ++j;
            for (std::size_t e = i; e < j; ++e)
                planes[sorted[e].second] = edge_plane(sorted[e].second, {sorted.data() + i, j - i});
            i = j;
        }
        FaceList out;
        std::vector<Corner> loop;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            const std::size_t end = f + 1 == faces_.size() ? edges_.size() : faces_[f + 1].first_edge;
            loop.clear();
            for (std::size_t e = faces_[f].first_edge; e < end; ++e) loop.push_back({edges_[e].from, planes[e]});
            out.begin_face(faces_[f].plane, faces_[f].source);
            out.add_loop(loop);
        }
        return out;
    }

private:
    struct Face {
        PlaneId plane;
        std::uint32_t first_edge;
        Source source;
    };
    struct Edge {
        PointId from;
        PointId to;
        std::uint32_t face;
    };

    PlaneId edge_plane(std::uint32_t e, std::span<const std::pair<std::uint64_t, std::uint32_t>> same) {
        const Edge& edge = edges_[e];
        const PlaneId own = faces_[edge.face].plane;
        std::uint32_t neighbour = no_id;
        for (const auto& [key, other] : same) {
            (void)key;
            const std::uint32_t k = unoriented(faces_[edges_[other].face].plane);
            if (k != unoriented(own)) neighbour = std::min(neighbour, k);
        }
        if (neighbour != no_id) return orient_edge(*kernel_, own, 2 * neighbour, edge.from, edge.to);
        return plane_across(*kernel_, own, edge.from, edge.to);
    }

    Kernel<3>* kernel_;
    std::vector<Face> faces_;
    std::vector<Edge> edges_;
};

/// Builds the boundary of a polygon set from oriented segments, the set on their left.
class PolygonBuilder {
public:
    explicit PolygonBuilder(Kernel<2>& kernel) : kernel_(&kernel) {}

    /// Requires: the ends are different representatives.
    void add(PointId from, PointId to, Source source) {
        const std::array<PointId, 2> ends{from, to};
        const std::optional<PlaneId> plane = kernel_->join(std::span<const PointId, 2>(ends));
        CLEAVE_REQUIRES(plane.has_value());
        segments_.push_back({from, to, *plane, source});
        kernel_->note_incidence(from, unoriented(*plane));
        kernel_->note_incidence(to, unoriented(*plane));
    }

    [[nodiscard]] FaceList finish() {
        std::vector<std::pair<PointId, std::uint32_t>> at;
        for (std::uint32_t i = 0; i < segments_.size(); ++i) {
            at.push_back({segments_[i].from, unoriented(segments_[i].plane)});
            at.push_back({segments_[i].to, unoriented(segments_[i].plane)});
        }
        std::sort(at.begin(), at.end());
        FaceList out;
        for (const Segment& s : segments_) {
            const Corner loop[2] = {{s.from, end_plane(at, s, s.from, s.to)}, {s.to, end_plane(at, s, s.to, s.from)}};
            out.begin_face(s.plane, s.source);
            out.add_loop(loop);
        }
        return out;
    }

private:
    struct Segment {
        PointId from;
        PointId to;
        PlaneId plane;
        Source source;
    };

    /// A line through `end` other than the segment's, `other` on its minus side: a neighbour's, or an axis-parallel
    /// one.
    PlaneId end_plane(const std::vector<std::pair<PointId, std::uint32_t>>& at, const Segment& s, PointId end,
                      PointId other) {
        PlaneId plane = no_id;
        for (auto i = std::lower_bound(at.begin(), at.end(), std::pair(end, 0U)); i != at.end() && i->first == end; ++i)
            if (i->second != unoriented(s.plane)) {
                plane = 2 * i->second;
                break;
            }
        if (plane == no_id) {
            const int across = dominant_axis(*kernel_, unoriented(s.plane));
            plane = kernel_->join(std::array<Homogeneous<2>, 2>{kernel_->coordinates(end), axis_direction<2>(across)})
                        .value();
        }
        return kernel_->side(plane, other) == Sign::minus ? plane : flipped(plane);
    }

    Kernel<2>* kernel_;
    std::vector<Segment> segments_;
};

CLEAVE_END_NAMESPACE

#endif
