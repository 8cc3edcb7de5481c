// SPDX-License-Identifier: Apache-2.0
/// Whether a face contains a point of its plane.
#ifndef CLEAVE_SETOP_COPLANAR_COVER_HPP
#define CLEAVE_SETOP_COPLANAR_COVER_HPP

#include <cleave/geometry/kernel_turn.hpp>
#include <cleave/setop/face_contact.hpp>

#include <cstddef>
#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

/// Asks faces of any operand, one after the other.
class CoplanarCover {
public:
    explicit CoplanarCover(SurfaceOperands& operands) : operands_(&operands) {}

    /// Whether face f of operand j contains a point on its plane. Requires: the point is on none of its edges.
    /// Cost: a few comparisons for each corner.
    bool operator()(std::uint32_t j, std::uint32_t f, PointId p) {
        Kernel<3>& kernel = operands_->kernel();
        const Projection projection = projection_of(kernel, operands_->plane(j, f));
        outline_.read(*operands_, j, f);
        bool inside = false;
        for (const FaceOutline::Entry& e : outline_.entries) {
            const PointId a = operands_->point(j, e.point);
            const PointId b = operands_->point(j, outline_.entries[e.next].point);
            const bool a_below = kernel.compare(projection.v, a, p) != Sign::plus;
            if (a_below == (kernel.compare(projection.v, b, p) != Sign::plus)) continue;
            if (turn(kernel, a, b, p, projection) == (a_below ? Sign::plus : Sign::minus)) inside = !inside;
        }
        return inside;
    }

private:
    SurfaceOperands* operands_;
    FaceOutline outline_;
};

/// A new point of the kernel halfway between two others.
inline PointId add_midpoint(Kernel<3>& kernel, PointId p, PointId q) {
    const Homogeneous<3> a = kernel.coordinates(p);
    const Homogeneous<3> b = kernel.coordinates(q);
    Homogeneous<3> middle;
    for (std::size_t x = 0; x < 3; ++x) {
        WideInteger sum(a[x] * WideInteger(b[3]));
        add_product(sum, b[x], a[3]);
        middle[x] = Integer(sum);
    }
    middle[3] = Integer(a[3] * WideInteger(b[3]) * WideInteger(Integer(2)));
    return kernel.add_point(middle);
}

CLEAVE_END_NAMESPACE

#endif
