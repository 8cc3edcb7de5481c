// SPDX-License-Identifier: Apache-2.0
/// The vertices of operands that lie on other operands' boundaries.
#ifndef CLEAVE_SETOP_TOUCHED_VERTICES_HPP
#define CLEAVE_SETOP_TOUCHED_VERTICES_HPP

#include <cleave/setop/surface_contacts.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Knows for each vertex the operands on whose boundaries it lies.
class TouchedVertices {
public:
    using Bits = SurfaceContacts::Bits;

    TouchedVertices(const SurfaceOperands& operands, const SurfaceContacts& contacts)
        : touched_(operands.vertex_count(), 0) {
        for (std::uint32_t i = 0; i < operands.count(); ++i) {
            const FaceList& list = operands.boundary(i).faces;
            for (const PointContact& c : contacts.points(i)) {
                if (c.of_face.kind != Feature::Kind::vertex) continue;
                const std::uint32_t v = operands.vertex(i, list.corners[c.of_face.corner].point);
                touched_[v] = 1;
                masks_.push_back({v, Bits(1) << c.operand});
            }
        }
        std::sort(masks_.begin(), masks_.end());
        std::size_t kept = 0;
        for (std::size_t n = 0; n < masks_.size(); ++n) {
            if (kept > 0 && masks_[kept - 1].first == masks_[n].first)
                masks_[kept - 1].second |= masks_[n].second;
            else
                masks_[kept++] = masks_[n];
        }
        masks_.resize(kept);
    }

    /// Requires: v is one of the vertices numbered through (`SurfaceOperands::vertex`).
    [[nodiscard]] Bits by(std::uint32_t v) const {
        if (touched_[v] == 0) return 0;
        return std::lower_bound(masks_.begin(), masks_.end(), v,
                                [](const std::pair<std::uint32_t, Bits>& m, std::uint32_t u) { return m.first < u; })
            ->second;
    }

private:
    std::vector<char> touched_;
    std::vector<std::pair<std::uint32_t, Bits>> masks_;
};

CLEAVE_END_NAMESPACE

#endif
