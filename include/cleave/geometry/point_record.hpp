// SPDX-License-Identifier: Apache-2.0
/// What a kernel knows of a point, and what it counts.
#ifndef CLEAVE_GEOMETRY_POINT_RECORD_HPP
#define CLEAVE_GEOMETRY_POINT_RECORD_HPP

#include <cleave/geometry/handles.hpp>
#include <cleave/number/double.hpp>
#include <cleave/number/integer.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

/// Homogeneous integer coordinates X_1, ..., X_D and a weight W > 0.
template <int D>
using Homogeneous = std::array<Integer, D + 1>;

/// Those of a point given by finite doubles; the weight is a power of two.
template <int D>
[[nodiscard]] Homogeneous<D> homogeneous_of(const std::array<double, D>& x) {
    std::array<DoubleParts, D> parts;
    int low = 0;
    for (std::size_t i = 0; i < D; ++i) {
        parts[i] = decompose(x[i]);
        if (parts[i].mantissa != 0) low = std::min(low, parts[i].exponent);
    }
    Homogeneous<D> h;
    for (std::size_t i = 0; i < D; ++i)
        if (parts[i].mantissa != 0) h[i] = Integer::scaled(parts[i].mantissa, unsigned(parts[i].exponent - low));
    h[D] = Integer::scaled(1, unsigned(-low));
    return h;
}

/// What is known of one point. `planes` are unoriented planes through it (`no_id` where unknown); a meet has D of them.
template <int D>
struct PointRecord {
    enum class Kind : std::uint8_t { doubles, integers, meet };

    std::array<double, D> approximation{};
    /// |x_i - approximation_i| <= error for every i; 0: exact; infinity: not known yet.
    double error = 0;
    std::array<std::uint32_t, D> planes = filled();
    /// Index of the exact coordinates, `no_id` while they are not needed (a point of doubles hardly ever needs them).
    std::uint32_t exact = no_id;
    Kind kind = Kind::doubles;
    bool rounded = true;  ///< whether the approximation is the correctly rounded value of each coordinate

    /// Whether the approximation is the point itself: an input point of doubles, or a meet that is one.
    [[nodiscard]] bool is_of_doubles() const noexcept { return error == 0; }

private:
    static constexpr std::array<std::uint32_t, D> filled() {
        std::array<std::uint32_t, D> a{};
        a.fill(no_id);
        return a;
    }
};

/// Counts of what the predicates of one kernel had to do.
struct KernelCounts {
    std::uint64_t sides = 0;            ///< side tests asked for
    std::uint64_t by_identity = 0;      ///< zero because the point was made from the plane
    std::uint64_t filter_failures = 0;  ///< not decided by the first approximation
    std::uint64_t exact_tests = 0;      ///< decided by exact arithmetic
    std::uint64_t exact_points = 0;     ///< constructed points computed exactly
};

CLEAVE_END_NAMESPACE

#endif
