// SPDX-License-Identifier: Apache-2.0
/// Random toy sets for properties: a few boxes added to and taken from a small grid. Few distinct coordinates, so that
/// coplanar and touching facets are the rule.
#ifndef CLEAVE_TESTS_SUPPORT_TOY_GENERATORS_HPP
#define CLEAVE_TESTS_SUPPORT_TOY_GENERATORS_HPP

#include "support/property.hpp"
#include "support/toy_space.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace support {

template <std::size_t D>
struct Drawn<toy::Grid<D>> {
    static toy::Grid<D> draw() {
        constexpr int size = D == 1 ? 9 : (D == 2 ? 6 : 4);
        toy::Grid<D> grid(size, draw_bool());
        for (const bool belongs : draw_membership()) {
            const std::vector<int> corners = draw_ints(2 * D, 0, size + 1);
            const bool is_hole = draw_choice({3, 1}) == 1;
            if (!belongs) continue;
            std::array<toy::Integer, D> low{};
            std::array<toy::Integer, D> high{};
            for (std::size_t i = 0; i < D; ++i) {
                low[i] = std::min(corners[i], corners[D + i]);
                high[i] = std::max(corners[i], corners[D + i]);
            }
            grid.fill(low, high, grid.around() == is_hole);
        }
        return grid;
    }
};

}  // namespace support

#endif
