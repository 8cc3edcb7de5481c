// SPDX-License-Identifier: Apache-2.0
/// Planes that turn about a given line: structural cuts where no axis-parallel plane divides.
///
/// The facets round the apex of a cone all meet in one point, and an axis-parallel plane near it splits half of them.
/// A plane through one of their edges splits none or one. The planes through the line in which g and h meet are their
/// *pencil*, a g + b h; with a = h_i and b = -g_i entry i of the normal vanishes, that is, the plane contains the line
/// and the direction of axis i.
#ifndef CLEAVE_CLIP_PENCIL_HPP
#define CLEAVE_CLIP_PENCIL_HPP

#include <cleave/base/contract.hpp>

#include <cstddef>
#include <optional>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// The coefficients (n, c) of the plane through the common line of g and h, given by theirs, and parallel to axis i.
/// `Coefficients` is an array of D + 1 ring elements.
/// Returns: nullopt where that plane is g or h itself, or where g and h have no common line.
/// Cost: 2 D products. Bits: the sum of those of g and h, and one.
template <class Coefficients>
[[nodiscard]] std::optional<Coefficients> turned_plane(const Coefficients& g, const Coefficients& h, std::size_t i) {
    const std::size_t last = g.size() - 1;
    CLEAVE_REQUIRES(i < last);
    if (g[i] == 0 || h[i] == 0) return std::nullopt;
    Coefficients result = g;
    bool has_normal = false;
    for (std::size_t k = 0; k <= last; ++k) {
        result[k] = g[k] * h[i] - h[k] * g[i];
        if (k < last && !(result[k] == 0)) has_normal = true;
    }
    if (!has_normal) return std::nullopt;
    return result;
}

/// The planes through the common line of g and h that are parallel to a coordinate axis, as `make` makes them from
/// coefficients; in the order of the axes. A model's `planes_through` (see `TurningClip` in bsp/pivot.hpp) in one line.
template <class Coefficients, class Make>
[[nodiscard]] auto planes_through(const Coefficients& g, const Coefficients& h, Make&& make) {
    std::vector<decltype(make(Coefficients(g)))> planes;
    for (std::size_t i = 0; i + 1 < g.size(); ++i) {
        if (std::optional<Coefficients> c = turned_plane(g, h, i)) planes.push_back(make(*std::move(c)));
    }
    return planes;
}

CLEAVE_END_NAMESPACE

#endif
