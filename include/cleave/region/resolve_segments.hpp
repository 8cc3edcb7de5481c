// SPDX-License-Identifier: Apache-2.0
/// Resolving closed curves of segments in the plane, however they cross, overlap and run around.
#ifndef CLEAVE_REGION_RESOLVE_SEGMENTS_HPP
#define CLEAVE_REGION_RESOLVE_SEGMENTS_HPP

#include <cleave/base/disjoint_sets.hpp>
#include <cleave/base/winding_rule.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/geometry/box_hierarchy.hpp>
#include <cleave/geometry/box_pairs.hpp>
#include <cleave/geometry/kernel_box.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/build.hpp>
#include <cleave/region/face_merge.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Resolves one set of segments. Every segment is cut at every point where another one meets it, so the winding numbers
/// on the two sides of a piece are constant; pieces share them across points where only the two of them meet, and an
/// exact ray tells them for each chain of such pieces.
class SegmentResolver {
public:
    /// Requires: at every point, as many segments start as end; all are finite.
    static Boundary<2> resolve(const Boundary<2>& boundary, WindingRule rule, ProgressReporter& progress) {
        return SegmentResolver(boundary, rule, progress).run();
    }

private:
    struct Segment {
        PlaneId line;
        Corner from;
        Corner to;
        Source source;
    };

    /// A point in the middle of a segment where another line meets it.
    struct Node {
        std::uint32_t segment;
        PointId point;
        PlaneId line;
    };

    /// A segment between two nodes. Its corners' lines have it on their minus sides.
    struct Piece {
        std::uint32_t segment;
        Corner from;
        Corner to;
    };

    struct Sides {
        int minus = 0;
        int plus = 0;
    };

    SegmentResolver(const Boundary<2>& boundary, WindingRule rule, ProgressReporter& progress)
        : boundary_(&boundary), rule_(rule), progress_(&progress), points_(kernel_) {
        const LoadedBoundary<2> loaded = load(boundary, kernel_);
        for (const FaceList::Face& face : boundary.faces.faces) {
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                Corner from = loaded.corner(boundary.faces.loop(l)[0]);
                Corner to = loaded.corner(boundary.faces.loop(l)[1]);
                from.point = points_(from.point);
                to.point = points_(to.point);
                segments_.push_back({loaded.plane(face.plane), from, to, face.source});
            }
        }
    }

    Boundary<2> run() {
        compare_segments();
        make_pieces();
        join_chains();
        std::vector<Box<2>> boxes;
        for (const Segment& s : segments_)
            boxes.push_back(hull(box_of(kernel_, s.from.point), box_of(kernel_, s.to.point)));
        hierarchy_ = BoxHierarchy<2>(boxes);
        FaceList list;
        FaceMerger<2> merger(kernel_, points_);
        std::vector<std::optional<int>> plus_of(pieces_.size());
        progress_->begin("resolving segments", pieces_.size());
        for (std::size_t p = 0; p < pieces_.size();) {
            const std::uint32_t segment = pieces_[p].segment;
            std::vector<Piece> kept, turned;
            for (; p < pieces_.size() && pieces_[p].segment == segment; ++p) {
                progress_->advance();
                const auto [step, is_first] = covering(pieces_[p]);
                std::optional<int>& plus = plus_of[chains_->find(static_cast<std::uint32_t>(p))];
                if (!plus) plus = plus_side(pieces_[p], step);
                const bool below = is_inside(rule_, *plus + step);
                if (!is_first || below == is_inside(rule_, *plus)) continue;
                (below ? kept : turned).push_back(pieces_[p]);
            }
            emit(segments_[segment].line, segments_[segment].source, kept, false, merger, list);
            emit(flipped(segments_[segment].line), segments_[segment].source, turned, true, merger, list);
        }
        progress_->finish();
        return freeze(kernel_, list, is_inside(rule_, at_infinity()), points_);
    }

    [[nodiscard]] int at_infinity() const { return boundary_->value_at_infinity ? 1 : 0; }

    // --- where segments meet --------------------------------------------------------------------------------------

    void compare_segments() {
        std::vector<NamedBox<2>> boxes(segments_.size());
        for (std::uint32_t s = 0; s < boxes.size(); ++s) {
            boxes[s].name = s;
            for (const PointId p : {segments_[s].from.point, segments_[s].to.point}) {
                kernel_.refine(p);
                boxes[s].box.include(kernel_.point(p).approximation, kernel_.point(p).error);
            }
        }
        progress_->begin("comparing segments", 2 * boxes.size());
        for_each_meeting_pair<2>(boxes, [&](std::uint32_t a, std::uint32_t b) {
            progress_->advance();
            if (unoriented(segments_[a].line) == unoriented(segments_[b].line)) {
                meet_on_line(a, b);
                meet_on_line(b, a);
            } else {
                meet_in_point(a, b);
            }
        });
        progress_->finish();
    }

    /// The ends of g in the middle of f, on the same line, and whether they overlap.
    void meet_on_line(std::uint32_t f, std::uint32_t g) {
        for (const Corner& end : {segments_[g].from, segments_[g].to})
            if (is_between(f, end.point)) nodes_.push_back({f, end.point, end.edge});
        const bool ends_first = !before(segments_[f].line, low(g), high(f));
        const bool starts_last = !before(segments_[f].line, low(f), high(g));
        if (!ends_first && !starts_last) collinear_.push_back({f, g});
    }

    /// Whether p comes before q along the line, in a direction that is the same for both its orientations.
    bool before(PlaneId line, PointId p, PointId q) {
        const AxisDirection d = edge_direction(kernel_, line & ~1U, no_id);
        return p != q && kernel_.compare(d.axis, q, p) == d.sign;
    }
    [[nodiscard]] PointId low(std::uint32_t s) const {
        return is_flipped(segments_[s].line) ? segments_[s].to.point : segments_[s].from.point;
    }
    [[nodiscard]] PointId high(std::uint32_t s) const {
        return is_flipped(segments_[s].line) ? segments_[s].from.point : segments_[s].to.point;
    }
    bool is_between(std::uint32_t s, PointId p) {
        return before(segments_[s].line, low(s), p) && before(segments_[s].line, p, high(s));
    }

    void meet_in_point(std::uint32_t a, std::uint32_t b) {
        const Segment& f = segments_[a];
        const Segment& g = segments_[b];
        const Sign g_from = kernel_.side(f.line, g.from.point);
        const Sign g_to = kernel_.side(f.line, g.to.point);
        if (g_from * g_to == Sign::plus) return;
        const Sign f_from = kernel_.side(g.line, f.from.point);
        const Sign f_to = kernel_.side(g.line, f.to.point);
        if (f_from * f_to == Sign::plus) return;
        PointId x = no_id;
        if (g_from == Sign::zero)
            x = g.from.point;
        else if (g_to == Sign::zero)
            x = g.to.point;
        else if (f_from == Sign::zero)
            x = f.from.point;
        else if (f_to == Sign::zero)
            x = f.to.point;
        else
            x = points_(kernel_.cross(g.line, f.from.point, f.to.point, {unoriented(f.line)}));
        if (f_from * f_to == Sign::minus) nodes_.push_back({a, x, g.line});
        if (g_from * g_to == Sign::minus) nodes_.push_back({b, x, f.line});
    }

    // --- pieces ---------------------------------------------------------------------------------------------------

    void make_pieces() {
        std::sort(nodes_.begin(), nodes_.end(), [&](const Node& x, const Node& y) {
            if (x.segment != y.segment) return x.segment < y.segment;
            if (x.point == y.point) return x.line < y.line;
            const PlaneId line = segments_[x.segment].line;
            return is_flipped(line) ? before(line, y.point, x.point) : before(line, x.point, y.point);
        });
        std::sort(collinear_.begin(), collinear_.end());
        auto node = nodes_.begin();
        for (std::uint32_t s = 0; s < segments_.size(); ++s) {
            const Segment& segment = segments_[s];
            Corner from = segment.from;
            for (; node != nodes_.end() && node->segment == s; ++node) {
                if (node->point == from.point) continue;
                const bool start_inside = kernel_.side(node->line, segment.from.point) == Sign::minus;
                const PlaneId end = start_inside ? node->line : flipped(node->line);
                pieces_.push_back({s, from, {node->point, end}});
                from = {node->point, flipped(end)};
            }
            pieces_.push_back({s, from, segment.to});
        }
    }

    /// Joins pieces at points where one ends, one starts, and nothing else is.
    void join_chains() {
        struct End {
            PointId point;
            bool starts;
            std::uint32_t piece;
        };
        std::vector<End> ends;
        for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
            ends.push_back({pieces_[p].from.point, true, p});
            ends.push_back({pieces_[p].to.point, false, p});
        }
        std::sort(ends.begin(), ends.end(),
                  [](const End& x, const End& y) { return std::pair(x.point, x.piece) < std::pair(y.point, y.piece); });
        chains_.emplace(pieces_.size());
        for (std::size_t i = 0; i < ends.size();) {
            std::size_t j = i;
            while (j < ends.size() && ends[j].point == ends[i].point) ++j;
            if (j - i == 2 && ends[i].starts != ends[i + 1].starts) chains_->join(ends[i].piece, ends[i + 1].piece);
            i = j;
        }
    }

    // --- winding numbers ------------------------------------------------------------------------------------------

    /// By how much the winding number is larger on the minus side of the piece, and whether its segment is the first of
    /// those that cover it.
    std::pair<int, bool> covering(const Piece& piece) {
        const std::uint32_t s = piece.segment;
        const PlaneId line = segments_[s].line;
        const PointId first = is_flipped(line) ? piece.to.point : piece.from.point;
        const PointId last = is_flipped(line) ? piece.from.point : piece.to.point;
        int step = 1;
        bool is_first = true;
        for (auto c = std::lower_bound(collinear_.begin(), collinear_.end(), std::pair(s, 0U));
             c != collinear_.end() && c->first == s; ++c) {
            const std::uint32_t g = c->second;
            if (before(line, first, low(g)) || before(line, high(g), last)) continue;
            step += segments_[g].line == line ? 1 : -1;
            is_first = is_first && s < g;
        }
        return {step, is_first};
    }

    /// The winding number on the plus side of a piece: a ray from inside it along the axis on which its normal is
    /// longest. Where the ray would pass through an end of a segment, the point counts as moved by an infinitesimal
    /// along the other axis.
    int plus_side(const Piece& piece, int step) {
        const PlaneId line = segments_[piece.segment].line;
        const int axis = dominant_axis(kernel_, unoriented(line));
        const int other = 1 - axis;
        const PointId p = inner_point(piece, axis);
        Box<2> ray = box_of(kernel_, p);
        ray.hi[std::size_t(axis)] = std::numeric_limits<double>::infinity();
        int above = at_infinity();
        hierarchy_.for_each_meeting(ray, [&](std::size_t i) {
            const Segment& g = segments_[i];
            if (unoriented(g.line) == unoriented(line)) return;
            const bool from_below = kernel_.compare(other, g.from.point, p) != Sign::plus;
            const bool to_below = kernel_.compare(other, g.to.point, p) != Sign::plus;
            if (from_below == to_below) return;
            const Sign up = normal_sign(g.line, axis);
            if (kernel_.side(g.line, p) == -up) above += up == Sign::plus ? 1 : -1;
        });
        return normal_sign(line, axis) == Sign::plus ? above : above - step;
    }

    [[nodiscard]] Sign normal_sign(PlaneId h, int axis) const {
        const Sign s = kernel_.planes.exact(unoriented(h))[std::size_t(axis)].sign();
        return is_flipped(h) ? -s : s;
    }

    /// A point inside the piece: above the rounded middle of it, or else the exact middle.
    PointId inner_point(const Piece& piece, int axis) {
        const auto a = std::size_t(axis);
        const auto u = 1 - a;
        kernel_.refine(piece.from.point);
        kernel_.refine(piece.to.point);
        std::array<double, 2> middle{};
        middle[u] =
            kernel_.point(piece.from.point).approximation[u] / 2 + kernel_.point(piece.to.point).approximation[u] / 2;
        if (std::isfinite(middle[u])) {
            const Homogeneous<2> at = homogeneous_of<2>(middle);
            const auto& n = kernel_.planes.exact(unoriented(segments_[piece.segment].line));
            WideInteger height(n[2] * WideInteger(at[2]));
            add_product(height, n[u], at[u]);
            Homogeneous<2> h;
            h[u] = Integer(at[u] * WideInteger(n[a]));
            h[a] = Integer(-height);
            h[2] = Integer(at[2] * WideInteger(n[a]));
            if (h[2].sign() == Sign::minus)
                for (Integer& x : h) x.negate();
            const PointId p = kernel_.add_point(std::move(h));
            const Sign after = kernel_.compare(int(u), piece.from.point, p);
            if (after != Sign::zero && after == kernel_.compare(int(u), p, piece.to.point)) return p;
        }
        const Homogeneous<2> x = kernel_.coordinates(piece.from.point);
        const Homogeneous<2> y = kernel_.coordinates(piece.to.point);
        Homogeneous<2> h;
        for (std::size_t i = 0; i < 2; ++i) {
            WideInteger sum(x[i] * WideInteger(y[2]));
            add_product(sum, y[i], x[2]);
            h[i] = Integer(sum);
        }
        WideInteger weight(x[2] * WideInteger(y[2]));
        weight += x[2] * WideInteger(y[2]);
        h[2] = Integer(weight);
        return kernel_.add_point(std::move(h));
    }

    static void emit(PlaneId line, Source source, const std::vector<Piece>& pieces, bool turn, FaceMerger<2>& merger,
                     FaceList& list) {
        merger.begin(line);
        for (const Piece& p : pieces) {
            const std::array<Corner, 2> corners = turn ? std::array{p.to, p.from} : std::array{p.from, p.to};
            merger.add(corners);
        }
        merger.finish(list, source);
    }

    const Boundary<2>* boundary_;
    WindingRule rule_;
    ProgressReporter* progress_;
    Kernel<2> kernel_;
    PointInterner<2> points_;
    std::vector<Segment> segments_;
    std::vector<Node> nodes_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> collinear_;  // segments that overlap, both ways; sorted
    std::vector<Piece> pieces_;                                       // in the order of segments, each from its start
    std::optional<DisjointSets> chains_;
    BoxHierarchy<2> hierarchy_;
};

CLEAVE_END_NAMESPACE

#endif
