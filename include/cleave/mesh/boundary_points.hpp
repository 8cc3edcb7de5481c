// SPDX-License-Identifier: Apache-2.0
/// `BoundaryPoints`: predicates on the points of one boundary, most of which never enter a kernel.
#ifndef CLEAVE_MESH_BOUNDARY_POINTS_HPP
#define CLEAVE_MESH_BOUNDARY_POINTS_HPP

#include <cleave/geometry/double_predicates.hpp>
#include <cleave/geometry/kernel.hpp>
#include <cleave/geometry/kernel_lines.hpp>
#include <cleave/geometry/kernel_turn.hpp>
#include <cleave/number/filter.hpp>
#include <cleave/region/boundary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

CLEAVE_BEGIN_NAMESPACE

/// Predicates on points of a boundary, given by its indices: by the approximations that it stores, and where they do
/// not decide, in a kernel of its own that knows the points in question. For one thread; any number of them may exist
/// for one boundary. Requires: the boundary outlives it.
class BoundaryPoints {
public:
    explicit BoundaryPoints(const Boundary<3>& boundary) : boundary_(&boundary) {}

    /// The projection that sees a plane of the boundary from outside, along the axis on which its normal is longest.
    [[nodiscard]] Projection projection_of(PlaneId face) const {
        const auto& approximation = boundary_->planes.approximation(unoriented(face));
        const auto& exact = boundary_->planes.exact(unoriented(face));
        std::size_t drop = 3;
        for (std::size_t i = 0; i < 3; ++i)
            if (!exact[i].is_zero() && (drop == 3 || std::abs(approximation[i]) > std::abs(approximation[drop])))
                drop = i;
        const bool is_down = exact[drop].sign() == Sign::minus;
        return Projection::along(static_cast<unsigned>(drop), is_down != is_flipped(face));
    }

    /// The turn p, q, r in a projection: plus where it is counter-clockwise. Requires: finite points.
    [[nodiscard]] Sign turn(PointId p, PointId q, PointId r, Projection projection) {
        return turn(p, q, r, projection, [] { return false; });
    }

    /// The same where somebody may know without a computation that the points are on one line: `is_straight()` is asked
    /// where the approximations do not decide.
    template <class IsStraight>
    [[nodiscard]] Sign turn(PointId p, PointId q, PointId r, Projection projection, IsStraight&& is_straight) {
        if (p == q || q == r || p == r) return Sign::zero;
        if constexpr (!filtering::always_fails) {
            const PointRecord<3>& a = boundary_->points[p];
            const PointRecord<3>& b = boundary_->points[q];
            const PointRecord<3>& c = boundary_->points[r];
            const std::optional<Sign> s = approximate_turn(a.approximation, b.approximation, c.approximation,
                                                           projection, std::max({a.error, b.error, c.error}));
            if (s) return *s;
        }
        if (is_straight()) return Sign::zero;
        // One after the other: a reference into the kernel would not survive the next point.
        const PointId i = load(p);
        const PointId j = load(q);
        const PointId k = load(r);
        return cleave::turn(kernel_, i, j, k, projection);
    }

    /// The order of coordinate `axis` of p and q. Requires: finite points.
    [[nodiscard]] Sign compare(int axis, PointId p, PointId q) {
        const PointRecord<3>& a = boundary_->points[p];
        const PointRecord<3>& b = boundary_->points[q];
        if (a.is_of_doubles() && b.is_of_doubles()) {
            const double x = a.approximation[std::size_t(axis)];
            const double y = b.approximation[std::size_t(axis)];
            return x < y ? Sign::minus : x > y ? Sign::plus : Sign::zero;
        }
        if constexpr (!filtering::always_fails) {  // the filter of Kernel::compare
            const double difference = a.approximation[std::size_t(axis)] - b.approximation[std::size_t(axis)];
            const double bound = (a.error + b.error) * (1 + 0x1p-50) + std::abs(difference) * 0x1p-52 + 0x1p-1000;
            if (difference > bound) return Sign::plus;
            if (-difference > bound) return Sign::minus;
        }
        const PointId i = load(p);
        const PointId j = load(q);
        return kernel_.compare(axis, i, j);
    }

    /// The correctly rounded coordinates; infinite where they are beyond the range of doubles.
    [[nodiscard]] std::array<double, 3> rounded(PointId p) {
        if (boundary_->points[p].rounded) return boundary_->points[p].approximation;
        const PointId i = load(p);
        kernel_.refine(i);
        return kernel_.point(i).approximation;
    }

    /// Homogeneous integer coordinates.
    [[nodiscard]] Homogeneous<3> coordinates(PointId p) {
        const PointId i = load(p);
        return kernel_.coordinates(i);
    }

private:
    PointId load(PointId p) {
        const auto [at, is_new] = points_.try_emplace(p, no_id);
        if (is_new) {
            PointRecord<3> r = boundary_->points[p];
            const Homogeneous<3>* exact = r.exact == no_id ? nullptr : &boundary_->exact[r.exact];
            if (r.kind == PointRecord<3>::Kind::meet) {
                for (std::uint32_t& k : r.planes) k = kernel_.planes.intern_from(boundary_->planes, k);
            } else {
                r.planes.fill(no_id);
            }
            at->second = kernel_.add_record(r, exact);
        }
        return at->second;
    }

    const Boundary<3>* boundary_;
    Kernel<3> kernel_;
    std::unordered_map<PointId, PointId> points_;
};

CLEAVE_END_NAMESPACE

#endif
