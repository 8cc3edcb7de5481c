// SPDX-License-Identifier: Apache-2.0
/// Checks of answers that use nothing of any engine.
#ifndef CLEAVE_BENCHMARKS_SIDE_BY_SIDE_CHECK_HPP
#define CLEAVE_BENCHMARKS_SIDE_BY_SIDE_CHECK_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine.hpp"

namespace side_by_side {

/// Why these are not the triangles of a closed surface: empty if they are. A surface may touch itself, so an edge may
/// have more than two faces, but as many pass it one way as the other.
[[nodiscard]] inline std::string defect(const Arrays& arrays) {
    std::vector<std::uint64_t> forth;
    std::vector<std::uint64_t> back;
    forth.reserve(arrays.corners.size());
    back.reserve(arrays.corners.size());
    for (std::size_t f = 0; f < arrays.face_count(); ++f)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint64_t p = arrays.corners[3 * f + c];
            const std::uint64_t q = arrays.corners[3 * f + (c + 1) % 3];
            if (p >= arrays.points.size()) return "a corner has no point";
            if (p == q) return "a triangle has a corner twice";
            forth.push_back(p << 32U | q);
            back.push_back(q << 32U | p);
        }
    std::sort(forth.begin(), forth.end());
    std::sort(back.begin(), back.end());
    return forth == back ? "" : "the surface is not closed";
}

/// The enclosed volume, about a point inside the bounding box so that distant solids lose no digits.
[[nodiscard]] inline double volume(const Arrays& arrays) {
    if (arrays.points.empty()) return 0;
    const std::array<double, 3> o = arrays.points.front();
    long double six = 0;
    for (std::size_t f = 0; f < arrays.face_count(); ++f) {
        std::array<std::array<double, 3>, 3> v;
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < 3; ++i) v[c][i] = arrays.points[arrays.corners[3 * f + c]][i] - o[i];
        for (std::size_t i = 0; i < 3; ++i)
            six += v[0][i] * (v[1][(i + 1) % 3] * v[2][(i + 2) % 3] - v[1][(i + 2) % 3] * v[2][(i + 1) % 3]);
    }
    return static_cast<double>(six / 6);
}

/// |A| + |B| = |A or B| + |A and B|, or |A| = |A - B| + |A and B|. Corners rounded to doubles move the volume by 1e-16
/// or so of the whole; a lost or doubled face moves it by far more than the bound.
[[nodiscard]] inline bool adds_up(Operation operation, double a, double b, double result, double intersection) {
    const double whole = operation == Operation::difference ? a : a + b;
    return std::abs(result + intersection - whole) <= 1e-9 * (a + b);
}

}  // namespace side_by_side

#endif
