// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/kernel_turn.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

using namespace cleave;
using support::Dice;

namespace {

PointId integer_point(Kernel<3>& kernel, const std::array<int, 4>& x) {
    Homogeneous<3> h;
    for (std::size_t i = 0; i < 4; ++i) h[i] = Integer(x[i]);
    return kernel.add_point(h);
}

}  // namespace

TEST_CASE("turn of kernel points: doubles, integers and meets, each axis, both ways") {
    Kernel<3> kernel;
    const PointId o = kernel.add_point(std::array<double, 3>{0, 0, 0});
    const PointId x = kernel.add_point(std::array<double, 3>{1, 0, 0});
    const PointId y = integer_point(kernel, {0, 3, 0, 7});
    const PointId z = integer_point(kernel, {0, 0, 1, 3});
    CHECK(turn(kernel, o, x, y, Projection::along(2)) == Sign::plus);
    CHECK(turn(kernel, o, y, x, Projection::along(2)) == Sign::minus);
    CHECK(turn(kernel, o, x, y, Projection::along(2, true)) == Sign::minus);
    CHECK(turn(kernel, o, y, z, Projection::along(0)) == Sign::plus);
    CHECK(turn(kernel, o, z, x, Projection::along(1)) == Sign::plus);
    CHECK(turn(kernel, o, x, z, Projection::along(2)) == Sign::zero);
    CHECK(turn(kernel, o, x, x, Projection::along(2)) == Sign::zero);
    // A meet: (1/3, 1/3, 1/3) of the planes through it and two vertices each, no point of doubles.
    std::array<std::uint32_t, 3> planes{};
    const std::array<std::array<int, 4>, 3> others{{{1, 2, 3, 1}, {4, 1, 2, 1}, {2, 5, 1, 1}}};
    const PointId one = integer_point(kernel, {1, 1, 1, 3});
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array<PointId, 3> through{one, integer_point(kernel, others[i]),
                                             integer_point(kernel, others[(i + 1) % 3])};
        planes[i] = unoriented(kernel.join(std::span<const PointId, 3>(through)).value());
    }
    const PointId meet = kernel.add_meet(planes);
    const auto at = [&](double u, double v) { return kernel.add_point(std::array<double, 3>{u, v, 5}); };
    CHECK(turn(kernel, o, meet, at(2, 2), Projection::along(2)) == Sign::zero);
    CHECK(turn(kernel, o, meet, at(2, 2.0000000000000004), Projection::along(2)) == Sign::plus);
    CHECK(turn(kernel, o, meet, at(2.0000000000000004, 2), Projection::along(2)) == Sign::minus);
    CHECK(kernel.counts().exact_points > 0);
}

TEST_CASE("turn of kernel points: the filter and the exact test agree with integers") {
    Dice dice(11);
    Kernel<3> kernel;
    for (int n = 0; n < 2000; ++n) {
        std::array<std::array<int, 4>, 3> p{};
        std::array<PointId, 3> id{};
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < 3; ++i) p[k][i] = dice.between(-4, 4);
            p[k][3] = dice.between(1, 3);
            id[k] = integer_point(kernel, p[k]);
        }
        for (unsigned axis = 0; axis < 3; ++axis) {
            const std::size_t u = (axis + 1) % 3;
            const std::size_t v = (axis + 2) % 3;
            const auto minor = [&](const std::array<int, 4>& a, const std::array<int, 4>& b) {
                return a[u] * b[v] - a[v] * b[u];
            };
            const int det = minor(p[1], p[2]) * p[0][3] - minor(p[0], p[2]) * p[1][3] + minor(p[0], p[1]) * p[2][3];
            CHECK(turn(kernel, id[0], id[1], id[2], Projection::along(axis)) == sign_of_value(det));
        }
    }
}

TEST_CASE("projection of a plane: outward order of points is counter-clockwise") {
    Dice dice(5);
    for (int n = 0; n < 200; ++n) {
        Kernel<3> kernel;
        std::array<PointId, 3> through{};
        for (PointId& p : through)
            p = kernel.add_point(
                {double(dice.between(-3, 3)), double(dice.between(-3, 3)), double(dice.between(-3, 3))});
        const std::optional<PlaneId> plane = kernel.join(std::span<const PointId, 3>(through));
        if (!plane) continue;
        CHECK(turn(kernel, through[0], through[1], through[2], projection_of(kernel, *plane)) == Sign::plus);
        CHECK(turn(kernel, through[0], through[1], through[2], projection_of(kernel, flipped(*plane))) == Sign::minus);
    }
}
