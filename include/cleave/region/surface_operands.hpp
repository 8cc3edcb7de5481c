// SPDX-License-Identifier: Apache-2.0
/// The operands of a localised evaluation: boundaries as they are stored, of which only what other operands touch is
/// ever copied into a kernel.
#ifndef CLEAVE_REGION_SURFACE_OPERANDS_HPP
#define CLEAVE_REGION_SURFACE_OPERANDS_HPP

#include <cleave/geometry/double_plane.hpp>
#include <cleave/geometry/double_predicates.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/build.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Boundaries whose points, planes and neighbours are looked up by operand and index, and put into one kernel when they
/// are first asked for. Requires: all are finite and conforming; they outlive this object.
class SurfaceOperands {
public:
    explicit SurfaceOperands(std::span<const Boundary<3>* const> boundaries) : points_(kernel_) {
        operands_.resize(boundaries.size());
        for (std::size_t i = 0; i < boundaries.size(); ++i) {
            Operand& o = operands_[i];
            o.boundary = boundaries[i];
            o.first_vertex = vertex_count_;
            o.points.assign(o.boundary->points.size(), no_id);
            o.planes.assign(o.boundary->faces.faces.size(), no_id);
            vertex_count_ += o.points.size();
        }
    }

    [[nodiscard]] std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(operands_.size()); }
    [[nodiscard]] const Boundary<3>& boundary(std::uint32_t i) const { return *operands_[i].boundary; }
    [[nodiscard]] Kernel<3>& kernel() noexcept { return kernel_; }
    [[nodiscard]] PointInterner<3>& interner() noexcept { return points_; }

    /// Points of all operands, numbered through.
    [[nodiscard]] std::size_t vertex_count() const noexcept { return vertex_count_; }
    [[nodiscard]] std::uint32_t vertex(std::uint32_t i, PointId p) const {
        return static_cast<std::uint32_t>(operands_[i].first_vertex + p);
    }

    [[nodiscard]] const std::array<double, 3>& position(std::uint32_t i, PointId p) const {
        return operands_[i].boundary->points[p].approximation;
    }
    [[nodiscard]] bool is_of_doubles(std::uint32_t i, PointId p) const {
        return operands_[i].boundary->points[p].is_of_doubles();
    }

    /// The kernel's point for point p of operand i: the same for points at one place.
    PointId point(std::uint32_t i, PointId p) {
        PointId& known = operands_[i].points[p];
        if (known != no_id) return known;
        const Boundary<3>& b = boundary(i);
        PointRecord<3> r = b.points[p];
        const Homogeneous<3>* exact = r.exact == no_id ? nullptr : &b.exact[r.exact];
        if (r.kind == PointRecord<3>::Kind::meet) {
            for (std::uint32_t& k : r.planes) k = table_plane(i, k);
        } else {
            r.planes.fill(no_id);
        }
        known = points_(kernel_.add_record(r, exact));
        if (known >= origins_.size()) origins_.resize(std::size_t(known) + 1, no_id);
        if (origins_[known] == no_id) origins_[known] = vertex(i, p);
        return known;
    }

    /// The first vertex, numbered through, that became this point of the kernel; `no_id` for a common point.
    [[nodiscard]] std::uint32_t origin(PointId p) const { return p < origins_.size() ? origins_[p] : no_id; }

    /// The kernel's point, or `no_id` while nothing has asked for it.
    [[nodiscard]] PointId known_point(std::uint32_t i, PointId p) const { return operands_[i].points[p]; }

    /// The plane of face f of operand i in the kernel.
    PlaneId plane(std::uint32_t i, std::uint32_t f) {
        PlaneId& known = operands_[i].planes[f];
        if (known != no_id) return known;
        const Boundary<3>& b = boundary(i);
        const FaceList::Face& face = b.faces.faces[f];
        if (face.plane != no_id) return known = 2 * table_plane(i, unoriented(face.plane)) + (face.plane & 1U);
        const std::span<const Corner> c = b.faces.loop(face.first_loop);
        const auto& p = position(i, c[0].point);
        const auto& q = position(i, c[1].point);
        const auto& r = position(i, c[2].point);
        return known = intern_plane_through(kernel_.planes, p, q, r);
    }

    /// The side of face f's plane on which a point of some operand lies.
    Sign side(std::uint32_t i, std::uint32_t f, std::uint32_t j, PointId p) {
        const FaceList& list = boundary(i).faces;
        if (list.faces[f].plane != no_id || !is_of_doubles(j, p)) return kernel_.side(plane(i, f), point(j, p));
        const std::span<const Corner> c = list.corners_of(f);
        return plane_side(position(i, c[0].point), position(i, c[1].point), position(i, c[2].point), position(j, p));
    }

    // --- edges -------------------------------------------------------------------------------------------------------

    /// Makes neighbours known among these faces of operand i; the planes of edges between others are unknown.
    void connect(std::uint32_t i, std::span<const std::uint32_t> faces) {
        Operand& o = operands_[i];
        const FaceList& list = o.boundary->faces;
        o.uses.clear();
        o.first_twin.assign(faces.empty() ? 0 : list.faces.size(), no_id);
        std::uint32_t corners = 0;
        for (const std::uint32_t f : faces) {
            const FaceList::Face& face = list.faces[f];
            o.first_twin[f] = corners;
            corners += static_cast<std::uint32_t>(list.corners_of(f).size());
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                const std::uint32_t first = list.loop_first[l];
                const std::uint32_t last = list.loop_first[l + 1];
                for (std::uint32_t c = first; c < last; ++c)
                    if (list.corners[c].edge == no_id)
                        o.uses.push_back(
                            {ends(list.corners[c].point, list.corners[c + 1 == last ? first : c + 1].point), f, c});
            }
        }
        std::sort(o.uses.begin(), o.uses.end());
        o.twins.assign(corners, {});
        for (std::size_t n = 0; n + 1 < o.uses.size(); ++n) {
            const Use& a = o.uses[n];
            const Use& b = o.uses[n + 1];
            if (a.ends != b.ends || (n > 0 && o.uses[n - 1].ends == a.ends)) continue;
            if (n + 2 < o.uses.size() && o.uses[n + 2].ends == a.ends) continue;
            o.twins[o.twin_index(a)] = {b.face, b.corner, no_id, no_id};
            o.twins[o.twin_index(b)] = {a.face, a.corner, no_id, no_id};
        }
    }

    /// A name of the edge of face f that starts at corner c, which is the same for both faces at it; nullopt where they
    /// are not known, or more than two. Names of different edges differ.
    [[nodiscard]] std::optional<std::uint64_t> edge_name(std::uint32_t i, std::uint32_t f, std::uint32_t c) const {
        const Twin* const twin = operands_[i].twin({0, f, c});
        if (twin == nullptr || twin->corner == no_id) return std::nullopt;
        return (std::uint64_t(i) << 32U) | std::min(c, twin->corner);
    }

    /// A plane other than that of face f through the edge from a to b, which starts at corner c. Not oriented.
    std::uint32_t edge_plane(std::uint32_t i, std::uint32_t f, std::uint32_t c, PointId a, PointId b) {
        Operand& o = operands_[i];
        const PlaneId given = o.boundary->faces.corners[c].edge;
        if (given != no_id) return table_plane(i, unoriented(given));
        Twin* const twin = o.twin({0, f, c});
        if (twin == nullptr) return find_edge_plane(i, f, a, b, no_id);
        if (twin->plane == no_id) twin->plane = find_edge_plane(i, f, a, b, twin->face);
        return twin->plane;
    }

    /// The same with face f on its minus side. `off`: a corner of the face that is not on the edge's line, beside the
    /// edge on the face's side; `no_id` where none is known.
    PlaneId oriented_edge_plane(std::uint32_t i, std::uint32_t f, std::uint32_t c, PointId a, PointId b, PointId off) {
        Operand& o = operands_[i];
        const std::uint32_t k = edge_plane(i, f, c, a, b);
        if (const PlaneId given = o.boundary->faces.corners[c].edge; given != no_id) return 2 * k + (given & 1U);
        Twin* const twin = o.twin({0, f, c});
        if (twin != nullptr && twin->oriented != no_id) return twin->oriented;
        PlaneId h = 2 * k;
        if (off == no_id)
            h = orient_edge(kernel_, plane(i, f), h, point(i, a), point(i, b));
        else if (kernel_.side(h, point(i, off)) == Sign::plus)
            h = flipped(h);
        if (twin != nullptr) twin->oriented = h;
        return h;
    }

private:
    /// A face at an edge.
    struct Use {
        std::uint64_t ends;
        std::uint32_t face;
        std::uint32_t corner;

        friend bool operator<(const Use& a, const Use& b) {
            return a.ends != b.ends ? a.ends < b.ends : std::pair(a.face, a.corner) < std::pair(b.face, b.corner);
        }
    };

    /// The only other face at an edge, its corner where the edge starts, and planes of the edge once they were asked
    /// for.
    struct Twin {
        std::uint32_t face = no_id;
        std::uint32_t corner = no_id;
        std::uint32_t plane = no_id;
        PlaneId oriented = no_id;
    };

    struct Operand {
        const Boundary<3>* boundary = nullptr;
        std::size_t first_vertex = 0;
        std::vector<PointId> points;
        std::vector<PlaneId> planes;              // of faces
        std::vector<std::uint32_t> table_planes;  // of the boundary's table
        std::vector<Use> uses;                    // of edges without a plane of their own
        std::vector<Twin> twins;                  // for each corner of the connected faces
        std::vector<std::uint32_t> first_twin;    // of each face; `no_id` for those not connected

        [[nodiscard]] std::size_t twin_index(const Use& u) const {
            const FaceList& list = boundary->faces;
            return first_twin[u.face] + (u.corner - list.loop_first[list.faces[u.face].first_loop]);
        }
        /// nullptr where the face is not connected.
        [[nodiscard]] const Twin* twin(const Use& u) const {
            if (first_twin.empty() || first_twin[u.face] == no_id) return nullptr;
            return &twins[twin_index(u)];
        }
        [[nodiscard]] Twin* twin(const Use& u) { return const_cast<Twin*>(std::as_const(*this).twin(u)); }
    };

    /// A plane through an edge that has none of its own: that of another face there, `twin` if that is the only one.
    std::uint32_t find_edge_plane(std::uint32_t i, std::uint32_t f, PointId a, PointId b, std::uint32_t twin) {
        const std::uint32_t own = unoriented(plane(i, f));
        std::uint32_t best = no_id;
        const auto offer = [&](std::uint32_t face) {
            const std::uint32_t k = unoriented(plane(i, face));
            if (k != own && (best == no_id || k < best)) best = k;
        };
        if (twin != no_id) {
            offer(twin);
        } else {
            const Operand& o = operands_[i];
            const Use first{ends(a, b), 0, 0};
            for (auto u = std::lower_bound(o.uses.begin(), o.uses.end(), first);
                 u != o.uses.end() && u->ends == first.ends; ++u)
                offer(u->face);
        }
        return best != no_id ? best : unoriented(plane_across(kernel_, plane(i, f), point(i, a), point(i, b)));
    }

    static std::uint64_t ends(PointId a, PointId b) {
        return a < b ? (std::uint64_t(a) << 32U) | b : (std::uint64_t(b) << 32U) | a;
    }

    std::uint32_t table_plane(std::uint32_t i, std::uint32_t k) {
        Operand& o = operands_[i];
        if (o.table_planes.empty()) o.table_planes.assign(o.boundary->planes.size(), no_id);
        std::uint32_t& known = o.table_planes[k];
        if (known == no_id) known = kernel_.planes.intern_from(o.boundary->planes, k);
        return known;
    }

    Kernel<3> kernel_;
    PointInterner<3> points_;
    std::vector<Operand> operands_;
    std::vector<std::uint32_t> origins_;
    std::size_t vertex_count_ = 0;
};

CLEAVE_END_NAMESPACE

#endif
