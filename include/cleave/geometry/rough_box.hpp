// SPDX-License-Identifier: Apache-2.0
/// Boxes of floats that are compared four numbers at a time, and the map from doubles that keeps their order: boxes
/// that meet still do, and few others.
#ifndef CLEAVE_GEOMETRY_ROUGH_BOX_HPP
#define CLEAVE_GEOMETRY_ROUGH_BOX_HPP

#include <cleave/geometry/bounds.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

CLEAVE_BEGIN_NAMESPACE

namespace rough {

#ifdef __GNUC__
using Four = float __attribute__((vector_size(16)));

[[nodiscard]] inline Four min(Four a, Four b) noexcept {
    return a < b ? a : b;
}
[[nodiscard]] inline Four max(Four a, Four b) noexcept {
    return a > b ? a : b;
}
/// Whether a number of a is less than that of b, for any of the four.
[[nodiscard]] inline bool any_less(Four a, Four b) noexcept {
    const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(a < b);
    return (halves[0] | halves[1]) != 0;
}
#else
struct Four {
    float at[4];
    float& operator[](std::size_t i) { return at[i]; }
    float operator[](std::size_t i) const { return at[i]; }
};

[[nodiscard]] inline Four min(const Four& a, const Four& b) noexcept {
    Four m{};
    for (std::size_t i = 0; i < 4; ++i) m[i] = a[i] < b[i] ? a[i] : b[i];
    return m;
}
[[nodiscard]] inline Four max(const Four& a, const Four& b) noexcept {
    Four m{};
    for (std::size_t i = 0; i < 4; ++i) m[i] = a[i] > b[i] ? a[i] : b[i];
    return m;
}
[[nodiscard]] inline bool any_less(const Four& a, const Four& b) noexcept {
    bool any = false;
    for (std::size_t i = 0; i < 4; ++i) any = any || a[i] < b[i];
    return any;
}
#endif

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace rough

/// A closed box in 3-D; empty where lo > hi. The fourth numbers bound nothing: lo's is minus infinity, so that hi's may
/// be any.
struct RoughBounds {
    rough::Four lo{rough::infinity, rough::infinity, rough::infinity, -rough::infinity};
    rough::Four hi{-rough::infinity, -rough::infinity, -rough::infinity, 0};

    /// Whether the closed boxes have no common point.
    [[nodiscard]] bool disjoint(const RoughBounds& other) const noexcept {
        return rough::any_less(hi, other.lo) || rough::any_less(other.hi, lo);
    }

    /// Whether all of the other box lies in this one.
    [[nodiscard]] bool contains(const RoughBounds& other) const noexcept {
        for (std::size_t i = 0; i < 3; ++i)
            if (!(lo[i] <= other.lo[i] && other.hi[i] <= hi[i])) return false;
        return true;
    }

    [[nodiscard]] float extent(int axis) const noexcept { return hi[std::size_t(axis)] - lo[std::size_t(axis)]; }

    void include(const RoughBounds& other) noexcept {
        lo = rough::min(lo, other.lo);
        hi = rough::max(hi, other.hi);
    }
};

/// A box with the name of what it bounds, below 2^31 - 2^24, in its fourth number.
struct NamedRoughBox {
    static constexpr int dimension = 3;
    using Box = RoughBounds;

    RoughBounds box;

    NamedRoughBox() = default;
    NamedRoughBox(const RoughBounds& bounds, std::uint32_t name) : box(bounds) {
        box.hi[3] = std::bit_cast<float>(name + first_normal);
    }

    [[nodiscard]] std::uint32_t id() const noexcept {
        return std::bit_cast<std::uint32_t>(float(box.hi[3])) - first_normal;
    }

private:
    /// Numbers below are denormal, which some processors are slow to compare; those above infinity are no numbers.
    static constexpr std::uint32_t first_normal = std::uint32_t(1) << 23U;
};

/// Maps the coordinates of a region of space to floats near [-1, 1]. Order is kept: subtracting, multiplying with a
/// positive number and rounding never turn a < b into a' > b'. What is closer than about 2^-24 of the region's size may
/// become equal.
class RoughMap {
public:
    RoughMap() = default;
    explicit RoughMap(const Bounds<3>& region) {
        double size = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double centre = region.lo[i] / 2 + region.hi[i] / 2;
            if (std::isfinite(centre)) centre_[i] = centre;
            size = std::max(size, region.extent(int(i)) / 2);
        }
        if (size > 0 && std::isfinite(size) && std::isfinite(1 / size)) scale_ = 1 / size;
    }

    [[nodiscard]] rough::Four operator()(const std::array<double, 3>& x) const noexcept {
        const rough::Four y{at(x[0], 0), at(x[1], 1), at(x[2], 2), 0};
        return y;
    }

    [[nodiscard]] RoughBounds operator()(const Bounds<3>& box) const noexcept {
        RoughBounds out;
        out.lo = (*this)(box.lo);
        out.hi = (*this)(box.hi);
        out.lo[3] = -rough::infinity;
        return out;
    }

private:
    [[nodiscard]] float at(double x, std::size_t i) const noexcept {
        constexpr double most = std::numeric_limits<float>::max();
        return static_cast<float>(std::clamp((x - centre_[i]) * scale_, -most, most));
    }

    std::array<double, 3> centre_{};
    double scale_ = 1;
};

CLEAVE_END_NAMESPACE

#endif
