// SPDX-License-Identifier: Apache-2.0
/// Structural cuts from boxes alone.
#ifndef CLEAVE_CLIP_PROPOSE_HPP
#define CLEAVE_CLIP_PROPOSE_HPP

#include <cleave/geometry/bounds.hpp>
#include <cleave/geometry/kernel.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// A structural cut for facets with a `box`: an axis-parallel plane near the median of the facets' boxes, at the end of
/// some facet's box so that grids stay unsplit. nullopt unless each side keeps at most nine tenths of the facets.
template <int D, class F>
std::optional<PlaneId> propose_axis_cut(Kernel<D>& kernel, std::span<const F> facets,
                                        std::vector<std::pair<double, double>>& centres) {
    if (facets.empty()) return std::nullopt;
    Bounds<D> all;
    for (const F& f : facets) all.include(f.box);
    std::size_t best_worse = facets.size() - facets.size() / 10;
    std::size_t best_crossing = facets.size();
    int best_axis = -1;
    double best_position = 0;
    std::array<int, D> axes{};
    for (int i = 0; i < D; ++i) axes[std::size_t(i)] = i;
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return all.extent(a) > all.extent(b); });
    for (const int axis : axes) {
        const auto i = std::size_t(axis);
        if (!(all.extent(axis) < std::numeric_limits<double>::infinity())) continue;  // nor has it a middle
        centres.clear();
        for (const F& f : facets) centres.push_back({f.box.lo[i] / 2 + f.box.hi[i] / 2, f.box.lo[i]});
        const auto middle = centres.begin() + std::ptrdiff_t(centres.size() / 2);
        std::nth_element(centres.begin(), middle, centres.end());
        const double position = middle->second > all.lo[i] ? middle->second : middle->first;
        if (!(position > all.lo[i] && position < all.hi[i])) continue;
        std::size_t minus = 0;
        std::size_t plus = 0;
        for (const F& f : facets) {
            if (f.box.hi[i] <= position)
                ++minus;
            else if (f.box.lo[i] >= position)
                ++plus;
        }
        if (minus == 0 || plus == 0) continue;
        const std::size_t crossing = facets.size() - minus - plus;
        const std::size_t worse = std::max(minus, plus) + crossing;
        if (worse < best_worse || (worse == best_worse && crossing < best_crossing && best_axis >= 0)) {
            best_worse = worse;
            best_crossing = crossing;
            best_axis = axis;
            best_position = position;
        }
        if (best_axis >= 0 && best_worse < facets.size() * 3 / 5) break;  // good enough: spare the other axes
    }
    if (best_axis < 0) return std::nullopt;
    return kernel.planes.intern_axis_plane(best_axis, best_position);
}

CLEAVE_END_NAMESPACE

#endif
