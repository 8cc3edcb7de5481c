// SPDX-License-Identifier: Apache-2.0
/// The contours of a face: its edges linked around the sectors of its interior, and which contours bound the same
/// connected piece of the face.
#ifndef CLEAVE_QUERY_FACE_CONTOURS_HPP
#define CLEAVE_QUERY_FACE_CONTOURS_HPP

#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/query/boundary_edges.hpp>
#include <cleave/region/build.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Of sectors around a point or line, sorted counter-clockwise by the rays that begin and end them: calls
/// `join(i, j)` where ray i opens a sector that ray j closes. Rays that do not alternate are left alone.
template <class Ray, class Join>
void join_sectors(std::span<const Ray> rays, Join&& join) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::size_t j = i + 1 == rays.size() ? 0 : i + 1;
        if (rays[i].opens && !rays[j].opens) join(rays[i].edge, rays[j].edge);
    }
}

/// Links the edges of one face at a time. A loop as it is stored may pass a point several times, and need not turn
/// there so that it follows one sector of the interior; contours do.
class FaceContours {
public:
    FaceContours(Kernel<3>& kernel, const BoundaryEdges& edges) : kernel_(&kernel), edges_(&edges) {}

    /// Calls `join(e, g)` for edges of face f that bound the same connected piece of its interior; pieces that meet in
    /// points alone are not connected. Cost: O(n) for a face of n edges and one contour, O(n) for each hole.
    template <class Join>
    void connect(std::size_t f, Join&& join) {
        first_ = edges_->first(f);
        const std::uint32_t last = edges_->first(f + 1);
        if (first_ == last) return;
        plane_ = edges_->plane(f);
        next_.clear();
        for (std::uint32_t e = first_; e < last; ++e) next_.push_back((*edges_)[e].next);
        relink();
        number_contours();
        for (std::uint32_t e = first_; e < last; ++e) join(e, next_[e - first_]);
        if (contour_first_.size() > 1) connect_holes(join);
    }

private:
    /// A ray from a point along an edge: `plane` is oriented so that n_f x n_plane points along it.
    struct Ray {
        PlaneId plane;
        PointId to;
        std::uint32_t edge;
        bool opens;  // counter-clockwise of it lies the interior: the edge starts here
        int part;    // 0: along the reference ray, 1: less than half a turn on, 2: opposite, 3: beyond
    };

    [[nodiscard]] Ray ray(std::uint32_t e, bool out) const {
        const BoundaryEdge& edge = (*edges_)[e];
        return out ? Ray{edge.plane, edge.to, e, true, 0} : Ray{flipped(edge.plane), edge.from, e, false, 0};
    }

    /// Where a point is passed more than once, edges are linked around sectors.
    void relink() {
        ends_.clear();
        for (std::uint32_t i = 0; i < next_.size(); ++i) ends_.push_back({(*edges_)[first_ + i].from, first_ + i});
        std::sort(ends_.begin(), ends_.end());
        for (std::size_t i = 0; i < ends_.size();) {
            std::size_t j = i + 1;
            while (j < ends_.size() && ends_[j].first == ends_[i].first) ++j;
            if (j - i > 1) relink_at(ends_[i].first);
            i = j;
        }
    }

    void relink_at(PointId p) {
        rays_.clear();
        for (std::uint32_t i = 0; i < next_.size(); ++i) {
            const BoundaryEdge& e = (*edges_)[first_ + i];
            if (e.from == p) rays_.push_back(ray(first_ + i, true));
            if (e.to == p) rays_.push_back(ray(first_ + i, false));
        }
        const Ray reference = rays_.front();
        const int axis = edge_direction(*kernel_, plane_, reference.plane).axis;
        const Sign ahead = kernel_->compare(axis, reference.to, p);
        for (Ray& r : rays_) {
            const Sign left = turn(*kernel_, plane_, reference.plane, r.plane);
            if (left == Sign::zero)
                r.part = kernel_->compare(axis, r.to, p) == ahead ? 0 : 2;
            else
                r.part = left == Sign::plus ? 1 : 3;
        }
        std::sort(rays_.begin(), rays_.end(), [&](const Ray& a, const Ray& b) {
            if (a.part != b.part) return a.part < b.part;
            const Sign s = turn(*kernel_, plane_, a.plane, b.plane);
            if (s != Sign::zero) return s == Sign::plus;
            // The two sides of a slit: the sector before it is closed first.
            return a.opens != b.opens ? b.opens : a.edge < b.edge;
        });
        // An edge that ends here is followed by the one that starts the same sector.
        join_sectors(std::span<const Ray>(rays_),
                     [&](std::uint32_t out, std::uint32_t in) { next_[in - first_] = out; });
    }

    void number_contours() {
        contour_.assign(next_.size(), no_id);
        contour_first_.clear();
        for (std::uint32_t i = 0; i < next_.size(); ++i) {
            if (contour_[i] != no_id) continue;
            const auto number = static_cast<std::uint32_t>(contour_first_.size());
            contour_first_.push_back(first_ + i);
            for (std::uint32_t e = i; contour_[e] == no_id; e = next_[e] - first_) contour_[e] = number;
        }
    }

    /// From the leftmost point of a hole the interior reaches to the left, as far as the next edge: both bound the
    /// same piece.
    template <class Join>
    void connect_holes(Join&& join) {
        const int drop = dominant_axis(*kernel_, unoriented(plane_));
        const Sign up = kernel_->planes.exact(unoriented(plane_))[std::size_t(drop)].sign();
        u_ = (drop + 1) % 3;
        v_ = (drop + 2) % 3;
        if ((up == Sign::minus) != is_flipped(plane_)) std::swap(u_, v_);
        for (std::uint32_t c = 0; c < contour_first_.size(); ++c) {
            PointId p = (*edges_)[contour_first_[c]].from;
            for_contour(c, [&](std::uint32_t e) {
                if (less((*edges_)[e].from, p)) p = (*edges_)[e].from;
            });
            if (!is_hole(c, p)) continue;
            const std::uint32_t hit = first_to_the_left(p);
            if (hit != no_id) join(contour_first_[c], hit);
        }
    }

    template <class Visit>
    void for_contour(std::uint32_t c, Visit&& visit) const {
        for (std::uint32_t i = 0; i < contour_.size(); ++i)
            if (contour_[i] == c) visit(first_ + i);
    }

    [[nodiscard]] bool less(PointId p, PointId q) const {
        if (p == q) return false;
        const Sign s = kernel_->compare(u_, p, q);
        return s != Sign::zero ? s == Sign::minus : kernel_->compare(v_, p, q) == Sign::minus;
    }

    /// Whether the interior is to the left of p, the leftmost point of contour c: above the uppermost ray from p.
    [[nodiscard]] bool is_hole(std::uint32_t c, PointId p) const {
        Ray top{no_id, no_id, no_id, false, 0};
        const auto consider = [&](const Ray& r) {
            // All rays point to the right half or straight up, so the turn between two of them orders them.
            const Sign s = top.plane == no_id ? Sign::plus : turn(*kernel_, plane_, top.plane, r.plane);
            if (s == Sign::plus || (s == Sign::zero && r.opens)) top = r;
        };
        for_contour(c, [&](std::uint32_t e) {
            if ((*edges_)[e].from == p) consider(ray(e, true));
            if ((*edges_)[e].to == p) consider(ray(e, false));
        });
        return top.opens;
    }

    /// The edge nearest to the left of p, on a line just above p. It runs down: the interior is on its right.
    [[nodiscard]] std::uint32_t first_to_the_left(PointId p) const {
        std::uint32_t best = no_id;
        for (std::uint32_t i = 0; i < next_.size(); ++i) {
            const BoundaryEdge& e = (*edges_)[first_ + i];
            if (kernel_->compare(v_, e.from, p) != Sign::plus || kernel_->compare(v_, e.to, p) == Sign::plus) continue;
            // Downwards, the interior (minus) is to the right.
            if (kernel_->side(e.plane, p) != Sign::minus) continue;
            if (best == no_id || is_right_of(first_ + i, best)) best = first_ + i;
        }
        return best;
    }

    /// Of two edges that run down through the same height and do not cross: whether e is to the right of g there.
    [[nodiscard]] bool is_right_of(std::uint32_t e, std::uint32_t g) const {
        const BoundaryEdge& a = (*edges_)[e];
        const BoundaryEdge& b = (*edges_)[g];
        if (kernel_->compare(v_, a.to, b.to) != Sign::minus) {
            const Sign s = kernel_->side(b.plane, a.to);
            if (s != Sign::zero) return s == Sign::minus;
        } else {
            const Sign s = kernel_->side(a.plane, b.to);
            if (s != Sign::zero) return s == Sign::plus;
        }
        // They meet at the lower end: directions upwards decide.
        return turn(*kernel_, plane_, flipped(b.plane), flipped(a.plane)) == Sign::minus;
    }

    Kernel<3>* kernel_;
    const BoundaryEdges* edges_;
    PlaneId plane_ = no_id;
    std::uint32_t first_ = 0;
    int u_ = 0;
    int v_ = 1;
    std::vector<std::uint32_t> next_;           // per edge of the face
    std::vector<std::uint32_t> contour_;        // per edge of the face
    std::vector<std::uint32_t> contour_first_;  // an edge of each contour
    std::vector<std::pair<PointId, std::uint32_t>> ends_;
    std::vector<Ray> rays_;
};

CLEAVE_END_NAMESPACE

#endif
