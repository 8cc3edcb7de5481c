// SPDX-License-Identifier: Apache-2.0
/// Axis-parallel closed boxes in any dimension: of doubles, for culling, and of exact numbers, for answers.
#ifndef CLEAVE_GEOMETRY_BOX_HPP
#define CLEAVE_GEOMETRY_BOX_HPP

#include <cleave/base/contract.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>

CLEAVE_BEGIN_NAMESPACE

/// The product of closed intervals [lo_i, hi_i]; empty where some lo_i exceeds hi_i.
///
/// `T` is `double` (bounds may be infinite; whoever makes the box rounds outward, so that the box holds at least the
/// set it stands for: then `disjoint` is a proof and everything else a hint) or an exact field.
template <int D, class T = double>
requires(D >= 1) struct Box {
    /// Number of axes.
    static constexpr std::size_t size = static_cast<std::size_t>(D);

    std::array<T, size> lo;  ///< least coordinate on each axis
    std::array<T, size> hi;  ///< greatest coordinate on each axis

    /// The empty box.
    Box() {
        if constexpr (std::floating_point<T>) {
            lo.fill(std::numeric_limits<T>::infinity());
            hi.fill(-std::numeric_limits<T>::infinity());
        } else {
            lo.fill(T(1));
            hi.fill(T(0));
        }
    }

    /// The box of one point.
    explicit Box(const std::array<T, size>& point) : lo(point), hi(point) {}

    /// The box from its least to its greatest corner.
    Box(const std::array<T, size>& least, const std::array<T, size>& greatest) : lo(least), hi(greatest) {}

    /// Whether the box holds no point.
    [[nodiscard]] bool is_empty() const {
        for (std::size_t i = 0; i < size; ++i) {
            if (hi[i] < lo[i]) return true;
        }
        return false;
    }

    /// Whether the point lies in the closed box.
    [[nodiscard]] bool contains(const std::array<T, size>& point) const {
        for (std::size_t i = 0; i < size; ++i) {
            if (point[i] < lo[i] || hi[i] < point[i]) return false;
        }
        return true;
    }

    /// Whether the other box is a subset. The empty box is one of every box.
    [[nodiscard]] bool contains(const Box& other) const {
        return other.is_empty() || (contains(other.lo) && contains(other.hi));
    }

    /// Grows the box until it holds the other one.
    void extend(const Box& other) {
        if constexpr (!std::floating_point<T>) {  // infinite bounds make the empty box neutral without a test
            if (other.is_empty()) return;
            if (is_empty()) {
                *this = other;
                return;
            }
        }
        for (std::size_t i = 0; i < size; ++i) {
            if (other.lo[i] < lo[i]) lo[i] = other.lo[i];
            if (hi[i] < other.hi[i]) hi[i] = other.hi[i];
        }
    }

    /// Grows the box until it holds the point.
    void extend(const std::array<T, size>& point) { extend(Box(point)); }

    /// Same set of points: all empty boxes are equal.
    friend bool operator==(const Box& a, const Box& b) {
        const bool no_points = a.is_empty();
        if (no_points || b.is_empty()) return no_points == b.is_empty();
        return a.lo == b.lo && a.hi == b.hi;
    }
};

/// The least box that holds both.
template <int D, class T>
[[nodiscard]] Box<D, T> hull(Box<D, T> a, const Box<D, T>& b) {
    a.extend(b);
    return a;
}

/// The box of the common points; empty where there are none. Boxes that touch have a flat common box.
template <int D, class T>
[[nodiscard]] Box<D, T> common(Box<D, T> a, const Box<D, T>& b) {
    if (a.is_empty() || b.is_empty()) return Box<D, T>();
    for (std::size_t i = 0; i < a.size; ++i) {
        if (a.lo[i] < b.lo[i]) a.lo[i] = b.lo[i];
        if (b.hi[i] < a.hi[i]) a.hi[i] = b.hi[i];
    }
    return a.is_empty() ? Box<D, T>() : a;
}

/// Whether the boxes have no common point. Touching boxes have one; an empty box has none with any.
template <int D, class T>
[[nodiscard]] bool disjoint(const Box<D, T>& a, const Box<D, T>& b) {
    // An empty box that came about by computation need not be the neutral one, so both are asked.
    if (a.is_empty() || b.is_empty()) return true;
    for (std::size_t i = 0; i < a.size; ++i) {
        if (a.hi[i] < b.lo[i] || b.hi[i] < a.lo[i]) return true;
    }
    return false;
}

/// The axis on which the box is longest; the least such axis on a tie.
/// Requires: the box is not empty.
template <int D, class T>
[[nodiscard]] std::size_t longest_axis(const Box<D, T>& box) {
    CLEAVE_REQUIRES(!box.is_empty());
    std::size_t longest = 0;
    T length(box.hi[0] - box.lo[0]);
    for (std::size_t i = 1; i < box.size; ++i) {
        T other(box.hi[i] - box.lo[i]);
        if (length < other) {
            longest = i;
            length = other;
        }
    }
    return longest;
}

CLEAVE_END_NAMESPACE

#endif
