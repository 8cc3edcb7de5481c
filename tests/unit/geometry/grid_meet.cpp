// SPDX-License-Identifier: Apache-2.0
#include <cleave/geometry/grid_meet.hpp>
//
#include <cleave/geometry/kernel.hpp>

#include "support/catch.hpp"
#include "support/dice.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

using namespace cleave;
using support::Dice;

namespace {

using Coefficients = std::array<Integer, 4>;

std::optional<std::array<double, 3>> meet_of(const std::array<Coefficients, 3>& h) {
    return grid_meet({&h[0], &h[1], &h[2]});
}

/// The double that is n / w; nullopt where none is.
std::optional<double> exact_double(const Integer& n, const Integer& w) {
    const double x = ratio_to_double(n, w);
    const Homogeneous<1> h = homogeneous_of<1>({x});
    return WideInteger(h[0]) * w == WideInteger(n) * h[1] ? std::optional(x) : std::nullopt;
}

/// By Cramer's rule in integers of any length; nullopt where the planes have no one point in common, or one that is no
/// point of doubles.
std::optional<std::array<double, 3>> expected(const std::array<Coefficients, 3>& h) {
    RowsView<3, 4, Integer> rows{};
    for (std::size_t n = 0; n < 3; ++n) rows.row[n] = &h[n];
    const auto v = minors<WideInteger>(rows);
    if (v[3].is_zero()) return std::nullopt;
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> q = exact_double(Integer(v[i]), Integer(v[3]));
        if (!q) return std::nullopt;
        x[i] = *q;
    }
    return x;
}

}  // namespace

TEST_CASE("grid meet: small planes meet in the point that Cramer's rule gives, or in none of doubles") {
    Dice dice(31);
    std::array<int, 2> answers{};
    for (int n = 0; n < 20000; ++n) {
        std::array<Coefficients, 3> h;
        const int most = dice.between(1, 6);
        for (Coefficients& c : h)
            for (Integer& x : c) x = Integer(dice.between(-most, most));
        const auto found = meet_of(h);
        CHECK(found == expected(h));
        ++answers[found ? 1 : 0];
    }
    CHECK(answers[0] > 1000);
    CHECK(answers[1] > 1000);
}

TEST_CASE("grid meet: the longest coefficients, on both sides of the limits") {
    Dice dice(32);
    const std::int64_t normal = std::int64_t(1) << 30;
    const std::int64_t offset = std::int64_t(1) << 62;
    std::array<int, 2> answers{};
    for (int n = 0; n < 5000; ++n) {
        std::array<Coefficients, 3> h;
        for (Coefficients& c : h) {
            for (std::size_t i = 0; i < 3; ++i)
                c[i] = Integer(dice.between(0, 2) == 0 ? 0
                                                       : (dice.between(0, 1) == 0 ? normal : -normal) +
                                                             dice.between(-1, 1) * dice.between(0, 1));
            c[3] = Integer((dice.between(0, 1) == 0 ? offset : -offset) >> dice.between(0, 3) * 8);
        }
        bool too_long = false;
        for (const Coefficients& c : h)
            for (std::size_t i = 0; i < 3; ++i)
                too_long = too_long || c[i] > Integer(normal) || c[i] < Integer(-normal);
        const auto found = meet_of(h);
        CHECK(found == (too_long ? std::nullopt : expected(h)));
        ++answers[found ? 1 : 0];
    }
    CHECK(answers[1] > 100);
    std::array<Coefficients, 3> h{Coefficients{1, 0, 0, Integer(offset)}, Coefficients{0, 1, 0, 0},
                                  Coefficients{0, 0, 1, 0}};
    CHECK(meet_of(h) == std::array<double, 3>{-0x1p62, 0, 0});
    h[0][3] = Integer(offset + 1);
    CHECK(!meet_of(h));
    h[0][3] = Integer(std::numeric_limits<std::int64_t>::min());
    CHECK(!meet_of(h));
    // 2^53 + 1 is no double, 2^53 + 2 is.
    h[0][3] = Integer(-((std::int64_t(1) << 53) + 1));
    CHECK(!meet_of(h));
    h[0][3] = Integer(-((std::int64_t(1) << 53) + 2));
    CHECK(meet_of(h) == std::array<double, 3>{0x1p53 + 2, 0, 0});
}

TEST_CASE("grid meet: the kernel knows a point of doubles that no axis-parallel planes make") {
    Kernel<3> kernel;
    const std::uint32_t a = unoriented(kernel.planes.intern({1, 1, 0, -3}));
    const std::uint32_t b = unoriented(kernel.planes.intern({1, -1, 0, 0}));
    const std::uint32_t c = unoriented(kernel.planes.intern({1, 1, 4, -4}));
    const PointId p = kernel.add_meet({a, b, c});
    kernel.refine(p);
    CHECK(kernel.point(p).is_of_doubles());
    CHECK(kernel.point(p).approximation == std::array<double, 3>{1.5, 1.5, 0.25});
    CHECK(kernel.same(p, kernel.add_point({1.5, 1.5, 0.25})));
    CHECK(kernel.counts().exact_points == 0);
    CHECK(kernel.side(2 * a, p) == Sign::zero);
}
