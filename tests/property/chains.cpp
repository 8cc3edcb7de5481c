// SPDX-License-Identifier: Apache-2.0
// Long chains of operations: results are operands, and no number grows. Every plane of a result is a plane of an input
// (or perpendicular to an axis at a double), so after a thousand operations numbers are as long as after one.
#include <cleave/setop/operators.hpp>

#include "support/convex_sets.hpp"
#include "support/region_generators.hpp"

using namespace cleave;
using namespace support;

namespace {

/// A small box or simplex somewhere in the range.
template <int D>
Part<D> random_part(Dice& dice, int size, int range) {
    Part<D> p;
    p.is_box = dice.below(2) == 0;
    std::array<int, std::size_t(D)> corner{};
    for (int& x : corner) x = dice.below(range - size + 1);
    for (auto& point : p.points)
        for (std::size_t i = 0; i < std::size_t(D); ++i) point[i] = corner[i] + dice.below(size + 1);
    return p;
}

struct Bits {
    std::size_t planes = 0;
    std::size_t points = 0;
};

/// The longest plane coefficient and homogeneous coordinate of a boundary.
template <int D>
Bits bits_of(const Region<D>& region) {
    const Boundary<D>& b = region.boundary();
    Bits bits;
    bits.planes = std::max(b.planes.bits().first, b.planes.bits().second);
    Kernel<D> kernel;
    const LoadedBoundary<D> loaded = load(b, kernel);
    for (PointId p = 0; p < b.points.size(); ++p)
        for (const Integer& x : kernel.coordinates(loaded.first_point + p))
            bits.points = std::max<std::size_t>(bits.points, x.bit_length());
    return bits;
}

/// Applies `count` tools; verifies every `stride`-th result and the numbers of each.
template <int D>
void chain(unsigned seed, int count, int stride, int range, std::size_t plane_bound, std::size_t point_bound) {
    Dice dice(seed);
    Coordinates<D> lo;
    Coordinates<D> hi;
    for (std::size_t i = 0; i < std::size_t(D); ++i) {
        lo[i] = 0;
        hi[i] = range;
    }
    const Region<D> block = box<D>(lo, hi);
    Region<D> part = block;
    std::vector<std::pair<Part<D>, Operation>> history;
    Bits longest;
    for (int step = 1; step <= count; ++step) {
        const Part<D> tool = random_part<D>(dice, 3, range);
        const Operation operation = std::array{Operation::difference, Operation::difference, Operation::union_,
                                               Operation::symmetric_difference}[std::size_t(dice.below(4))];
        history.push_back({tool, operation});
        const bool check_all = step % stride == 0;
        part = check_all ? checked(operation, part, tool.region()) : apply(operation, part, tool.region());
        if (!check_all) continue;
        const Bits bits = bits_of(part);
        longest.planes = std::max(longest.planes, bits.planes);
        longest.points = std::max(longest.points, bits.points);
        // Points against the whole history.
        const ExactRegion<D> exact(part);
        for (int probe = 0; probe < 20; ++probe) {
            Coordinates<D> p;
            for (std::size_t i = 0; i < std::size_t(D); ++i)
                p[i] = Rational(dice.below(7 * range)) / 7 + Rational(1) / std::array{1009, 1301, 1523}[i];
            bool expected = true;
            for (const auto& [t, o] : history) {
                const Where w = t.locate(p);
                REQUIRE(w != Where::boundary);
                expected = apply(o, expected, w == Where::inside);
            }
            CHECK(exact.locate(p) == (expected ? Where::inside : Where::outside));
        }
    }
    INFO("planes " << longest.planes << " bits, points " << longest.points << " bits, faces " << part.face_count());
    CHECK(longest.planes <= plane_bound);
    CHECK(longest.points <= point_bound);
}

}  // namespace

// With corners |c| <= 2^b a line has coefficients of at most b + 1 (normal) and 2b + 1 (offset) bits and a vertex at
// most 3b + 3; in space 2b + 2, 3b + 2 and 9b + 9 (the product of a normal's minor with an offset).

TEST_CASE("chains: a thousand cuts in the plane leave numbers as long as one does") {
    chain<2>(1, int(scaled(1000)), 50, 16, 2 * 4 + 1, 3 * 4 + 3);
}

TEST_CASE("chains: hundreds of cuts in space leave numbers as long as one does") {
    chain<3>(2, int(scaled(400)), 40, 8, 3 * 3 + 2, 9 * 3 + 9);
}
