// SPDX-License-Identifier: Apache-2.0
/// Edges that touch a face from its inside, made part of the face: where a notch reaches up to a face from below, the
/// interior on its two sides is not connected through the face.
#ifndef CLEAVE_QUERY_CONTACTS_HPP
#define CLEAVE_QUERY_CONTACTS_HPP

#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/geometry/kernel_box.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/query/boundary_edges.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Boxes of all faces, with the hierarchy over them.
class FaceBoxes {
public:
    FaceBoxes(Kernel<3>& kernel, const BoundaryEdges& edges) {
        std::vector<Box<3>> boxes(edges.face_count());
        for (std::size_t e = 0; e < edges.size(); ++e) boxes[edges[e].face].extend(box_of(kernel, edges[e].from));
        hierarchy_ = BoxHierarchy<3>(boxes);
    }

    [[nodiscard]] const BoxHierarchy<3>& hierarchy() const noexcept { return hierarchy_; }

private:
    BoxHierarchy<3> hierarchy_;
};

/// Finds the stretches of edges that lie in the relative interior of a face, with the interior of the set between the
/// edge's own faces and that face, and cuts the face open along them: each becomes a loop of two corners, there and
/// back. The set stays what it was.
class ContactCutter {
public:
    ContactCutter(Kernel<3>& kernel, const Boundary<3>& boundary, const BoundaryEdges& edges, const FaceBoxes& boxes)
        : kernel_(&kernel), boundary_(&boundary), edges_(&edges), boxes_(&boxes), points_(kernel) {}

    /// The boundary with cuts, or nullopt where there is no such contact. Faces keep their numbers.
    /// Cost: a query of a box hierarchy for each edge.
    [[nodiscard]] std::optional<Boundary<3>> cut() {
        edges_->for_each_group([&](std::span<const std::uint32_t> group) {
            const BoundaryEdge& edge = (*edges_)[group.front()];
            Box<3> box = box_of(*kernel_, edge.from);
            box.extend(box_of(*kernel_, edge.to));
            boxes_->hierarchy().for_each_meeting(box, [&](std::size_t f) {
                const PlaneId notch = notch_plane(f, group);
                if (notch != no_id) cut_face(f, edge, notch);
            });
        });
        if (slits_.empty()) return std::nullopt;
        return freeze(*kernel_, assemble(), boundary_->value_at_infinity, points_);
    }

private:
    struct Slit {
        std::uint32_t face;
        PointId from;
        PointId to;
        PlaneId plane;  // oriented for from -> to
    };
    /// A point in the middle of a boundary edge.
    struct Split {
        std::uint32_t edge;
        PointId point;

        friend bool operator==(const Split&, const Split&) = default;
    };
    /// Where the line of an edge meets the outline of a face.
    struct Meeting {
        PointId point;
        bool crosses;
        std::uint32_t edge;  // crossed in its middle, or `no_id`
    };

    /// The plane of a face of the group's edge that comes up to face f from its inside; `no_id` where the edge does not
    /// lie in f's plane, bounds f, or no such face is there.
    [[nodiscard]] PlaneId notch_plane(std::size_t f, std::span<const std::uint32_t> group) const {
        const PlaneId plane = edges_->plane(f);
        const BoundaryEdge& edge = (*edges_)[group.front()];
        if (kernel_->side(plane, edge.from) != Sign::zero || kernel_->side(plane, edge.to) != Sign::zero) return no_id;
        PlaneId found = no_id;
        for (const std::uint32_t e : group) {
            if ((*edges_)[e].face == f) return no_id;
            const PlaneId other = edges_->plane((*edges_)[e].face);
            if (unoriented(other) == unoriented(plane)) continue;
            if (orient_edge(*kernel_, other, plane, (*edges_)[e].from, (*edges_)[e].to) == plane) found = other;
        }
        return found;
    }

    void cut_face(std::size_t f, const BoundaryEdge& edge, PlaneId notch) {
        const PlaneId plane = edges_->plane(f);
        const AxisDirection d = edge_direction(*kernel_, plane, notch);
        const auto before = [&](PointId p, PointId q) {
            return p != q && kernel_->compare(d.axis, p, q) == Sign::minus;
        };
        PointId start = points_(edge.from);
        PointId end = points_(edge.to);
        if (before(end, start)) std::swap(start, end);
        std::vector<Meeting> meetings{{start, false, no_id}, {end, false, no_id}};
        std::vector<std::pair<PointId, PointId>> along;  // edges of f on the line
        for (std::uint32_t e = edges_->first(f); e < edges_->first(f + 1); ++e) {
            const BoundaryEdge& b = (*edges_)[e];
            const Sign from = kernel_->side(notch, b.from);
            const Sign to = kernel_->side(notch, b.to);
            // The line is taken just on the plus side of itself, which settles how it passes through corners.
            const bool crosses = (from == Sign::plus) != (to == Sign::plus);
            if (from == Sign::zero && to == Sign::zero) {
                along.push_back({points_(b.from), points_(b.to)});
                if (before(along.back().second, along.back().first)) std::swap(along.back().first, along.back().second);
            } else if (from * to == Sign::minus) {
                const PointId x =
                    points_(kernel_->cross(notch, b.from, b.to, {unoriented(plane), unoriented(b.plane)}));
                meetings.push_back({x, true, e});
            }
            if (from == Sign::zero) meetings.push_back({points_(b.from), crosses, no_id});
            if (to == Sign::zero) meetings.push_back({points_(b.to), crosses, no_id});
        }
        std::sort(meetings.begin(), meetings.end(),
                  [&](const Meeting& a, const Meeting& b) { return before(a.point, b.point); });
        bool inside = false;
        for (std::size_t i = 0; i + 1 < meetings.size(); ++i) {
            inside = inside != meetings[i].crosses;
            const PointId p = meetings[i].point;
            const PointId q = meetings[i + 1].point;
            if (!inside || p == q || before(p, start) || before(end, q)) continue;
            const bool outline = std::any_of(along.begin(), along.end(), [&](const std::pair<PointId, PointId>& a) {
                return !before(p, a.first) && !before(a.second, q);
            });
            if (outline) continue;
            slits_.push_back({static_cast<std::uint32_t>(f), p, q, orient_edge(*kernel_, plane, notch, p, q)});
            for (const Meeting& m : meetings)
                if (m.edge != no_id && (m.point == p || m.point == q)) splits_.push_back({m.edge, m.point});
        }
    }

    /// The faces again, in the kernel's numbers, with the slits and with the corners at which slits end.
    [[nodiscard]] FaceList assemble() {
        std::stable_sort(slits_.begin(), slits_.end(), [](const Slit& a, const Slit& b) { return a.face < b.face; });
        const auto position = [&](const Split& a, const Split& b) {
            if (a.edge != b.edge) return a.edge < b.edge;
            if (a.point == b.point) return false;
            const BoundaryEdge& e = (*edges_)[a.edge];
            const AxisDirection d = edge_direction(*kernel_, edges_->plane(e.face), e.plane);
            return kernel_->compare(d.axis, b.point, a.point) == d.sign;
        };
        std::sort(splits_.begin(), splits_.end(), position);
        splits_.erase(std::unique(splits_.begin(), splits_.end()), splits_.end());
        FaceList out;
        std::vector<Corner> loop;
        auto slit = slits_.begin();
        auto split = splits_.begin();
        for (std::uint32_t f = 0; f < edges_->face_count(); ++f) {
            out.begin_face(edges_->plane(f), boundary_->faces.faces[f].source);
            for (std::uint32_t e = edges_->first(f); e < edges_->first(f + 1); ++e) {
                const BoundaryEdge& edge = (*edges_)[e];
                loop.push_back({edge.from, edge.plane});
                for (; split != splits_.end() && split->edge == e; ++split) loop.push_back({split->point, edge.plane});
                if (edge.next == e + 1) continue;
                out.add_loop(loop);
                loop.clear();
            }
            for (; slit != slits_.end() && slit->face == f; ++slit) {
                const Corner there_and_back[2] = {{slit->from, slit->plane}, {slit->to, flipped(slit->plane)}};
                out.add_loop(there_and_back);
            }
        }
        return out;
    }

    Kernel<3>* kernel_;
    const Boundary<3>* boundary_;
    const BoundaryEdges* edges_;
    const FaceBoxes* boxes_;
    PointInterner<3> points_;
    std::vector<Slit> slits_;
    std::vector<Split> splits_;
};

CLEAVE_END_NAMESPACE

#endif
