// SPDX-License-Identifier: Apache-2.0
/// The edges of a 3-D boundary cut at every vertex that lies on them, so that faces meet in whole edges.
#ifndef CLEAVE_QUERY_BOUNDARY_EDGES_HPP
#define CLEAVE_QUERY_BOUNDARY_EDGES_HPP

#include <cleave/region/boundary.hpp>
#include <cleave/region/conform.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A piece of a face's edge from one vertex to the next, the face on its left as seen from outside.
struct BoundaryEdge {
    PointId from = no_id;  ///< in the kernel
    PointId to = no_id;
    PlaneId plane = no_id;     ///< another plane through the edge, the face on its minus side
    std::uint32_t face = 0;    ///< of the boundary
    std::uint32_t next = 0;    ///< the edge that follows in the face's loop
    std::uint32_t corner = 0;  ///< of the boundary: where the whole edge starts
};

/// All of them, by face and by the two points that they join.
class BoundaryEdges {
public:
    BoundaryEdges(Kernel<3>& kernel, const Boundary<3>& boundary, const LoadedBoundary<3>& loaded) {
        const FaceList& faces = boundary.faces;
        const Conformer conformer(kernel, boundary, loaded);
        edges_.reserve(faces.corners.size() + conformer.inserted());
        for (std::uint32_t f = 0; f < faces.faces.size(); ++f) {
            const FaceList::Face& face = faces.faces[f];
            planes_.push_back(loaded.plane(face.plane));
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                const auto first = static_cast<std::uint32_t>(edges_.size());
                conformer.for_each_edge(l, [&](PointId from, PointId to, std::uint32_t c) {
                    edges_.push_back({loaded.first_point + from, loaded.first_point + to,
                                      loaded.plane(faces.corners[c].edge), f,
                                      static_cast<std::uint32_t>(edges_.size() + 1), c});
                });
                if (edges_.size() > first) edges_.back().next = first;
            }
            face_first_.push_back(static_cast<std::uint32_t>(edges_.size()));
        }
        group();
    }

    [[nodiscard]] std::size_t size() const noexcept { return edges_.size(); }
    [[nodiscard]] const BoundaryEdge& operator[](std::size_t e) const { return edges_[e]; }

    [[nodiscard]] std::size_t face_count() const noexcept { return planes_.size(); }
    /// The oriented plane of face f in the kernel.
    [[nodiscard]] PlaneId plane(std::size_t f) const { return planes_[f]; }
    /// The edges of face f are those from `first(f)` up to `first(f + 1)`.
    [[nodiscard]] std::uint32_t first(std::size_t f) const { return face_first_[f]; }

    /// Calls `visit(edges)` for every pair of points that edges join, with all of these, in either direction.
    template <class Visit>
    void for_each_group(Visit&& visit) const {
        for (std::size_t g = 0; g + 1 < group_first_.size(); ++g)
            visit(std::span<const std::uint32_t>(grouped_).subspan(group_first_[g],
                                                                   group_first_[g + 1] - group_first_[g]));
    }

private:
    void group() {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(edges_.size());
        for (std::uint32_t e = 0; e < keyed.size(); ++e) {
            const std::pair<PointId, PointId> ends = std::minmax(edges_[e].from, edges_[e].to);
            keyed[e] = {(std::uint64_t(ends.first) << 32U) | ends.second, e};
        }
        std::sort(keyed.begin(), keyed.end());
        grouped_.reserve(keyed.size());
        for (std::size_t i = 0; i < keyed.size(); ++i) {
            if (i == 0 || keyed[i].first != keyed[i - 1].first) group_first_.push_back(static_cast<std::uint32_t>(i));
            grouped_.push_back(keyed[i].second);
        }
        group_first_.push_back(static_cast<std::uint32_t>(grouped_.size()));
    }

    std::vector<BoundaryEdge> edges_;
    std::vector<PlaneId> planes_;               // per face
    std::vector<std::uint32_t> face_first_{0};  // per face, and the end
    std::vector<std::uint32_t> grouped_;        // edges, those with the same ends together
    std::vector<std::uint32_t> group_first_;    // per group, and the end
};

CLEAVE_END_NAMESPACE

#endif
