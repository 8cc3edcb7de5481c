// SPDX-License-Identifier: Apache-2.0
/// Random toy sets for rapidcheck: a few boxes added to and taken from a small grid. Few distinct coordinates, so that
/// coplanar and touching facets are the rule.
#ifndef CLEAVE_TESTS_SUPPORT_TOY_GENERATORS_HPP
#define CLEAVE_TESTS_SUPPORT_TOY_GENERATORS_HPP

#include "support/catch.hpp"
#include "support/toy_space.hpp"

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace rc {

template <std::size_t D>
struct Arbitrary<toy::Grid<D>> {
    static Gen<toy::Grid<D>> arbitrary() {
        static constexpr toy::Integer size = D == 1 ? 9 : (D == 2 ? 6 : 4);
        using Corner = std::array<toy::Integer, D>;
        const auto corner = gen::container<Corner>(gen::inRange<toy::Integer>(0, size + 1));
        const auto boxes = gen::container<std::vector<std::tuple<Corner, Corner, bool>>>(
            gen::tuple(corner, corner, gen::weightedElement<bool>({{3, true}, {1, false}})));
        return gen::map(gen::pair(gen::arbitrary<bool>(), boxes),
                        [](const std::pair<bool, std::vector<std::tuple<Corner, Corner, bool>>>& drawn) {
                            toy::Grid<D> grid(size, drawn.first);
                            for (const auto& [a, b, value] : drawn.second) {
                                Corner low = a;
                                Corner high = b;
                                for (std::size_t i = 0; i < D; ++i) {
                                    low[i] = std::min(a[i], b[i]);
                                    high[i] = std::max(a[i], b[i]);
                                }
                                grid.fill(low, high, value != grid.around());
                            }
                            return grid;
                        });
    }
};

}  // namespace rc

#endif
