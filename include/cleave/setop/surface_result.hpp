// SPDX-License-Identifier: Apache-2.0
/// The boundary that a localised evaluation puts together: faces that pass by index, and new ones in the kernel's ids.
#ifndef CLEAVE_SETOP_SURFACE_RESULT_HPP
#define CLEAVE_SETOP_SURFACE_RESULT_HPP

#include <cleave/region/surface_operands.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Collects faces and, in order of first use, the points and planes that they need.
class SurfaceResult {
public:
    explicit SurfaceResult(SurfaceOperands& operands)
        : operands_(&operands), vertices_(operands.vertex_count(), no_id), tables_(operands.count()) {
        for (std::uint32_t i = 0; i < operands.count(); ++i)
            tables_[i].assign(operands.boundary(i).planes.size(), no_id);
        out_.is_complete = false;
        out_.is_conforming = true;
        std::size_t faces = 0;
        for (std::uint32_t i = 0; i < operands.count(); ++i) faces += operands.boundary(i).faces.faces.size();
        out_.points.reserve(vertices_.size());
        out_.faces.faces.reserve(faces);
        out_.faces.loop_first.reserve(faces + 1);
        out_.faces.corners.reserve(3 * faces);
    }

    /// Face f of operand i as it is, or turned round.
    void add_copy(std::uint32_t i, std::uint32_t f, bool flip) {
        const Boundary<3>& b = operands_->boundary(i);
        const FaceList::Face& face = b.faces.faces[f];
        if (face.plane == no_id) {
            const Corner* c = b.faces.corners.data() + b.faces.loop_first[face.first_loop];
            const PointId p = vertex(i, c[0].point);
            const PointId q = vertex(i, c[1].point);
            const PointId r = vertex(i, c[2].point);
            out_.faces.add_plain_triangle(p, flip ? r : q, flip ? q : r, {i, f});
            return;
        }
        const PlaneId plane = table_plane(i, face.plane);
        out_.faces.begin_face(flip && plane != no_id ? flipped(plane) : plane, {i, f});
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            loop_.clear();
            for (const Corner& c : b.faces.loop(l))
                loop_.push_back({vertex(i, c.point), c.edge == no_id ? no_id : table_plane(i, c.edge)});
            if (flip) reverse_loop<3>(loop_);
            out_.faces.add_loop(loop_);
        }
    }

    /// The same for faces first ... last - 1.
    void add_copies(std::uint32_t i, std::uint32_t first, std::uint32_t last, bool flip) {
        const FaceList& list = operands_->boundary(i).faces;
        std::uint32_t f = first;
        while (f < last) {
            std::uint32_t end = f;
            while (end < last && list.faces[end].plane == no_id) ++end;
            add_triangles(i, f, end, flip);
            for (f = end; f < last && list.faces[f].plane != no_id; ++f) add_copy(i, f, flip);
        }
    }

    /// Faces with points and planes of the kernel; edges of input meshes may lack theirs.
    void add_faces(const FaceList& list) {
        for (const FaceList::Face& face : list.faces) {
            out_.faces.begin_face(kernel_plane(face.plane), face.source);
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                loop_.clear();
                for (const Corner& c : list.loop(l))
                    loop_.push_back({kernel_point(c.point), c.edge == no_id ? no_id : kernel_plane(c.edge)});
                out_.faces.add_loop(loop_);
            }
        }
    }

    [[nodiscard]] Boundary<3> finish(bool value_at_infinity) {
        out_.value_at_infinity = value_at_infinity;
        return std::move(out_);
    }

private:
    /// Faces first ... last - 1. Requires: none has a plane.
    void add_triangles(std::uint32_t i, std::uint32_t first, std::uint32_t last, bool flip) {
        const FaceList& list = operands_->boundary(i).faces;
        FaceList& out = out_.faces;
        const std::size_t count = last - first;
        std::size_t c = out.corners.size();
        std::size_t n = out.faces.size();
        std::size_t l = out.loop_first.size();
        out.corners.resize(c + 3 * count);
        out.faces.resize(n + count);
        out.loop_first.resize(l + count);
        for (std::uint32_t f = first; f < last; ++f, c += 3, ++n, ++l) {
            const Corner* const from = list.corners.data() + list.loop_first[list.faces[f].first_loop];
            Corner* const to = out.corners.data() + c;
            to[0] = {vertex(i, from[0].point), no_id};
            to[flip ? 2 : 1] = {vertex(i, from[1].point), no_id};
            to[flip ? 1 : 2] = {vertex(i, from[2].point), no_id};
            out.faces[n] = {no_id, static_cast<std::uint32_t>(l - 1), 1, {i, f}};
            out.loop_first[l] = static_cast<std::uint32_t>(c + 3);
        }
    }

    PointId vertex(std::uint32_t i, PointId p) {
        PointId& at = vertices_[operands_->vertex(i, p)];
        if (at != no_id) return at;
        const PointId known = operands_->known_point(i, p);
        return at = known != no_id ? kernel_point(known) : add_vertex(i, p);
    }

    PointId add_vertex(std::uint32_t i, PointId p) {
        const Boundary<3>& b = operands_->boundary(i);
        PointRecord<3> r = b.points[p];
        if (r.kind == PointRecord<3>::Kind::meet) {
            for (std::uint32_t& k : r.planes) k = unoriented(table_plane(i, 2 * k));
        } else {
            r.planes.fill(no_id);
        }
        return add(r, r.exact == no_id ? nullptr : &b.exact[r.exact]);
    }

    PointId kernel_point(PointId p) {
        if (const std::uint32_t origin = operands_->origin(p); origin != no_id) {
            PointId& at = vertices_[origin];
            if (at == no_id) at = add_kernel_point(p);
            return at;
        }
        if (p >= points_.size()) points_.resize(operands_->kernel().point_count(), no_id);
        if (points_[p] == no_id) points_[p] = add_kernel_point(p);
        return points_[p];
    }

    PointId add_kernel_point(PointId p) {
        Kernel<3>& kernel = operands_->kernel();
        if (!(kernel.point(p).error < std::numeric_limits<double>::infinity())) kernel.refine(p);
        PointRecord<3> r = kernel.point(p);
        if (r.kind == PointRecord<3>::Kind::meet) {
            for (std::uint32_t& k : r.planes) k = unoriented(kernel_plane(2 * k));
        } else {
            r.planes.fill(no_id);
        }
        return add(r, r.exact == no_id ? nullptr : &kernel.exact(p));
    }

    PointId add(PointRecord<3>& r, const Homogeneous<3>* exact) {
        out_.bounds.include(r.approximation, r.error);
        // A meet's exact coordinates are made again if they are needed; its rounded ones stay.
        if (exact != nullptr && r.kind == PointRecord<3>::Kind::integers) {
            out_.exact.push_back(*exact);
            r.exact = static_cast<std::uint32_t>(out_.exact.size() - 1);
        } else {
            r.exact = no_id;
        }
        out_.points.push_back(r);
        return static_cast<PointId>(out_.points.size() - 1);
    }

    PlaneId table_plane(std::uint32_t i, PlaneId h) {
        std::uint32_t& k = tables_[i][unoriented(h)];
        if (k == no_id) k = out_.planes.intern_from(operands_->boundary(i).planes, unoriented(h));
        return 2 * k + (h & 1U);
    }

    PlaneId kernel_plane(PlaneId h) {
        const std::uint32_t own = unoriented(h);
        if (own >= planes_.size()) planes_.resize(operands_->kernel().planes.size(), no_id);
        if (planes_[own] == no_id) planes_[own] = out_.planes.intern_from(operands_->kernel().planes, own);
        return 2 * planes_[own] + (h & 1U);
    }

    SurfaceOperands* operands_;
    Boundary<3> out_;
    std::vector<PointId> vertices_;                   // of the operands, to the result's
    std::vector<PointId> points_;                     // of the kernel
    std::vector<std::uint32_t> planes_;               // of the kernel
    std::vector<std::vector<std::uint32_t>> tables_;  // planes of the operands
    std::vector<Corner> loop_;
};

CLEAVE_END_NAMESPACE

#endif
