// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/double_plane.hpp>
//
#include <cleave/geometry/kernel.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

using namespace cleave;
using support::Dice;

TEST_CASE("plane through points of doubles: the join of the points, whatever their scale") {
    Dice dice(6);
    int flat = 0;
    for (int n = 0; n < 3000; ++n) {
        std::array<std::array<double, 3>, 3> p{};
        const int low = n % 4 == 0 ? -1000 : -20;
        const int high = n % 4 == 1 ? 900 : 20;
        for (auto& q : p)
            for (double& x : q)
                x = n % 2 == 0 ? std::ldexp(dice.between(-9, 9), dice.between(low, high)) : dice.between(-2, 2);
        Kernel<3> kernel;
        std::array<PointId, 3> id{};
        for (std::size_t i = 0; i < 3; ++i) id[i] = kernel.add_point(p[i]);
        const std::optional<PlaneId> joined = kernel.join(std::span<const PointId, 3>(id));
        const std::array<Integer, 4> plane = plane_through(p[0], p[1], p[2]);
        if (!joined) {
            ++flat;
            CHECK(std::all_of(plane.begin(), plane.end(), [](const Integer& x) { return x.is_zero(); }));
            continue;
        }
        CHECK(kernel.planes.intern(plane) == *joined);
    }
    CHECK(flat > 0);
}
