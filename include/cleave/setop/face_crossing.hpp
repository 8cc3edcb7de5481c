// SPDX-License-Identifier: Apache-2.0
/// Where two faces of different operands meet.
#ifndef CLEAVE_SETOP_FACE_CROSSING_HPP
#define CLEAVE_SETOP_FACE_CROSSING_HPP

#include <cleave/geometry/bounds.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A face of a boundary that was loaded into a kernel.
template <int D>
requires(D == 3) struct LoadedFace {
    const Boundary<D>* boundary = nullptr;
    const LoadedBoundary<D>* loaded = nullptr;
    std::uint32_t index = 0;

    [[nodiscard]] const FaceList::Face& face() const { return boundary->faces.faces[index]; }
    [[nodiscard]] PlaneId plane() const { return loaded->plane(face().plane); }
    /// Calls `visit(number of corner, its point, the next corner's point)` for every edge.
    template <class Visit>
    void for_each_edge(Visit&& visit) const {
        const FaceList& list = boundary->faces;
        for (std::uint32_t l = face().first_loop; l < face().first_loop + face().loop_count; ++l) {
            const std::uint32_t first = list.loop_first[l];
            const std::uint32_t last = list.loop_first[l + 1];
            for (std::uint32_t c = first; c < last; ++c)
                visit(c, loaded->first_point + list.corners[c].point,
                      loaded->first_point + list.corners[c + 1 == last ? first : c + 1].point);
        }
    }
};

/// How two faces meet.
enum class FaceMeeting : std::uint8_t {
    none,      ///< not at all
    crossing,  ///< they cross properly, in segments whose ends are inside an edge of the one and inside the other
    special,   ///< anything else: coplanar, an edge on a face, two edges that cross, a vertex on anything
};

/// Finds where faces cross, one pair after the other. Keeps scratch memory.
template <int D>
requires(D == 3) class FaceCrossing {
public:
    /// An end of a common segment: the point where an edge of the one face pierces the other.
    struct End {
        PointId point = no_id;
        std::uint32_t corner = 0;  ///< of the edge
        bool of_first = false;     ///< whether it is an edge of the first face
    };

    explicit FaceCrossing(Kernel<D>& kernel) : kernel_(&kernel) {}

    /// After `crossing`, `ends()` are the ends of the common segments, two for each, along the direction in which the
    /// first face has the second one's minus side on its left.
    FaceMeeting meet(const LoadedFace<D>& f, const Bounds<D>& f_box, const LoadedFace<D>& h, const Bounds<D>& h_box) {
        const PlaneId f_plane = f.plane();
        const PlaneId h_plane = h.plane();
        if (unoriented(f_plane) == unoriented(h_plane)) return FaceMeeting::special;
        const FaceMeeting a = find_signs(f, h_plane, h_box, f_signs_);
        if (a == FaceMeeting::none) return a;
        const FaceMeeting b = find_signs(h, f_plane, f_box, h_signs_);
        if (b == FaceMeeting::none) return b;
        if (a == FaceMeeting::special || b == FaceMeeting::special) return FaceMeeting::special;
        const AxisDirection direction = edge_direction(*kernel_, f_plane, h_plane);
        pierce(f, h_plane, f_signs_, true, f_ends_);
        pierce(h, f_plane, h_signs_, false, h_ends_);
        if (!sort_along(direction, f_ends_) || !sort_along(direction, h_ends_)) return FaceMeeting::special;
        return intersect(direction);
    }

    [[nodiscard]] std::span<const End> ends() const noexcept { return ends_; }

private:
    /// The sides of plane h on which the corners of f lie. Returns: none where f is on one side, or touches h only
    /// beyond the other face's box; crossing where no corner is on h.
    FaceMeeting find_signs(const LoadedFace<D>& f, PlaneId h, const Bounds<D>& box, std::vector<Sign>& signs) {
        signs.clear();
        bool below = false;
        bool above = false;
        Bounds<D> touching;
        f.for_each_edge([&](std::uint32_t, PointId p, PointId) {
            const Sign s = kernel_->side(h, p);
            signs.push_back(s);
            below = below || s == Sign::minus;
            above = above || s == Sign::plus;
            if (s == Sign::zero) touching.include(kernel_->point(p).approximation, kernel_->point(p).error);
        });
        const bool touches = touching.lo[0] <= touching.hi[0];
        if (below && above) return touches ? FaceMeeting::special : FaceMeeting::crossing;
        return touches && !touching.disjoint(box) ? FaceMeeting::special : FaceMeeting::none;
    }

    /// The points where edges of f cross plane h.
    void pierce(const LoadedFace<D>& f, PlaneId h, const std::vector<Sign>& signs, bool first, std::vector<End>& ends) {
        ends.clear();
        const FaceList& list = f.boundary->faces;
        std::size_t at = 0;
        for (std::uint32_t l = f.face().first_loop; l < f.face().first_loop + f.face().loop_count; ++l) {
            const std::uint32_t first_corner = list.loop_first[l];
            const std::uint32_t size = list.loop_first[l + 1] - first_corner;
            for (std::uint32_t i = 0; i < size; ++i) {
                const std::uint32_t next = i + 1 == size ? 0 : i + 1;
                if (signs[at + i] == signs[at + next]) continue;
                const Corner& c = list.corners[first_corner + i];
                const PointId x = kernel_->cross(h, f.loaded->first_point + c.point,
                                                 f.loaded->first_point + list.corners[first_corner + next].point,
                                                 {unoriented(f.plane()), unoriented(f.loaded->plane(c.edge))});
                ends.push_back({x, first_corner + i, first});
            }
            at += size;
        }
    }

    /// Sorts points of the common line. Returns: false where two are the same.
    bool sort_along(const AxisDirection& direction, std::vector<End>& ends) {
        bool different = true;
        const auto before = [&](const End& a, const End& b) {
            const Sign s = kernel_->compare(direction.axis, b.point, a.point);
            if (s == Sign::zero && a.point != b.point) different = false;
            return s == direction.sign;
        };
        if (ends.size() == 2) {
            if (before(ends[1], ends[0])) std::swap(ends[0], ends[1]);
        } else {
            std::sort(ends.begin(), ends.end(), before);
        }
        return different;
    }

    /// Merges the two sorted lists; both faces are entered at even places and left at odd ones.
    FaceMeeting intersect(const AxisDirection& direction) {
        ends_.clear();
        std::size_t i = 0;
        std::size_t j = 0;
        while (i < f_ends_.size() && j < h_ends_.size()) {
            const Sign s = kernel_->compare(direction.axis, h_ends_[j].point, f_ends_[i].point);
            if (s == Sign::zero) return FaceMeeting::special;
            const bool f_first = s == direction.sign;
            // A change of the one counts where the other face covers it.
            if (f_first ? j % 2 != 0 : i % 2 != 0) ends_.push_back(f_first ? f_ends_[i] : h_ends_[j]);
            ++(f_first ? i : j);
        }
        // What is left of either list is beyond the other's last end.
        return ends_.empty() ? FaceMeeting::none : FaceMeeting::crossing;
    }

    Kernel<D>* kernel_;
    std::vector<Sign> f_signs_, h_signs_;
    std::vector<End> f_ends_, h_ends_, ends_;
};

CLEAVE_END_NAMESPACE

#endif
