// SPDX-License-Identifier: Apache-2.0
/// The convex facets of a boundary, in an operation's kernel: convex faces as they are, others cut along their own
/// edges' planes.
#ifndef CLEAVE_REGION_FACETS_HPP
#define CLEAVE_REGION_FACETS_HPP

#include <cleave/base/error.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Cuts a face of a 3-D boundary into convex facets. The face is a set of directed edges, each with its plane; a cut
/// along a line sends edges to both sides, and the edges along the cut are the ones that make each side close again:
/// walking along the line, the surplus of edges that end over edges that start, summed up.
class KernelFaceCutter {
public:
    struct Edge {
        PointId from;
        PointId to;
        PlaneId plane;
    };

    KernelFaceCutter(Kernel<3>& kernel, PointInterner<3>& points) : kernel_(&kernel), points_(&points) {}

    /// Calls `emit(corners)` for each convex facet of the face on plane f. Requires: the edges are a closed set.
    /// Throws: Error where they cross each other so that no number of cuts makes convex facets of them.
    template <class Emit>
    void cut(PlaneId f, std::vector<Edge> edges, Emit&& emit) {
        std::vector<std::vector<Edge>> work;
        for (Edge& e : edges) {
            e.from = (*points_)(e.from);
            e.to = (*points_)(e.to);
        }
        // n edges lie on n lines, which have at most so many cells between them.
        std::size_t cuts_left = (edges.size() * (edges.size() + 1)) / 2 + 1;
        work.push_back(std::move(edges));
        while (!work.empty()) {
            const std::vector<Edge> part = std::move(work.back());
            work.pop_back();
            const PlaneId h = find_cut(part);
            if (h == no_id) {
                chain(part, emit);
                continue;
            }
            if (cuts_left-- == 0)
                throw Error("a face has crossing edges: an operand intersects itself; check the operands");
            std::vector<Edge> minus;
            std::vector<Edge> plus;
            split(f, h, part, minus, plus);
            if (!plus.empty()) work.push_back(std::move(plus));
            if (!minus.empty()) work.push_back(std::move(minus));
        }
    }

private:
    /// The plane of an edge that has points of the part on its plus side, or `no_id` when the part is convex. Of a few
    /// candidates the one that halves the part best.
    PlaneId find_cut(const std::vector<Edge>& part) {
        PlaneId best = no_id;
        std::size_t best_cost = ~std::size_t(0);
        std::size_t tried = 0;
        const std::size_t n = part.size();
        const std::size_t step = n > 8 ? n / 4 + 1 : 1;  // coprime or not, every edge is visited below
        for (std::size_t offset = 0; offset < step && tried < 4; ++offset) {
            for (std::size_t i = offset; i < n && tried < 4; i += step) {
                std::size_t plus = 0;
                std::size_t minus = 0;
                for (const Edge& e : part) {
                    const Sign s = kernel_->side(part[i].plane, e.from);
                    plus += s == Sign::plus ? 1U : 0U;
                    minus += s == Sign::minus ? 1U : 0U;
                }
                if (plus == 0) continue;
                ++tried;
                const std::size_t cost = plus > minus ? plus - minus : minus - plus;
                if (cost < best_cost) {
                    best_cost = cost;
                    best = part[i].plane;
                }
            }
        }
        return best;
    }

    void split(PlaneId f, PlaneId h, const std::vector<Edge>& part, std::vector<Edge>& minus, std::vector<Edge>& plus) {
        std::vector<std::pair<PointId, int>> lower;
        std::vector<std::pair<PointId, int>> upper;
        for (const Edge& e : part) {
            const Sign a = kernel_->side(h, e.from);
            const Sign b = kernel_->side(h, e.to);
            if (a == Sign::zero && b == Sign::zero) continue;
            if (a * b == Sign::minus) {
                const PointId x = (*points_)(kernel_->cross(h, e.from, e.to, {unoriented(f), unoriented(e.plane)}));
                std::vector<Edge>& first = a == Sign::minus ? minus : plus;
                std::vector<Edge>& second = a == Sign::minus ? plus : minus;
                first.push_back({e.from, x, e.plane});
                second.push_back({x, e.to, e.plane});
                (a == Sign::minus ? lower : upper).push_back({x, 1});
                (a == Sign::minus ? upper : lower).push_back({x, -1});
                continue;
            }
            const bool below = a == Sign::minus || b == Sign::minus;
            (below ? minus : plus).push_back(e);
            if (a == Sign::zero) (below ? lower : upper).push_back({e.from, -1});
            if (b == Sign::zero) (below ? lower : upper).push_back({e.to, 1});
        }
        const AxisDirection d = edge_direction(*kernel_, f, h);
        close(d, h, lower, minus);
        close(d, h, upper, plus);
    }

    /// `ends`: points on the line with the number of edges that end there less those that start.
    void close(const AxisDirection& d, PlaneId h, std::vector<std::pair<PointId, int>>& ends, std::vector<Edge>& part) {
        std::sort(ends.begin(), ends.end(), [&](const auto& a, const auto& b) {
            return a.first != b.first && kernel_->compare(d.axis, b.first, a.first) == d.sign;
        });
        int surplus = 0;
        for (std::size_t i = 0; i < ends.size();) {
            const PointId p = ends[i].first;
            for (; i < ends.size() && ends[i].first == p; ++i) surplus += ends[i].second;
            if (i == ends.size()) break;
            for (int n = 0; n < surplus; ++n) part.push_back({p, ends[i].first, h});
            for (int n = 0; n > surplus; --n) part.push_back({ends[i].first, p, flipped(h)});
        }
    }

    template <class Emit>
    void chain(std::vector<Edge> part, Emit&& emit) {
        std::sort(part.begin(), part.end(), [](const Edge& a, const Edge& b) { return a.from < b.from; });
        std::vector<Corner> loop;
        std::size_t at = 0;
        do {
            loop.push_back({part[at].from, part[at].plane});
            const PointId to = part[at].to;
            at = std::size_t(
                std::lower_bound(part.begin(), part.end(), to, [](const Edge& e, PointId p) { return e.from < p; }) -
                part.begin());
        } while (at != 0 && at < part.size() && loop.size() <= part.size());
        CLEAVE_ASSERT(loop.size() == part.size());
        emit(std::span<const Corner>(loop));
    }

    Kernel<3>* kernel_;
    PointInterner<3>* points_;
};

/// Facets of a boundary, and the face that each belongs to.
template <int D>
struct LoadedFacets {
    std::vector<KernelFacet<D>> facets;
    std::vector<std::uint32_t> face;
};

/// Makes the facets of a loaded boundary.
template <int D>
LoadedFacets<D> make_facets(const Boundary<D>& boundary, const LoadedBoundary<D>& loaded, KernelClip<D>& clip,
                            PointInterner<D>& points) {
    LoadedFacets<D> out;
    out.facets.reserve(boundary.faces.faces.size());
    out.face.reserve(boundary.faces.faces.size());
    std::vector<Corner> corners;
    for (std::uint32_t i = 0; i < boundary.faces.faces.size(); ++i) {
        const FaceList::Face& face = boundary.faces.faces[i];
        const PlaneId plane = loaded.plane(face.plane);
        const auto add = [&](std::span<const Corner> loop) {
            out.facets.push_back(clip.make(plane, loop));
            out.face.push_back(i);
        };
        const auto corners_of = [&](std::uint32_t l) {
            corners.clear();
            for (const Corner& c : boundary.faces.loop(l)) corners.push_back(loaded.corner(c));
        };
        if constexpr (D == 3) {
            corners_of(face.first_loop);
            if (face.loop_count == 1 && corners.size() == 3) {
                add(corners);
                continue;
            }
            std::vector<KernelFaceCutter::Edge> edges;
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                corners_of(l);
                for (std::size_t c = 0; c < corners.size(); ++c)
                    edges.push_back(
                        {corners[c].point, corners[c + 1 == corners.size() ? 0 : c + 1].point, corners[c].edge});
            }
            KernelFaceCutter(clip.kernel(), points).cut(plane, std::move(edges), add);
        } else {
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                corners_of(l);
                add(corners);
            }
        }
    }
    return out;
}

CLEAVE_END_NAMESPACE

#endif
