// SPDX-License-Identifier: Apache-2.0
/// Conforming faces: every vertex of the boundary that lies on an edge becomes a corner of that edge's loop, so that
/// no T-junction remains.
#ifndef CLEAVE_REGION_CONFORM_HPP
#define CLEAVE_REGION_CONFORM_HPP

#include <cleave/base/error.hpp>
#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/geometry/kernel_box.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Inserts into the loops of a 3-D boundary all vertices that other edges on the same line have there, and those of the
/// face itself where its outline touches the middle of one of its edges: the edge would be two edges of two pieces.
///
/// Edges are grouped by line: a key from the residues of their ends modulo 2^61-1 (the same for both directions), and
/// exactly within a group. On each line the vertices are sorted once. A vertex of another face that touches an edge in
/// passing stays out: there no edge ends on the line.
class Conformer {
public:
    /// `first_point` is where the boundary's points start in the kernel that it was loaded into.
    Conformer(Kernel<3>& kernel, const Boundary<3>& boundary, const LoadedBoundary<3>& loaded)
        : kernel_(&kernel), boundary_(&boundary), loaded_(&loaded) {
        collect();
        group();
    }

    /// The corners of loop l with the inserted ones, as indices of the boundary's points. Valid until the next call.
    [[nodiscard]] std::span<const PointId> loop(std::size_t l) {
        out_.clear();
        const FaceList& faces = boundary_->faces;
        for (std::uint32_t c = faces.loop_first[l]; c < faces.loop_first[l + 1]; ++c) {
            out_.push_back(faces.corners[c].point);
            const auto [begin, end] = inserted_[c];
            out_.insert(out_.end(), extra_.begin() + begin, extra_.begin() + end);
        }
        return out_;
    }

    /// Calls `emit(from, to, corner)` for the pieces of loop l's edges in order; `corner` is the index of the
    /// boundary's corner at which the whole edge starts.
    template <class Emit>
    void for_each_edge(std::size_t l, Emit&& emit) const {
        const FaceList& faces = boundary_->faces;
        const std::uint32_t first = faces.loop_first[l];
        const std::uint32_t last = faces.loop_first[l + 1];
        for (std::uint32_t c = first; c < last; ++c) {
            PointId from = faces.corners[c].point;
            for (std::uint32_t i = inserted_[c].first; i < inserted_[c].second; ++i) {
                emit(from, extra_[i], c);
                from = extra_[i];
            }
            emit(from, faces.corners[c + 1 == last ? first : c + 1].point, c);
        }
    }

    /// How many corners were inserted.
    [[nodiscard]] std::size_t inserted() const noexcept { return extra_.size(); }

private:
    struct Edge {
        PointId from;
        PointId to;
        PlaneId face;
        PlaneId plane;
        std::uint32_t corner;
    };

    void collect() {
        const FaceList& faces = boundary_->faces;
        edges_.reserve(faces.corners.size());
        touched_.assign(faces.corners.size(), false);
        for (const FaceList::Face& face : faces.faces) {
            const PlaneId f = loaded_->plane(face.plane);
            const std::size_t first = edges_.size();
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                const std::uint32_t begin = faces.loop_first[l];
                const std::uint32_t end = faces.loop_first[l + 1];
                for (std::uint32_t c = begin; c < end; ++c)
                    edges_.push_back({faces.corners[c].point, faces.corners[c + 1 == end ? begin : c + 1].point, f,
                                      loaded_->plane(faces.corners[c].edge), c});
            }
            find_touches(first, edges_.size());
        }
        std::sort(touches_.begin(), touches_.end());
        inserted_.assign(faces.corners.size(), {0, 0});
    }

    /// Vertices of one face in the middle of its own edges, given as those from `first` to `last`.
    void find_touches(std::size_t first, std::size_t last) {
        if (last - first <= 3) return;
        const auto find = [&](std::size_t e, PointId p) {
            const Edge& edge = edges_[e];
            if (p == edge.from || p == edge.to || !is_between(edge, p)) return;
            touches_.push_back({static_cast<std::uint32_t>(e), p});
            touched_[e] = true;
        };
        constexpr std::size_t few = 32;
        if (last - first <= few) {
            for (std::size_t e = first; e < last; ++e)
                for (std::size_t v = first; v < last; ++v) find(e, edges_[v].from);
            return;
        }
        std::vector<Box<3>> boxes(last - first);
        for (std::size_t e = first; e < last; ++e)
            for (const PointId p : {edges_[e].from, edges_[e].to}) boxes[e - first].extend(box_of_point(p));
        const BoxHierarchy<3> hierarchy(boxes);
        for (std::size_t v = first; v < last; ++v)
            hierarchy.for_each_meeting(box_of_point(edges_[v].from),
                                       [&](std::size_t e) { find(first + e, edges_[v].from); });
    }

    [[nodiscard]] Box<3> box_of_point(PointId p) { return box_of(*kernel_, loaded_->first_point + p); }

    /// Whether p, in the edge's face, lies on the edge and is neither of its ends.
    [[nodiscard]] bool is_between(const Edge& e, PointId p) {
        const PointId q = loaded_->first_point + p;
        if (kernel_->side(e.plane, q) != Sign::zero) return false;
        const AxisDirection d = edge_direction(*kernel_, e.face, e.plane);
        return kernel_->compare(d.axis, q, loaded_->first_point + e.from) == d.sign &&
               kernel_->compare(d.axis, loaded_->first_point + e.to, q) == d.sign;
    }

    void group() {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> keys = line_keys();
        std::sort(keys.begin(), keys.end());
        std::vector<std::uint32_t> rest;
        std::vector<std::uint32_t> line;
        for (std::size_t i = 0; i < keys.size();) {
            std::size_t j = i;
            bool simple = true;
            const std::pair<PointId, PointId> ends = ends_of(keys[i].second);
            for (; j < keys.size() && keys[j].first == keys[i].first; ++j)
                simple = simple && !touched_[keys[j].second] && ends_of(keys[j].second) == ends;
            if (!simple) {
                rest.clear();
                for (std::size_t k = i; k < j; ++k) rest.push_back(keys[k].second);
                while (!rest.empty()) {
                    take_line(rest, line);
                    split_line(line);
                }
            }
            i = j;
        }
    }

    [[nodiscard]] std::pair<PointId, PointId> ends_of(std::uint32_t e) const {
        return std::minmax(edges_[e].from, edges_[e].to);
    }

    /// Direction scaled to a first non-zero entry of 1, and moment p x d.
    std::vector<std::pair<std::uint64_t, std::uint32_t>> line_keys() {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(edges_.size());
        for (std::uint32_t e = 0; e < keys.size(); ++e) keys[e] = {0, e};
        std::vector<std::array<Mod61, 3>> points;
        points.reserve(boundary_->points.size());
        for (PointId p = 0; p < boundary_->points.size(); ++p) {
            const auto r = kernel_->residues(loaded_->first_point + p);
            if (!r) return keys;  // one group: slower, still exact
            points.push_back(*r);
        }
        std::vector<std::array<Mod61, 3>> directions(edges_.size());
        std::vector<Mod61> scales(edges_.size());
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            for (std::size_t i = 0; i < 3; ++i) directions[e][i] = points[edges_[e].to][i] - points[edges_[e].from][i];
            for (const Mod61& d : directions[e])
                if (scales[e].is_zero()) scales[e] = d;
        }
        invert_all(std::span<Mod61>(scales));
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            std::array<Mod61, 3> d = directions[e];
            for (Mod61& x : d) x *= scales[e];
            const std::array<Mod61, 3>& p = points[edges_[e].from];
            std::uint64_t key = 0x13198a2e03707344ULL;
            for (std::size_t i = 0; i < 3; ++i) {
                const Mod61 moment = p[(i + 1) % 3] * d[(i + 2) % 3] - p[(i + 2) % 3] * d[(i + 1) % 3];
                key = (key ^ d[i].value()) * 0xff51afd7ed558ccdULL;
                key = (key ^ (key >> 29U) ^ moment.value()) * 0xc4ceb9fe1a85ec53ULL;
            }
            keys[e].first = key;
        }
        return keys;
    }

    /// Moves the edges on the first one's line from `rest` to `line`.
    void take_line(std::vector<std::uint32_t>& rest, std::vector<std::uint32_t>& line) {
        line.clear();
        const Edge& e = edges_[rest.front()];
        const auto on_line = [&](PointId p) {
            const PointId q = loaded_->first_point + p;
            return kernel_->side(e.face, q) == Sign::zero && kernel_->side(e.plane, q) == Sign::zero;
        };
        std::size_t kept = 0;
        for (const std::uint32_t i : rest) {
            if (on_line(edges_[i].from) && on_line(edges_[i].to))
                line.push_back(i);
            else
                rest[kept++] = i;
        }
        rest.resize(kept);
        if (line.empty())
            throw Error("an edge is not on its face's plane: an operand intersects itself; check the operands");
    }

    void split_line(const std::vector<std::uint32_t>& line) {
        const Edge& first = edges_[line.front()];
        const AxisDirection d = edge_direction(*kernel_, first.face, first.plane);
        const auto before = [&](PointId p, PointId q) {
            return p != q &&
                   kernel_->compare(d.axis, loaded_->first_point + p, loaded_->first_point + q) == Sign::minus;
        };
        std::vector<PointId> points;
        for (const std::uint32_t i : line) {
            points.push_back(edges_[i].from);
            points.push_back(edges_[i].to);
            if (!touched_[i]) continue;
            for (auto t = std::lower_bound(touches_.begin(), touches_.end(), std::pair(i, PointId(0)));
                 t != touches_.end() && t->first == i; ++t)
                points.push_back(t->second);
        }
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
        if (points.size() == 2) return;
        std::sort(points.begin(), points.end(), before);
        const auto rank = [&](PointId p) { return std::lower_bound(points.begin(), points.end(), p, before); };
        for (const std::uint32_t i : line) {
            const auto from = rank(edges_[i].from);
            const auto to = rank(edges_[i].to);
            const auto begin = static_cast<std::uint32_t>(extra_.size());
            if (from < to)
                extra_.insert(extra_.end(), from + 1, to);
            else
                extra_.insert(extra_.end(), std::make_reverse_iterator(from), std::make_reverse_iterator(to + 1));
            inserted_[edges_[i].corner] = {begin, static_cast<std::uint32_t>(extra_.size())};
        }
    }

    Kernel<3>* kernel_;
    const Boundary<3>* boundary_;
    const LoadedBoundary<3>* loaded_;
    std::vector<Edge> edges_;
    std::vector<bool> touched_;                                      // per edge: whether `touches_` has it
    std::vector<std::pair<std::uint32_t, PointId>> touches_;         // edge, vertex in its middle
    std::vector<std::pair<std::uint32_t, std::uint32_t>> inserted_;  // per corner: range of extra_
    std::vector<PointId> extra_, out_;
};

CLEAVE_END_NAMESPACE

#endif
