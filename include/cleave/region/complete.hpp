// SPDX-License-Identifier: Apache-2.0
/// The planes that a boundary left out: made when something asks for them, because most operations never do.
#ifndef CLEAVE_REGION_COMPLETE_HPP
#define CLEAVE_REGION_COMPLETE_HPP

#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/point_interner.hpp>
#include <cleave/region/boundary.hpp>
#include <cleave/region/build.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Gives every face and edge of a boundary its plane.
class BoundaryCompletion {
public:
    /// The same boundary with all planes. Cost: O(n log n), an exact plane for each face without one.
    [[nodiscard]] static Boundary<3> of(const Boundary<3>& lean) {
        BoundaryCompletion completion(lean);
        completion.find_planes();
        completion.find_edges();
        PointInterner<3>& points = completion.points_;
        Boundary<3> out =
            freeze(completion.kernel_, completion.list_, lean.value_at_infinity, [&](PointId p) { return points(p); });
        out.is_conforming = lean.is_conforming;
        return out;
    }

private:
    explicit BoundaryCompletion(const Boundary<3>& lean)
        : lean_(&lean), points_(kernel_), loaded_(load(lean, kernel_)), list_(lean.faces) {
        kernel_.planes.reserve(kernel_.planes.size() + list_.faces.size());
    }

    void find_planes() {
        for (FaceList::Face& face : list_.faces) {
            if (face.plane != no_id) {
                face.plane = loaded_.plane(face.plane);
            } else {
                const std::span<const Corner> c = list_.loop(face.first_loop);
                const std::array<PointId, 3> through{loaded_.first_point + c[0].point, loaded_.first_point + c[1].point,
                                                     loaded_.first_point + c[2].point};
                face.plane = kernel_.join(std::span<const PointId, 3>(through)).value();
            }
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l)
                for (const Corner& c : list_.loop(l))
                    kernel_.note_incidence(loaded_.first_point + c.point, unoriented(face.plane));
        }
        for (Corner& c : list_.corners) {
            c.point += loaded_.first_point;
            c.edge = loaded_.plane(c.edge);
        }
    }

    struct Use {
        std::uint64_t ends;
        std::uint32_t plane;  // of the face, unoriented
        std::uint32_t face;
        std::uint32_t corner;
        PointId to;
    };

    /// An edge without a plane gets that of a face at its other side; a coplanar one would not do.
    void find_edges() {
        std::vector<Use> uses;
        uses.reserve(list_.corners.size());
        for (std::uint32_t f = 0; f < list_.faces.size(); ++f) {
            const FaceList::Face& face = list_.faces[f];
            for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
                const std::uint32_t first = list_.loop_first[l];
                const std::uint32_t last = list_.loop_first[l + 1];
                for (std::uint32_t c = first; c < last; ++c) {
                    const PointId to = list_.corners[c + 1 == last ? first : c + 1].point;
                    const std::pair<PointId, PointId> ends = std::minmax(list_.corners[c].point, to);
                    uses.push_back(
                        {(std::uint64_t(ends.first) << 32U) | ends.second, unoriented(face.plane), f, c, to});
                }
            }
        }
        std::sort(uses.begin(), uses.end(),
                  [](const Use& a, const Use& b) { return std::pair(a.ends, a.corner) < std::pair(b.ends, b.corner); });
        for (std::size_t i = 0; i < uses.size();) {
            std::size_t j = i;
            while (j < uses.size() && uses[j].ends == uses[i].ends) ++j;
            for (std::size_t n = i; n < j; ++n) {
                Corner& corner = list_.corners[uses[n].corner];
                if (corner.edge != no_id) continue;
                std::uint32_t beside = no_id;
                for (std::size_t m = i; m < j; ++m)
                    if (uses[m].plane != uses[n].plane) beside = std::min(beside, uses[m].plane);
                const PlaneId own = list_.faces[uses[n].face].plane;
                corner.edge = beside != no_id ? orient_edge(kernel_, own, 2 * beside, corner.point, uses[n].to)
                                              : plane_across(kernel_, own, corner.point, uses[n].to);
            }
            i = j;
        }
    }

    const Boundary<3>* lean_;
    Kernel<3> kernel_;
    PointInterner<3> points_;
    LoadedBoundary<3> loaded_;
    FaceList list_;
};

/// A boundary that regions share, with its planes made when first asked for.
template <int D>
class SharedBoundary {
public:
    explicit SharedBoundary(Boundary<D> boundary) : given_(std::move(boundary)) {}

    /// As it was given.
    [[nodiscard]] const Boundary<D>& given() const noexcept { return given_; }

    /// With all planes. May be called from many threads at once; the first one works. Cost: none where it is complete.
    [[nodiscard]] const Boundary<D>& complete() const {
        if constexpr (D == 3) {
            if (given_.is_complete) return given_;
            std::call_once(once_, [&] { made_ = std::make_unique<const Boundary<3>>(BoundaryCompletion::of(given_)); });
            return *made_;
        } else {
            return given_;
        }
    }

private:
    Boundary<D> given_;
    mutable std::once_flag once_;
    mutable std::unique_ptr<const Boundary<D>> made_;
};

CLEAVE_END_NAMESPACE

#endif
