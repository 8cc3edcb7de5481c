// SPDX-License-Identifier: Apache-2.0
/// Boxes of doubles around points that are known up to an error: what the facets of the indexed kernel carry.
#ifndef CLEAVE_GEOMETRY_BOUNDS_HPP
#define CLEAVE_GEOMETRY_BOUNDS_HPP

#include <cleave/base/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

CLEAVE_BEGIN_NAMESPACE

/// A closed axis-parallel box of doubles that contains what it bounds; empty where lo > hi.
template <int D>
struct Bounds {
    std::array<double, D> lo = all(std::numeric_limits<double>::infinity());
    std::array<double, D> hi = all(-std::numeric_limits<double>::infinity());

    /// Whether the closed boxes have no common point.
    [[nodiscard]] bool disjoint(const Bounds& other) const noexcept {
        bool apart = false;  // without branches: what is asked for many boxes in a row is hard to predict
        for (std::size_t i = 0; i < D; ++i)
            apart = bool(int(apart) | int(hi[i] < other.lo[i]) | int(other.hi[i] < lo[i]));
        return apart;
    }

    /// Whether all of the other box lies in this one.
    [[nodiscard]] bool contains(const Bounds& other) const noexcept {
        for (std::size_t i = 0; i < D; ++i)
            if (!(lo[i] <= other.lo[i] && other.hi[i] <= hi[i])) return false;
        return true;
    }

    [[nodiscard]] double extent(int axis) const noexcept { return hi[std::size_t(axis)] - lo[std::size_t(axis)]; }

    void include(const Bounds& other) noexcept {
        for (std::size_t i = 0; i < D; ++i) {
            lo[i] = std::min(lo[i], other.lo[i]);
            hi[i] = std::max(hi[i], other.hi[i]);
        }
    }

    /// Includes every position of a point whose coordinates are known up to `error`: all of space for a point beyond
    /// the range of doubles. The widening by 2^-51 |x| covers the rounding of the sums themselves.
    void include(const std::array<double, D>& x, double error) noexcept {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < D; ++i) {
            const double slack = error == 0 ? 0 : error + std::abs(x[i]) * 0x1p-51 + 0x1p-1060;
            const bool known = slack < infinity;
            lo[i] = std::min(lo[i], known ? x[i] - slack : -infinity);
            hi[i] = std::max(hi[i], known ? x[i] + slack : infinity);
        }
    }

private:
    static constexpr std::array<double, D> all(double x) {
        std::array<double, D> a{};
        a.fill(x);
        return a;
    }
};

CLEAVE_END_NAMESPACE

#endif
