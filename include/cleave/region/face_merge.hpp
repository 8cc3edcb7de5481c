// SPDX-License-Identifier: Apache-2.0
/// Putting the pieces of one face together again: the boundary of their union within the face's plane.
///
/// Pieces of a face tile a part of it; edges between two of them cancel, whatever T-junctions they have, because on
/// each line the edges are counted with their direction over every elementary interval. What remains is the boundary of
/// the union, the same for every way the face was cut, with no vertex in the middle of a straight stretch.
#ifndef CLEAVE_REGION_FACE_MERGE_HPP
#define CLEAVE_REGION_FACE_MERGE_HPP

#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The edges that lie on one line, with their directions, and what remains of them.
/// An interval covered once more in the line's direction than against it gives one edge along it, and vice versa.
template <int D>
class LineSweep {
public:
    LineSweep(Kernel<D>& kernel, AxisDirection direction) : kernel_(&kernel), direction_(direction) {}

    void add(PointId from, PointId to) { edges_.push_back({from, to}); }

    /// The distinct points in the order of the direction. Valid after `run`.
    [[nodiscard]] const std::vector<PointId>& points() const noexcept { return points_; }

    /// Calls `emit(from, to, forward)` for each maximal stretch of constant non-zero count.
    /// Requires: points are representatives, so that equal points are equal ids.
    template <class Emit>
    void run(Emit&& emit) {
        points_.clear();
        for (const auto& e : edges_) {
            points_.push_back(e.first);
            points_.push_back(e.second);
        }
        std::sort(points_.begin(), points_.end());
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        std::sort(points_.begin(), points_.end(), [&](PointId p, PointId q) {
            return p != q && kernel_->compare(direction_.axis, q, p) == direction_.sign;
        });
        change_.assign(points_.size(), 0);
        for (const auto& e : edges_) {
            ++change_[rank(e.first)];
            --change_[rank(e.second)];
        }
        // An edge from a to b adds +1 between them if a comes first, -1 otherwise: in both cases +1 at a, -1 at b.
        int count = 0;
        std::size_t start = 0;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (change_[i] == 0) continue;
            for (int n = 0; n < count; ++n) emit(points_[start], points_[i], true);
            for (int n = 0; n > count; --n) emit(points_[i], points_[start], false);
            count += change_[i];
            start = i;
        }
    }

private:
    std::size_t rank(PointId p) const {
        if (points_.size() <= 8) return std::size_t(std::find(points_.begin(), points_.end(), p) - points_.begin());
        const auto at = std::lower_bound(points_.begin(), points_.end(), p, [&](PointId a, PointId b) {
            return a != b && kernel_->compare(direction_.axis, b, a) == direction_.sign;
        });
        return std::size_t(at - points_.begin());
    }

    Kernel<D>* kernel_;
    AxisDirection direction_;
    std::vector<std::pair<PointId, PointId>> edges_;
    std::vector<PointId> points_;
    std::vector<int> change_;
};

/// Merges pieces of one face at a time. The scratch memory is kept between faces.
template <int D>
class FaceMerger {
public:
    FaceMerger(Kernel<D>& kernel, PointInterner<D>& points) : kernel_(&kernel), points_(&points) {}

    /// Forgets the previous face. `f`: the oriented plane of the pieces that follow.
    void begin(PlaneId f) {
        plane_ = f;
        edges_.clear();
    }

    /// Adds a piece: its corners, in outward order with respect to the plane given to `begin`.
    void add(std::span<const Corner> piece) {
        const std::size_t n = piece.size();
        if constexpr (D == 3) {
            for (std::size_t i = 0; i < n; ++i)
                edges_.push_back({(*points_)(piece[i].point), (*points_)(piece[i + 1 == n ? 0 : i + 1].point),
                                  piece[i].edge, no_id});
        } else if constexpr (D == 2) {
            edges_.push_back({(*points_)(piece[0].point), (*points_)(piece[1].point), piece[0].edge, piece[1].edge});
        } else {
            edges_.push_back({(*points_)(piece[0].point), no_id, no_id, no_id});
        }
    }

    /// Adds one edge of a piece. Requires: in the end, the edges of all pieces are closed loops.
    void add_edge(PointId from, PointId to, PlaneId edge) requires(D == 3) {
        edges_.push_back({(*points_)(from), (*points_)(to), edge, no_id});
    }

    /// Adds the union of the pieces to `out` as one face, or nothing where it is empty.
    void finish(FaceList& out, Source source) {
        if (edges_.empty()) return;
        if constexpr (D == 1) {
            const Corner corner{edges_.front().from, no_id};
            out.begin_face(plane_, source);
            out.add_loop({&corner, 1});
        } else if constexpr (D == 2) {
            finish_segments(out, source);
        } else {
            finish_loops(out, source);
        }
    }

    /// The same, with every edge as it was added: none cancels another, and vertices on straight stretches stay.
    /// Where several edges leave one point, all edges must have planes.
    void finish_conforming(FaceList& out, Source source) requires(D == 3) {
        merged_ = edges_;
        link(out, source);
    }

private:
    struct Edge {
        PointId from;
        PointId to;
        PlaneId plane;      // D = 3: of the edge; D = 2: of the end `from`
        PlaneId end_plane;  // D = 2: of the end `to`
    };

    void finish_segments(FaceList& out, Source source) requires(D == 2) {
        LineSweep<D> sweep(*kernel_, edge_direction(*kernel_, plane_, no_id));
        for (const Edge& e : edges_) sweep.add(e.from, e.to);
        bool any = false;
        sweep.run([&](PointId from, PointId to, bool) {
            if (!any) out.begin_face(plane_, source);
            any = true;
            const Corner segment[2] = {{from, end_plane(from, true)}, {to, end_plane(to, false)}};
            out.add_loop(segment);
        });
    }

    PlaneId end_plane(PointId p, bool at_start) const {
        PlaneId best = no_id;
        for (const Edge& e : edges_) {
            if (at_start && e.from == p && e.plane < best) best = e.plane;
            if (!at_start && e.to == p && e.end_plane < best) best = e.end_plane;
        }
        return best;
    }

    void finish_loops(FaceList& out, Source source) requires(D == 3) {
        cancel_opposite();
        group_by_line();
        link(out, source);
    }

    /// Links the edges of `merged_` into loops.
    void link(FaceList& out, Source source) requires(D == 3) {
        if (merged_.empty()) return;
        std::sort(merged_.begin(), merged_.end(),
                  [](const Edge& a, const Edge& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
        out.begin_face(plane_, source);
        used_.assign(merged_.size(), false);
        for (std::size_t first = 0; first < merged_.size(); ++first) {
            if (used_[first]) continue;
            loop_.clear();
            for (std::size_t at = first; at != merged_.size() && !used_[at]; at = next(at)) {
                used_[at] = true;
                loop_.push_back({merged_[at].from, merged_[at].plane});
            }
            out.add_loop(loop_);
        }
    }

    /// Removes pairs of edges that run to and fro between the same two points: nearly all inner edges.
    void cancel_opposite() requires(D == 3) {
        const auto ends = [](const Edge& e) { return std::minmax(e.from, e.to); };
        std::sort(edges_.begin(), edges_.end(), [&](const Edge& a, const Edge& b) {
            const std::pair<PointId, PointId> x = ends(a);
            const std::pair<PointId, PointId> y = ends(b);
            return x != y ? x < y : std::pair(a.from, a.plane) < std::pair(b.from, b.plane);
        });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < edges_.size();) {
            std::size_t j = i;
            int balance = 0;
            const std::pair<PointId, PointId> pair = ends(edges_[i]);
            for (; j < edges_.size() && std::pair<PointId, PointId>(ends(edges_[j])) == pair; ++j)
                balance += edges_[j].from == pair.first ? 1 : -1;
            // Sorted by `from`: the forward ones come first.
            if (balance > 0)
                for (int n = 0; n < balance; ++n) edges_[kept++] = edges_[i + std::size_t(n)];
            else
                for (int n = 0; n < -balance; ++n) edges_[kept++] = edges_[j - 1 - std::size_t(n)];
            i = j;
        }
        edges_.resize(kept);
    }

    struct KeyedPlane {
        std::uint32_t plane;
        std::uint64_t key;
        std::uint32_t line;
        std::array<Mod61, D + 1> residues;
    };

    /// Up to this many planes are compared in pairs, more by hashes.
    static constexpr std::size_t pairs_up_to = 24;

    /// Gives each edge plane the number of its line, then sweeps every line into `merged_`.
    void group_by_line() requires(D == 3) {
        merged_.clear();
        keyed_.clear();
        for (const Edge& e : edges_) keyed_.push_back({unoriented(e.plane), 0, unoriented(e.plane), {}});
        std::sort(keyed_.begin(), keyed_.end(),
                  [](const KeyedPlane& a, const KeyedPlane& b) { return a.plane < b.plane; });
        keyed_.erase(std::unique(keyed_.begin(), keyed_.end(),
                                 [](const KeyedPlane& a, const KeyedPlane& b) { return a.plane == b.plane; }),
                     keyed_.end());
        for (KeyedPlane& k : keyed_) k.residues = line_residues(*kernel_, plane_, 2 * k.plane);
        if (keyed_.size() <= pairs_up_to)
            assign_lines_by_pairs();
        else
            assign_lines_by_hash();
        by_line_.clear();
        for (std::uint32_t i = 0; i < edges_.size(); ++i) by_line_.push_back({line_of(edges_[i].plane), i});
        std::sort(by_line_.begin(), by_line_.end());
        for (std::size_t i = 0; i < by_line_.size();) {
            std::size_t j = i;
            PlaneId best = no_id;
            for (; j < by_line_.size() && by_line_[j].first == by_line_[i].first; ++j)
                best = std::min(best, edges_[by_line_[j].second].plane & ~1U);
            sweep_line(i, j, best);
            i = j;
        }
    }

    void sweep_line(std::size_t begin, std::size_t end, PlaneId e) requires(D == 3) {
        if (end - begin == 1) {
            merged_.push_back(edges_[by_line_[begin].second]);
            return;
        }
        const AxisDirection d = edge_direction(*kernel_, plane_, e);
        LineSweep<D> sweep(*kernel_, d);
        for (std::size_t i = begin; i < end; ++i) {
            const Edge& edge = edges_[by_line_[i].second];
            sweep.add(edge.from, edge.to);
        }
        sweep.run([&](PointId from, PointId to, bool forward) {
            merged_.push_back({from, to, forward ? e : flipped(e), no_id});
        });
    }

    void assign_lines_by_pairs() requires(D == 3) {
        for (std::size_t i = 1; i < keyed_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (keyed_[j].line == keyed_[j].plane && proportional(keyed_[i].residues, keyed_[j].residues) &&
                    same_line(keyed_[i].plane, keyed_[j].plane)) {
                    keyed_[i].line = keyed_[j].plane;
                    break;
                }
    }

    void assign_lines_by_hash() requires(D == 3) {
        for (KeyedPlane& k : keyed_) k.key = projective_hash(k.residues);
        std::vector<std::uint32_t> order(keyed_.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(keyed_[a].key, a) < std::pair(keyed_[b].key, b);
        });
        for (std::size_t i = 0; i < order.size(); ++i) {
            KeyedPlane& k = keyed_[order[i]];
            for (std::size_t j = i; j-- > 0 && keyed_[order[j]].key == k.key;) {
                const KeyedPlane& other = keyed_[order[j]];
                if (other.line == other.plane && same_line(k.plane, other.plane)) {
                    k.line = other.plane;
                    break;
                }
            }
        }
    }

    /// Exactly: an edge of the one lies in the other plane with both ends.
    bool same_line(std::uint32_t a, std::uint32_t b) const {
        for (const Edge& e : edges_)
            if (unoriented(e.plane) == a)
                return kernel_->side(2 * b, e.from) == Sign::zero && kernel_->side(2 * b, e.to) == Sign::zero;
        return false;
    }

    std::uint32_t line_of(PlaneId h) const {
        const auto at = std::lower_bound(keyed_.begin(), keyed_.end(), unoriented(h),
                                         [](const KeyedPlane& k, std::uint32_t plane) { return k.plane < plane; });
        return at->line;
    }

    /// The unused edge that continues edge `at`: where several leave its end, the first one clockwise from the way
    /// back, so that the interior on the left stays in one sector.
    std::size_t next(std::size_t at) const requires(D == 3) {
        const PointId p = merged_[at].to;
        auto i = std::size_t(
            std::lower_bound(merged_.begin(), merged_.end(), p, [](const Edge& e, PointId q) { return e.from < q; }) -
            merged_.begin());
        std::size_t best = merged_.size();
        for (; i < merged_.size() && merged_[i].from == p; ++i)
            if (!used_[i] && (best == merged_.size() || before(at, i, best))) best = i;
        return best;
    }

    /// Half of the clockwise turn from the way back along `in`: 0: (0, pi), 1: pi, 2: (pi, 2 pi), 3: 2 pi.
    int sector(std::size_t in, std::size_t out) const requires(D == 3) {
        const Sign left = turn(*kernel_, plane_, merged_[in].plane, merged_[out].plane);
        if (left != Sign::zero) return left == Sign::plus ? 0 : 2;
        return merged_[in].plane == merged_[out].plane || ahead(in, out) ? 1 : 3;
    }

    bool ahead(std::size_t in, std::size_t out) const requires(D == 3) {
        const AxisDirection d = edge_direction(*kernel_, plane_, merged_[in].plane);
        return kernel_->compare(d.axis, merged_[out].to, merged_[out].from) == d.sign;
    }

    bool before(std::size_t in, std::size_t a, std::size_t b) const requires(D == 3) {
        const int x = sector(in, a);
        const int y = sector(in, b);
        if (x != y) return x < y;
        return turn(*kernel_, plane_, merged_[a].plane, merged_[b].plane) == Sign::minus;
    }

    Kernel<D>* kernel_;
    PointInterner<D>* points_;
    PlaneId plane_ = no_id;
    std::vector<Edge> edges_, merged_;
    std::vector<KeyedPlane> keyed_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_line_;
    std::vector<bool> used_;
    std::vector<Corner> loop_;
};

/// Above D = 3 a face is the list of its convex pieces, which stay as they are.
template <int D>
requires(D >= 4) class FaceMerger<D> {
public:
    FaceMerger(Kernel<D>& /*kernel*/, PointInterner<D>& /*points*/) {}

    void begin(PlaneId f) {
        plane_ = f;
        pieces_.clear();
    }
    void add(std::span<const Corner> piece) { pieces_.emplace_back(piece.begin(), piece.end()); }
    void finish(FaceList& out, Source source) {
        if (!pieces_.empty()) out.begin_face(plane_, source);
        for (const std::vector<Corner>& piece : pieces_) out.add_loop(piece);
    }

private:
    PlaneId plane_ = no_id;
    std::vector<std::vector<Corner>> pieces_;
};

CLEAVE_END_NAMESPACE

#endif
