// SPDX-License-Identifier: Apache-2.0
/// Handles of interned planes and points: what a kernel hands out and everything above it stores.
#ifndef CLEAVE_GEOMETRY_HANDLES_HPP
#define CLEAVE_GEOMETRY_HANDLES_HPP

#include <cleave/base/config.hpp>

#include <cstdint>

CLEAVE_BEGIN_NAMESPACE

/// An oriented, interned plane: `2k + s`, k the unoriented plane, s its orientation (1 = flipped).
/// Two planes are coincident iff their k agree, co-oriented iff the whole ids agree.
using PlaneId = std::uint32_t;

/// An interned point of a kernel, or of a region's boundary.
using PointId = std::uint32_t;

/// No plane, no point.
inline constexpr std::uint32_t no_id = 0xffffffffU;

/// The same plane facing the other way.
[[nodiscard]] constexpr PlaneId flipped(PlaneId h) noexcept {
    return h ^ 1U;
}
/// The index k of the unoriented plane.
[[nodiscard]] constexpr std::uint32_t unoriented(PlaneId h) noexcept {
    return h >> 1U;
}
/// Whether the orientation is the reverse of the stored canonical one.
[[nodiscard]] constexpr bool is_flipped(PlaneId h) noexcept {
    return (h & 1U) != 0;
}

/// One corner of a facet's boundary: a point and a plane through the ridge that starts there, the facet on the plane's
/// minus side. D = 3: the edge from this corner to the next. D = 2: the end of the segment at this corner.
/// D = 1: no ridge, `edge` is `no_id`.
struct Corner {
    PointId point = no_id;
    PlaneId edge = no_id;

    friend bool operator==(const Corner&, const Corner&) = default;
};

CLEAVE_END_NAMESPACE

#endif
