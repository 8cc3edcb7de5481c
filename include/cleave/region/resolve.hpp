// SPDX-License-Identifier: Apache-2.0
/// `resolve`: the set that a closed surface describes by a winding rule, however it runs through itself.
#ifndef CLEAVE_REGION_RESOLVE_HPP
#define CLEAVE_REGION_RESOLVE_HPP

#include <cleave/base/disjoint_sets.hpp>
#include <cleave/base/winding_rule.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/geometry/box_pairs.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/convex_facets.hpp>
#include <cleave/region/face_merge.hpp>
#include <cleave/region/facet_meeting.hpp>
#include <cleave/region/facet_pieces.hpp>
#include <cleave/region/facet_winding.hpp>
#include <cleave/region/facets.hpp>
#include <cleave/region/make.hpp>
#include <cleave/region/region.hpp>
#include <cleave/region/resolve_segments.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Resolves one surface in 3-D.
///
/// Each convex facet is cut where other facets enter it, so that the winding numbers above and below a piece are
/// constant. Facets that nothing enters share them with their neighbours across edges that nothing else touches: one
/// ray tells them for a whole part of the surface that runs free. A piece is kept where the rule tells its sides apart,
/// turned round where the set is on its plus side; of pieces that coincide, that of the first facet.
class SurfaceResolver {
public:
    /// Requires: the faces' edges cancel out along every line, no face is unbounded, and the boundary is complete.
    static Boundary<3> resolve(const Boundary<3>& boundary, WindingRule rule, ProgressReporter& progress) {
        return SurfaceResolver(boundary, rule, progress).run();
    }

private:
    enum class Fate : std::uint8_t { drop, keep, flip };

    SurfaceResolver(const Boundary<3>& boundary, WindingRule rule, ProgressReporter& progress)
        : boundary_(&boundary),
          rule_(rule),
          progress_(&progress),
          clip_(kernel_),
          points_(kernel_),
          facets_(kernel_),
          loaded_(load(boundary, kernel_)) {
        LoadedFacets<3> made = make_facets(boundary, loaded_, clip_, points_);
        handles_ = std::move(made.facets);
        std::vector<Corner> loop;
        for (std::uint32_t f = 0; f < handles_.size(); ++f) {
            loop.clear();
            for (const Corner& c : clip_.corners(handles_[f])) loop.push_back({points_(c.point), c.edge});
            facets_.add(made.face[f], handles_[f].plane, loop);
        }
        touched_.assign(facets_.size() == 0 ? 0 : end_of(static_cast<std::uint32_t>(facets_.size() - 1)), false);
    }

    Boundary<3> run() {
        find_mates();
        compare_facets();
        std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
            return std::array{a.facet, a.segment.plane, a.segment.from, a.segment.to} <
                   std::array{b.facet, b.segment.plane, b.segment.from, b.segment.to};
        });
        std::sort(coplanar_.begin(), coplanar_.end());
        return assemble();
    }

    [[nodiscard]] std::uint32_t end_of(std::uint32_t f) const { return facets_[f].first + facets_[f].size; }

    /// Finds for each edge the one other facet that has it, run the other way, if there is just one.
    void find_mates() {
        struct Use {
            std::uint64_t ends;
            std::uint32_t corner;
            std::uint32_t facet;
            bool forward;
        };
        std::vector<Use> uses;
        uses.reserve(touched_.size());
        for (std::uint32_t f = 0; f < facets_.size(); ++f) {
            for (std::size_t i = 0; i < facets_[f].size; ++i) {
                const PointId p = facets_.corner(f, i);
                const PointId q = facets_.corner(f, facets_.next(f, i));
                uses.push_back({(std::uint64_t(std::min(p, q)) << 32U) | std::max(p, q),
                                facets_[f].first + static_cast<std::uint32_t>(i), f, p < q});
            }
        }
        std::sort(uses.begin(), uses.end(),
                  [](const Use& a, const Use& b) { return std::pair(a.ends, a.corner) < std::pair(b.ends, b.corner); });
        mate_.assign(touched_.size(), no_id);
        for (std::size_t i = 0; i < uses.size();) {
            std::size_t j = i;
            while (j < uses.size() && uses[j].ends == uses[i].ends) ++j;
            if (j - i == 2 && uses[i].forward != uses[i + 1].forward) {
                mate_[uses[i].corner] = uses[i + 1].facet;
                mate_[uses[i + 1].corner] = uses[i].facet;
            }
            i = j;
        }
    }

    void compare_facets() {
        std::vector<NamedBox<3>> boxes(facets_.size());
        for (std::uint32_t f = 0; f < boxes.size(); ++f) boxes[f] = {facets_.bounds(f), f};
        FacetMeetings meetings(facets_);
        progress_->begin("comparing faces", 6 * boxes.size());
        for_each_meeting_pair<3>(boxes, [&](std::uint32_t x, std::uint32_t y) {
            progress_->advance();
            const auto [a, b] = std::minmax(x, y);
            if (facets_[a].face == facets_[b].face) return;  // they tile it
            const std::optional<MeetingKind> decided = meetings.decide(a, b);
            if (decided && *decided <= MeetingKind::shared) return;
            record(a, b, meetings.meet(a, b));
        });
        progress_->finish();
    }

    void record(std::uint32_t a, std::uint32_t b, const FacetMeeting& meeting) {
        if (meeting.kind == MeetingKind::overlap) {
            coplanar_.push_back({a, b});
            coplanar_.push_back({b, a});
            cut_along_edges(a, b);
            cut_along_edges(b, a);
        }
        if (meeting.kind == MeetingKind::overlap ||
            (meeting.kind == MeetingKind::touch && facets_.are_known_coplanar(a, b))) {
            for (const std::uint32_t f : {a, b})
                for (std::uint32_t c = facets_[f].first; c < end_of(f); ++c) touched_[c] = true;
        } else if (meeting.from != no_id) {
            meet_along(a, b, meeting, meeting.through_first);
            meet_along(b, a, meeting, meeting.through_second);
        }
    }

    /// Facet g meets facet f in a segment, which runs through f or along edges of it.
    void meet_along(std::uint32_t f, std::uint32_t g, const FacetMeeting& meeting, bool through) {
        if (through) {
            cuts_.push_back({f, {meeting.from, meeting.to, facets_.plane(g)}});
            return;
        }
        const PlaneId h = facets_.plane(g);
        for (std::size_t i = 0; i < facets_[f].size; ++i) {
            const std::size_t c = facets_[f].first + i;
            if (mate_[c] != g && kernel_.side(h, facets_.corner(f, i)) == Sign::zero &&
                kernel_.side(h, facets_.corner(f, facets_.next(f, i))) == Sign::zero)
                touched_[c] = true;
        }
    }

    /// Facet g overlaps facet f, which its edges cut.
    void cut_along_edges(std::uint32_t f, std::uint32_t g) {
        for (std::size_t i = 0; i < facets_[g].size; ++i)
            cuts_.push_back({f, {facets_.corner(g, i), facets_.corner(g, facets_.next(g, i)), facets_.edge(g, i)}});
    }

    /// One piece of a face of the result.
    struct Piece {
        KernelFacet<3> facet;
        Fate fate;
    };

    Boundary<3> assemble() {
        join_free_facets();
        const int at_infinity = boundary_->value_at_infinity ? 1 : 0;
        FacetWinding winding(facets_, at_infinity);
        std::vector<std::optional<int>> plus_of(facets_.size());  // by the first facet of a free part
        FacetPieces cutter(clip_);
        FaceList list;
        std::vector<Piece> pieces;
        progress_->begin("resolving faces", boundary_->faces.faces.size());
        for (std::uint32_t f = 0; f < facets_.size();) {
            const std::uint32_t face = facets_[f].face;
            pieces.clear();
            bool whole = true;
            for (; f < facets_.size() && facets_[f].face == face; ++f) {
                const std::vector<std::uint32_t> others = coplanar_with(f);
                if (!is_cut(f)) {
                    pieces.push_back({handles_[f], fate_of_whole(f, others, winding, plus_of)});
                    whole = whole && pieces.back().fate == pieces.front().fate;
                    continue;
                }
                const std::size_t before = pieces.size();
                cutter.cut(handles_[f], segments_of(f), [&](const KernelFacet<3>& piece) {
                    const std::vector<Corner> corners = corners_of(piece);
                    pieces.push_back({piece, fate_of(winding.beside(f, corners, others), f)});
                });
                whole = whole && pieces.size() == before + 1 && pieces.back().fate == pieces.front().fate;
            }
            emit(face, pieces, whole, list);
            progress_->advance();
        }
        progress_->finish();
        Boundary<3> out = freeze(kernel_, list, is_inside(rule_, at_infinity), points_);
        out.is_conforming = unchanged_ && boundary_->is_conforming;
        return out;
    }

    /// Facets that nothing enters are joined across edges that nothing else touches.
    void join_free_facets() {
        free_.emplace(facets_.size());
        for (std::uint32_t f = 0; f < facets_.size(); ++f) {
            if (is_cut(f)) continue;
            for (std::uint32_t c = facets_[f].first; c < end_of(f); ++c)
                if (mate_[c] != no_id && !touched_[c] && !is_cut(mate_[c])) free_->join(f, mate_[c]);
        }
    }

    Fate fate_of_whole(std::uint32_t f, std::span<const std::uint32_t> others, FacetWinding& winding,
                       std::vector<std::optional<int>>& plus_of) {
        std::optional<int>& plus = plus_of[free_->find(f)];
        if (others.empty() && plus) return fate_of({*plus + 1, *plus, f}, f);
        const FacetWinding::Sides sides = winding.beside(f, corners_of(handles_[f]), others);
        plus = sides.plus;
        return fate_of(sides, f);
    }

    [[nodiscard]] Fate fate_of(const FacetWinding::Sides& sides, std::uint32_t f) const {
        const bool below = is_inside(rule_, sides.minus);
        if (below == is_inside(rule_, sides.plus) || sides.first != f) return Fate::drop;
        return below ? Fate::keep : Fate::flip;
    }

    /// Adds what the rule keeps of a face. `whole`: all of it has one fate, and it comes back as it went in.
    void emit(std::uint32_t face, std::span<const Piece> pieces, bool whole, FaceList& list) {
        const FaceList::Face& given = boundary_->faces.faces[face];
        const PlaneId plane = loaded_.plane(given.plane);
        unchanged_ = unchanged_ && whole && !pieces.empty() && pieces.front().fate == Fate::keep;
        std::vector<Corner> loop;
        for (const Fate fate : {Fate::keep, Fate::flip}) {
            const PlaneId side = fate == Fate::keep ? plane : flipped(plane);
            if (whole) {
                if (pieces.empty() || pieces.front().fate != fate) continue;
                list.begin_face(side, given.source);
                for (std::uint32_t l = given.first_loop; l < given.first_loop + given.loop_count; ++l) {
                    loop.clear();
                    for (const Corner& c : boundary_->faces.loop(l)) loop.push_back(loaded_.corner(c));
                    if (fate == Fate::flip) reverse_loop<3>(loop);
                    list.add_loop(loop);
                }
                continue;
            }
            FaceMerger<3> merger(kernel_, points_);
            merger.begin(side);
            for (const Piece& piece : pieces) {
                if (piece.fate != fate) continue;
                loop = corners_of(piece.facet);
                if (fate == Fate::flip) reverse_loop<3>(loop);
                merger.add(loop);
            }
            merger.finish(list, given.source);
        }
    }

    [[nodiscard]] std::vector<Corner> corners_of(const KernelFacet<3>& facet) const {
        const std::span<const Corner> corners = clip_.corners(facet);
        return {corners.begin(), corners.end()};
    }

    struct Cut {
        std::uint32_t facet;
        CutSegment segment;
    };

    [[nodiscard]] auto first_cut(std::uint32_t f) const {
        return std::lower_bound(cuts_.begin(), cuts_.end(), f,
                                [](const Cut& c, std::uint32_t facet) { return c.facet < facet; });
    }
    [[nodiscard]] bool is_cut(std::uint32_t f) const {
        const auto at = first_cut(f);
        return at != cuts_.end() && at->facet == f;
    }
    [[nodiscard]] std::vector<CutSegment> segments_of(std::uint32_t f) const {
        std::vector<CutSegment> out;
        for (auto c = first_cut(f); c != cuts_.end() && c->facet == f; ++c) out.push_back(c->segment);
        return out;
    }
    [[nodiscard]] std::vector<std::uint32_t> coplanar_with(std::uint32_t f) const {
        std::vector<std::uint32_t> out;
        for (auto c = std::lower_bound(coplanar_.begin(), coplanar_.end(), std::pair(f, 0U));
             c != coplanar_.end() && c->first == f; ++c)
            out.push_back(c->second);
        return out;
    }

    const Boundary<3>* boundary_;
    WindingRule rule_;
    ProgressReporter* progress_;
    Kernel<3> kernel_;
    KernelClip<3> clip_;
    PointInterner<3> points_;
    ConvexFacets facets_;
    LoadedBoundary<3> loaded_;
    std::vector<KernelFacet<3>> handles_;  // of the facets, for cutting
    std::vector<std::uint32_t> mate_;      // per corner: the other facet at the edge that starts there
    std::vector<bool> touched_;            // per corner: whether a third facet meets that edge in a stretch
    std::vector<Cut> cuts_;                // sorted
    std::vector<std::pair<std::uint32_t, std::uint32_t>> coplanar_;  // facets that overlap, both ways; sorted
    std::optional<DisjointSets> free_;
    bool unchanged_ = true;
};

/// The set of points whose winding number with respect to a closed surface the rule takes for inside. The surface may
/// cross, overlap and touch itself in any way, face inward or outward, and come in several parts.
/// Requires: along every line, the faces' edges cancel out (D = 2: at every point, as many segments start as end); no
/// face is unbounded; the boundary is complete.
/// Throws: Cancelled.
/// Cost: O(n log n) and what crosses: for each face a local partition by the faces that enter it, for each piece of it
/// and for each part of the surface that nothing touches an exact ray through a hierarchy of boxes.
template <int D>
requires(D == 2 || D == 3) [[nodiscard]] Boundary<D> resolve(const Boundary<D>& boundary, WindingRule rule,
                                                             ProgressReporter* progress = nullptr) {
    ProgressReporter silent;
    ProgressReporter& reporter = progress != nullptr ? *progress : silent;
    CLEAVE_REQUIRES(boundary.is_finite && boundary.is_complete);
    if constexpr (D == 2) {
        return SegmentResolver::resolve(boundary, rule, reporter);
    } else {
        return SurfaceResolver::resolve(boundary, rule, reporter);
    }
}

/// The set that closed loops of points describe by a winding rule: loops may cross themselves and each other, run
/// either way round, overlap and repeat. A loop that is a point or runs to and fro adds nothing. Sources count edges.
/// Throws: Cancelled.
template <class N = Rational>
[[nodiscard]] Region<2, N> resolve(std::span<const std::vector<std::array<N, 2>>> loops, WindingRule rule,
                                   ProgressReporter* progress = nullptr) {
    Kernel<2> kernel;
    PointInterner<2> points(kernel);
    PolygonBuilder builder(kernel);
    std::uint32_t edge = 0;
    for (const std::vector<std::array<N, 2>>& loop : loops) {
        std::vector<PointId> ids;
        for (const std::array<N, 2>& x : loop) ids.push_back(points(add_point<N, 2>(kernel, x)));
        for (std::size_t i = 0; i < ids.size(); ++i, ++edge) {
            const PointId next = ids[i + 1 == ids.size() ? 0 : i + 1];
            if (ids[i] != next) builder.add(ids[i], next, {0, edge});
        }
    }
    return Region<2, N>(resolve<2>(freeze(kernel, builder.finish(), false, points), rule, progress));
}

/// One loop: `resolve<Rational>({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, WindingRule::non_zero)`.
template <class N = Rational>
[[nodiscard]] Region<2, N> resolve(const std::vector<std::array<N, 2>>& loop, WindingRule rule,
                                   ProgressReporter* progress = nullptr) {
    return resolve<N>(std::span<const std::vector<std::array<N, 2>>>(&loop, 1), rule, progress);
}

CLEAVE_END_NAMESPACE

#endif
