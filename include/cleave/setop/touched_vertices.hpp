// SPDX-License-Identifier: Apache-2.0
/// The vertices of operands that lie on other operands' boundaries.
#ifndef CLEAVE_SETOP_TOUCHED_VERTICES_HPP
#define CLEAVE_SETOP_TOUCHED_VERTICES_HPP

#include <cleave/setop/surface_contacts.hpp>

#include <cstdint>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Knows for each vertex the operands on whose boundaries it lies.
class TouchedVertices {
public:
    using Bits = SurfaceContacts::Bits;

    TouchedVertices(const SurfaceOperands& operands, const SurfaceContacts& contacts)
        : mask_of_(operands.vertex_count(), no_id) {
        for (std::uint32_t i = 0; i < operands.count(); ++i) {
            const FaceList& list = operands.boundary(i).faces;
            for (const PointContact& c : contacts.points(i)) {
                if (c.of_face.kind != Feature::Kind::vertex) continue;
                std::uint32_t& at = mask_of_[operands.vertex(i, list.corners[c.of_face.corner].point)];
                if (at == no_id) {
                    at = static_cast<std::uint32_t>(masks_.size());
                    masks_.push_back(0);
                }
                masks_[at] |= Bits(1) << c.operand;
            }
        }
    }

    /// Requires: v is one of the vertices numbered through (`SurfaceOperands::vertex`).
    [[nodiscard]] Bits by(std::uint32_t v) const { return mask_of_[v] == no_id ? 0 : masks_[mask_of_[v]]; }

private:
    std::vector<std::uint32_t> mask_of_;  // `no_id` for those on no other boundary
    std::vector<Bits> masks_;
};

CLEAVE_END_NAMESPACE

#endif
