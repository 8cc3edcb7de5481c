// SPDX-License-Identifier: Apache-2.0
/// Convex polytopes as loops of a boundary, and back.
///
/// | D    | a loop of a boundary                                                                          |
/// |------|-----------------------------------------------------------------------------------------------|
/// | 1    | one corner                                                                                    |
/// | 2    | two corners, the outside on the right                                                         |
/// | 3    | corners counter-clockwise as seen from outside; polygons may be non-convex and have holes     |
/// | >= 4 | one convex facet: for each vertex and each bounding plane through it a corner (point, plane)  |
#ifndef CLEAVE_REGION_POLYTOPE_FACES_HPP
#define CLEAVE_REGION_POLYTOPE_FACES_HPP

#include <cleave/base/contract.hpp>
#include <cleave/clip/polytope_clip.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

namespace detail {

/// Of the planes in `through` one other than k, an ordinary one if there is any, oriented so that `inside` is on its
/// minus side.
template <int D>
PlaneId bounding_plane(Kernel<D>& kernel, std::uint32_t k, std::span<const std::uint32_t> through, PointId inside) {
    std::uint32_t best = no_id;
    for (const std::uint32_t e : through) {
        if (e == k) continue;
        if (best == no_id || (kernel.planes.reach(best) != 0 && kernel.planes.reach(e) == 0)) best = e;
    }
    CLEAVE_ASSERT(best != no_id);
    const Sign s = kernel.side(2 * best, inside);
    CLEAVE_ASSERT(s != Sign::zero);
    return s == Sign::minus ? 2 * best : flipped(2 * best);
}

}  // namespace detail

/// Appends the loop of a convex facet on an oriented plane. Requires: `body` has its edges.
template <int D>
void append_loop(Kernel<D>& kernel, PlaneId plane, const Polytope& body, std::vector<Corner>& loop) {
    if constexpr (D == 1) {
        loop.push_back({body.points.front(), no_id});
    } else if constexpr (D == 2) {
        const AxisDirection d = edge_direction(kernel, plane, no_id);
        const bool ahead = kernel.compare(d.axis, body.points[1], body.points[0]) == d.sign;
        for (const std::size_t i : {std::size_t(ahead ? 0 : 1), std::size_t(ahead ? 1 : 0)})
            loop.push_back({body.points[i],
                            detail::bounding_plane(kernel, unoriented(plane), body.planes_of(i), body.points[1 - i])});
    } else if constexpr (D == 3) {
        // The corner at which each directed edge starts, and where the edge ends.
        std::vector<std::pair<Corner, std::uint32_t>> start(body.size());
        std::vector<std::uint32_t> shared;
        for (const auto& [i, j] : body.edges) {
            const std::span<const std::uint32_t> a = body.planes_of(i);
            const std::span<const std::uint32_t> b = body.planes_of(j);
            shared.clear();
            std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
            std::size_t off = 0;
            while (off == i || off == j) ++off;
            const PlaneId e = detail::bounding_plane(kernel, unoriented(plane), shared, body.points[off]);
            const AxisDirection d = edge_direction(kernel, plane, e);
            const bool forward = kernel.compare(d.axis, body.points[j], body.points[i]) == d.sign;
            start[forward ? i : j] = {Corner{body.points[forward ? i : j], e}, forward ? j : i};
        }
        std::uint32_t at = 0;
        do {
            loop.push_back(start[at].first);
            at = start[at].second;
        } while (at != 0 && loop.size() <= body.size());
        CLEAVE_ASSERT(loop.size() == body.size());
    } else {
        for (std::size_t i = 0; i < body.size(); ++i)
            for (const std::uint32_t k : body.planes_of(i)) loop.push_back({body.points[i], 2 * k});
    }
}

/// The facet that a loop of a D >= 4 boundary describes, in the kernel it was loaded into, with its edges.
template <int D>
requires(D >= 4) [[nodiscard]] Polytope
    polytope_of(PolytopeClip<D>& clip, std::span<const Corner> loop, const LoadedBoundary<D>& loaded) {
    Polytope body;
    std::vector<std::uint32_t> through;
    for (std::size_t i = 0; i < loop.size();) {
        const std::size_t first = i;
        through.clear();
        for (; i < loop.size() && loop[i].point == loop[first].point; ++i)
            through.push_back(unoriented(loaded.plane(loop[i].edge)));
        std::sort(through.begin(), through.end());
        body.add_vertex(loaded.first_point + loop[first].point, through);
    }
    clip.find_edges(body);
    return body;
}

/// Facets of a D >= 4 boundary, and the face that each belongs to.
template <int D>
struct LoadedPolytopes {
    std::vector<PolytopeFacet<D>> facets;
    std::vector<std::uint32_t> face;
};

/// Copies a boundary into the model's kernel and makes its facets.
template <int D>
[[nodiscard]] LoadedPolytopes<D> load_polytopes(const Boundary<D>& boundary, PolytopeClip<D>& clip) {
    const LoadedBoundary<D> loaded = load(boundary, clip.kernel());
    LoadedPolytopes<D> out;
    for (std::uint32_t i = 0; i < boundary.faces.faces.size(); ++i) {
        const FaceList::Face& face = boundary.faces.faces[i];
        for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            out.facets.push_back(
                clip.make(loaded.plane(face.plane), polytope_of(clip, boundary.faces.loop(l), loaded)));
            out.face.push_back(i);
        }
    }
    return out;
}

CLEAVE_END_NAMESPACE

#endif
