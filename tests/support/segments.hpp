// SPDX-License-Identifier: Apache-2.0
/// The boundary of a plane region as maximal directed segments: a form in which two boundaries of one set are equal,
/// however their sides are divided.
#ifndef CLEAVE_TESTS_SUPPORT_SEGMENTS_HPP
#define CLEAVE_TESTS_SUPPORT_SEGMENTS_HPP

#include "support/exact_region.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace support {

using Segment = std::pair<Coordinates<2>, Coordinates<2>>;

/// Collinear segments that follow each other in one direction, joined.
[[nodiscard]] inline std::set<Segment> joined(const std::vector<Segment>& segments) {
    // By line and direction: (direction with leading +-1, the place where the line meets an axis).
    std::map<std::array<Rational, 4>, std::map<Rational, std::pair<Rational, Segment>>> lines;
    for (const Segment& s : segments) {
        Coordinates<2> d = subtract(s.second, s.first);
        const std::size_t axis = d[0] == 0 ? 1 : 0;
        const Rational scale = d[axis] < 0 ? Rational(-d[axis]) : d[axis];
        for (Rational& x : d) x /= scale;
        const Coordinates<2> foot = along(s.first, Rational(-s.first[axis] / d[axis]), d);
        lines[{d[0], d[1], foot[0], foot[1]}][Rational(s.first[axis] / d[axis])] = {Rational(s.second[axis] / d[axis]),
                                                                                    s};
    }
    std::set<Segment> result;
    for (const auto& [line, pieces] : lines) {
        bool open = false;
        Segment current;
        Rational end(0);
        for (const auto& [start, piece] : pieces) {
            if (open && end == start) {
                current.second = piece.second.second;
            } else {
                if (open) result.insert(current);
                current = piece.second;
                open = true;
            }
            end = piece.first;
        }
        if (open) result.insert(current);
    }
    return result;
}

[[nodiscard]] inline std::set<Segment> boundary_segments(const cleave::Region<2>& region) {
    std::vector<Segment> segments;
    const ExactRegion<2> exact(region);
    for (const auto& f : exact.faces())
        for (const auto& s : f.loops) segments.push_back({s[0], s[1]});
    return joined(segments);
}

/// The sides of closed loops.
[[nodiscard]] inline std::set<Segment> loop_segments(const std::vector<std::vector<Coordinates<2>>>& loops) {
    std::vector<Segment> segments;
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
    return joined(segments);
}

}  // namespace support

#endif
