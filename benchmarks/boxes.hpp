// SPDX-License-Identifier: Apache-2.0
/// Random integer boxes, the same on every machine, as regions and as numbers.
#ifndef CLEAVE_BENCHMARKS_BOXES_HPP
#define CLEAVE_BENCHMARKS_BOXES_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/setop/apply.hpp>
#include <cleave/shape/box.hpp>

#include <array>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace boxes {

/// Corners on the grid 0 .. extent.
inline constexpr int extent = 10;

template <int D>
struct IntegerBox {
    std::array<int, std::size_t(D)> lo;
    std::array<int, std::size_t(D)> hi;

    /// Whether it contains the unit cell whose least corner is `at`.
    [[nodiscard]] bool contains(const std::array<int, std::size_t(D)>& at) const {
        for (std::size_t i = 0; i < std::size_t(D); ++i)
            if (at[i] < lo[i] || at[i] >= hi[i]) return false;
        return true;
    }
};

template <int D>
[[nodiscard]] std::vector<IntegerBox<D>> random(unsigned seed, int count) {
    std::mt19937 draw(seed);
    std::vector<IntegerBox<D>> list(std::size_t(count), IntegerBox<D>{});
    for (IntegerBox<D>& b : list)
        for (std::size_t i = 0; i < std::size_t(D); ++i) {
            int x = int(draw() % unsigned(extent));
            int y = int(draw() % unsigned(extent));
            if (x > y) std::swap(x, y);
            b.lo[i] = x;
            b.hi[i] = y + 1;
        }
    return list;
}

template <int D>
[[nodiscard]] cleave::Region<D> sum(const std::vector<IntegerBox<D>>& list) {
    std::vector<cleave::Region<D>> regions;
    for (const IntegerBox<D>& b : list) {
        std::array<cleave::Rational, std::size_t(D)> lo;
        std::array<cleave::Rational, std::size_t(D)> hi;
        for (std::size_t i = 0; i < std::size_t(D); ++i) {
            lo[i] = b.lo[i];
            hi[i] = b.hi[i];
        }
        regions.push_back(cleave::box<D>(lo, hi));
    }
    return cleave::evaluate<D, cleave::Rational>(cleave::BooleanFunction::union_(unsigned(list.size())), regions);
}

/// The number of unit cells in some box of `a` and in none of `b`: the measure of the difference, counted.
template <int D>
[[nodiscard]] int cells_of_difference(const std::vector<IntegerBox<D>>& a, const std::vector<IntegerBox<D>>& b) {
    const auto in = [](const std::vector<IntegerBox<D>>& list, const auto& at) {
        for (const IntegerBox<D>& box : list)
            if (box.contains(at)) return true;
        return false;
    };
    int count = 0;
    std::array<int, std::size_t(D)> at{};
    for (std::size_t i = 0; i < std::size_t(D);) {
        count += in(a, at) && !in(b, at) ? 1 : 0;
        for (i = 0; i < std::size_t(D) && ++at[i] == extent; ++i) at[i] = 0;
    }
    return count;
}

}  // namespace boxes

#endif
