// SPDX-License-Identifier: Apache-2.0
/// A convex facet cut along segments in it: a binary space partition of the facet alone.
#ifndef CLEAVE_REGION_FACET_PIECES_HPP
#define CLEAVE_REGION_FACET_PIECES_HPP

#include <cleave/clip/kernel_clip.hpp>
#include <cleave/geometry/kernel.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A segment in the plane of a facet, on the line where another plane crosses it.
struct CutSegment {
    PointId from = no_id;
    PointId to = no_id;
    PlaneId plane = no_id;
};

/// Cuts facets into convex pieces that no given segment enters. Each cut runs along a segment's plane to the ends of
/// the piece that it cuts, so pieces have edges where no segment is; but cuts that no piece of a segment calls for are
/// never made, and every edge lies on a plane of the input.
class FacetPieces {
public:
    explicit FacetPieces(KernelClip<3>& clip) : clip_(&clip) {}

    /// Calls `emit(piece)` for each piece of the facet. Requires: the segments lie in the facet's plane.
    /// Cost: O(k log k) cuts of segments for k segments in general position, O(k^2) at worst.
    template <class Emit>
    void cut(const KernelFacet<3>& facet, std::vector<CutSegment> segments, Emit&& emit) {
        keep_inside(facet, segments);
        work_.clear();
        work_.push_back({facet, std::move(segments)});
        while (!work_.empty()) {
            const KernelFacet<3> piece = work_.back().facet;
            const std::vector<CutSegment> inside = std::move(work_.back().segments);
            work_.pop_back();
            if (inside.empty()) {
                emit(piece);
                continue;
            }
            const PlaneId h = choose(inside);
            const Split<KernelFacet<3>> halves = clip_->split(h, piece);
            CLEAVE_ASSERT(halves.side == FacetSide::crossing);
            Part minus{*halves.minus, {}};
            Part plus{*halves.plus, {}};
            for (const CutSegment& s : inside) distribute(piece.plane, h, s, minus.segments, plus.segments);
            work_.push_back(std::move(plus));
            work_.push_back(std::move(minus));
        }
    }

private:
    struct Part {
        KernelFacet<3> facet;
        std::vector<CutSegment> segments;  // each with its inner points inside the facet
    };

    /// Leaves of each segment what runs through the inside of the facet.
    void keep_inside(const KernelFacet<3>& facet, std::vector<CutSegment>& segments) {
        std::vector<CutSegment> kept, outside;
        for (const PlaneId edge : clip_->ridges(facet)) {
            kept.clear();
            for (const CutSegment& s : segments) distribute(facet.plane, edge, s, kept, outside);
            segments.swap(kept);
        }
    }

    /// Adds the parts of a segment on the two sides of h; one that lies in h has none.
    void distribute(PlaneId facet, PlaneId h, const CutSegment& s, std::vector<CutSegment>& minus,
                    std::vector<CutSegment>& plus) {
        Kernel<3>& kernel = clip_->kernel();
        if (unoriented(s.plane) == unoriented(h)) return;
        const Sign a = kernel.side(h, s.from);
        const Sign b = kernel.side(h, s.to);
        if (a * b == Sign::minus) {
            const PointId x = kernel.cross(h, s.from, s.to, {unoriented(facet), unoriented(s.plane)});
            (a == Sign::minus ? minus : plus).push_back({s.from, x, s.plane});
            (a == Sign::minus ? plus : minus).push_back({x, s.to, s.plane});
        } else if (a != Sign::zero || b != Sign::zero) {
            (a == Sign::minus || b == Sign::minus ? minus : plus).push_back(s);
        }
    }

    /// The plane of the segment, of a few, that leaves the larger half smallest.
    PlaneId choose(const std::vector<CutSegment>& segments) {
        constexpr std::size_t tries = 4;
        const std::size_t n = segments.size();
        if (n <= 2) return segments.front().plane;
        PlaneId best = no_id;
        std::size_t best_size = 0;
        for (std::size_t t = 0; t < std::min(tries, n); ++t) {
            const PlaneId h = segments[t * n / std::min(tries, n)].plane;
            std::size_t minus = 0;
            std::size_t plus = 0;
            for (const CutSegment& s : segments) {
                if (unoriented(s.plane) == unoriented(h)) continue;
                const Sign a = clip_->kernel().side(h, s.from);
                const Sign b = clip_->kernel().side(h, s.to);
                minus += a == Sign::minus || b == Sign::minus ? 1U : 0U;
                plus += a == Sign::plus || b == Sign::plus ? 1U : 0U;
            }
            if (best == no_id || std::max(minus, plus) < best_size) {
                best = h;
                best_size = std::max(minus, plus);
            }
        }
        return best;
    }

    KernelClip<3>* clip_;
    std::vector<Part> work_;
};

CLEAVE_END_NAMESPACE

#endif
