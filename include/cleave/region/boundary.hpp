// SPDX-License-Identifier: Apache-2.0
/// The boundary of a region as it is stored: planes, points, and faces that refer to them by index. Immutable once
/// built, so regions share it.
#ifndef CLEAVE_REGION_BOUNDARY_HPP
#define CLEAVE_REGION_BOUNDARY_HPP

#include <cleave/base/large_vector.hpp>
#include <cleave/base/source.hpp>
#include <cleave/clip/kernel_clip.hpp>
#include <cleave/geometry/kernel.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Faces in the ids of some kernel. A face is a polygon set on one oriented plane, given by its loops, interior on the
/// left as seen from outside (outer loops and holes need no telling apart). D = 2: a loop is one segment, two corners.
/// D = 1: one corner, the end point of an interval.
struct FaceList {
    struct Face {
        PlaneId plane = no_id;
        std::uint32_t first_loop = 0;
        std::uint32_t loop_count = 0;
        Source source;
    };

    LargeVector<Face> faces;
    LargeVector<std::uint32_t> loop_first{0};  ///< loop l owns corners [loop_first[l], loop_first[l+1])
    LargeVector<Corner> corners;

    [[nodiscard]] std::span<const Corner> loop(std::size_t l) const {
        return {corners.data() + loop_first[l], loop_first[l + 1] - loop_first[l]};
    }

    /// The corners of all loops of face f.
    [[nodiscard]] std::span<const Corner> corners_of(std::size_t f) const {
        const Face& face = faces[f];
        const std::uint32_t first = loop_first[face.first_loop];
        return {corners.data() + first, loop_first[face.first_loop + face.loop_count] - first};
    }

    void begin_face(PlaneId plane, Source source) {
        faces.push_back({plane, static_cast<std::uint32_t>(loop_first.size() - 1), 0, source});
    }

    /// Adds a loop to the face begun last.
    void add_loop(std::span<const Corner> loop) {
        corners.insert(corners.end(), loop.begin(), loop.end());
        loop_first.push_back(static_cast<std::uint32_t>(corners.size()));
        ++faces.back().loop_count;
    }

    /// Adds a triangle without planes, as `Boundary::is_complete` allows them.
    void add_plain_triangle(PointId p, PointId q, PointId r, Source source) {
        faces.push_back({no_id, static_cast<std::uint32_t>(loop_first.size() - 1), 1, source});
        corners.push_back({p, no_id});
        corners.push_back({q, no_id});
        corners.push_back({r, no_id});
        loop_first.push_back(static_cast<std::uint32_t>(corners.size()));
    }
};

/// A boundary: the kernel data that its faces need, no more.
template <int D>
struct Boundary {
    PlaneTable<D> planes;
    LargeVector<PointRecord<D>> points;
    std::vector<Homogeneous<D>> exact;  ///< of the points whose record says so
    FaceList faces;
    Bounds<D> bounds;
    /// Whether the far point belongs to the set: where (t, t^2, ..., t^D) comes to stay as t grows. For a set that is
    /// bounded or has a bounded complement, whether it contains the points far away.
    bool value_at_infinity = false;
    bool is_finite = true;  ///< whether every point is finite: no face is unbounded
    /// Whether every face and edge names its plane. D = 3 may leave that to `complete` (region/complete.hpp): a face
    /// without a plane is a triangle of points of doubles, an edge without one an edge of some mesh between two such
    /// points, on the planes of the faces beside it.
    bool is_complete = true;
    /// D = 3: whether edges match their opposites from end to end, and no two points are at one place.
    bool is_conforming = false;

    /// Whether the set lies in some box.
    [[nodiscard]] bool is_bounded() const noexcept {
        // On the line the other infinity has the same value if the number of ends is even.
        return is_finite && !value_at_infinity && (D > 1 || faces.faces.size() % 2 == 0);
    }
};

/// Turns the loop of a facet round, as the same facet facing the other way has it. D = 3: edge planes stay with their
/// edges, (p_i, e_i) becomes (p_i, e_{i-1}) in reverse order. D >= 4: the order of incidences means nothing.
template <int D>
void reverse_loop(std::vector<Corner>& loop) {
    if constexpr (D <= 3) KernelClip<D>::reverse_corners(loop);
}

/// Collects the planes and points that `list` uses, renumbered in order of first use. `canonical` maps each kernel
/// point to the one that stands for all points at its place.
template <int D, class CanonicalPoint>
Boundary<D> freeze(Kernel<D>& kernel, const FaceList& list, bool value_at_infinity, CanonicalPoint&& canonical) {
    Boundary<D> out;
    out.value_at_infinity = value_at_infinity;
    std::vector<std::uint32_t> plane_map(kernel.planes.size(), no_id);
    std::vector<PointId> point_map(kernel.point_count(), no_id);
    const auto map_plane = [&](PlaneId h) -> PlaneId {
        if (h == no_id) return no_id;
        std::uint32_t& k = plane_map[unoriented(h)];
        if (k == no_id) k = out.planes.intern_from(kernel.planes, unoriented(h));
        return 2 * k + (h & 1U);
    };
    out.faces = list;
    for (FaceList::Face& face : out.faces.faces) face.plane = map_plane(face.plane);
    for (Corner& corner : out.faces.corners) {
        corner.edge = map_plane(corner.edge);
        const PointId p = canonical(corner.point);
        if (point_map[p] == no_id) {
            point_map[p] = static_cast<PointId>(out.points.size());
            if (!(kernel.point(p).error < std::numeric_limits<double>::infinity())) kernel.refine(p);
            PointRecord<D> r = kernel.point(p);
            out.bounds.include(r.approximation, r.error);
            for (std::uint32_t& k : r.planes)
                if (k != no_id) k = r.kind == PointRecord<D>::Kind::meet ? unoriented(map_plane(2 * k)) : plane_map[k];
            if (kernel.is_infinite(p)) {
                out.is_finite = false;
                r.exact = no_id;  // its planes say all
                r.rounded = false;
            }
            if (r.exact != no_id) {
                out.exact.push_back(kernel.exact(p));
                r.exact = static_cast<std::uint32_t>(out.exact.size() - 1);
            }
            out.points.push_back(r);
        }
        corner.point = point_map[p];
    }
    return out;
}

/// Where a boundary's planes and points went in a kernel.
template <int D>
struct LoadedBoundary {
    std::vector<std::uint32_t> planes;  ///< boundary's k to kernel's k
    PointId first_point = 0;            ///< the boundary's points follow in order

    [[nodiscard]] PlaneId plane(PlaneId h) const { return h == no_id ? no_id : 2 * planes[unoriented(h)] + (h & 1U); }
    [[nodiscard]] Corner corner(const Corner& c) const { return {first_point + c.point, plane(c.edge)}; }
};

/// Copies a boundary's planes and points into a kernel. Cost: linear, a hash look-up per plane.
template <int D>
LoadedBoundary<D> load(const Boundary<D>& boundary, Kernel<D>& kernel) {
    LoadedBoundary<D> out;
    out.planes.resize(boundary.planes.size());
    kernel.planes.reserve(kernel.planes.size() + boundary.planes.size());
    for (std::uint32_t k = 0; k < out.planes.size(); ++k) out.planes[k] = kernel.planes.intern_from(boundary.planes, k);
    out.first_point = static_cast<PointId>(kernel.point_count());
    kernel.reserve_points(kernel.point_count() + boundary.points.size());
    for (PointRecord<D> r : boundary.points) {
        for (std::uint32_t& k : r.planes)
            if (k != no_id) k = out.planes[k];
        const Homogeneous<D>* exact = r.exact == no_id ? nullptr : &boundary.exact[r.exact];
        kernel.add_record(r, exact);
    }
    return out;
}

CLEAVE_END_NAMESPACE

#endif
