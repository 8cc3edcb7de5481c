// SPDX-License-Identifier: Apache-2.0
/// Simplices and boxes of any dimension in positions where all that they share is known by hand.
#ifndef CLEAVE_TESTS_SUPPORT_SHARED_FACES_HPP
#define CLEAVE_TESTS_SUPPORT_SHARED_FACES_HPP

#include "support/convex_sets.hpp"

#include <array>
#include <cstddef>

namespace support {

/// The simplex x_i >= low, x_1 + ... + x_D <= sum: plane i < D is x_i = low, plane D the sloping one. Its first
/// `mirrored` axes are turned round after that.
///
/// With low = 0 it shares with the one that is not mirrored exactly the face x_1 = ... = x_mirrored = 0, of
/// D - mirrored dimensions: a facet for 1, a ridge for 2, an edge for D - 1, a vertex for D.
template <int D>
[[nodiscard]] HalfSpaces<D> corner_simplex(int low, int sum, int mirrored = 0) {
    HalfSpaces<D> set;
    IntegerPlane<D> sloping{};
    for (int i = 0; i < D; ++i) {
        IntegerPlane<D> p{};
        p[std::size_t(i)] = i < mirrored ? 1 : -1;
        p[std::size_t(D)] = low;
        set.planes.push_back(p);
        sloping[std::size_t(i)] = i < mirrored ? -1 : 1;
    }
    sloping[std::size_t(D)] = -sum;
    set.planes.push_back(sloping);
    return set;
}

/// The unit cube, its first `mirrored` axes turned round: shares with the one that is not mirrored what simplices do.
/// Plane 2 i is the lower one across axis i, plane 2 i + 1 the upper one.
template <int D>
[[nodiscard]] HalfSpaces<D> corner_cube(int mirrored = 0) {
    std::array<int, std::size_t(D)> lo{};
    std::array<int, std::size_t(D)> hi{};
    hi.fill(1);
    for (int i = 0; i < mirrored; ++i) {
        lo[std::size_t(i)] = -1;
        hi[std::size_t(i)] = 0;
    }
    return integer_box<D>(lo, hi);
}

/// [first_lo, first_hi] x [lo, hi]^(D - 1).
template <int D>
[[nodiscard]] HalfSpaces<D> block(int first_lo, int first_hi, int lo, int hi) {
    std::array<int, std::size_t(D)> from{};
    std::array<int, std::size_t(D)> to{};
    from.fill(lo);
    to.fill(hi);
    from[0] = first_lo;
    to[0] = first_hi;
    return integer_box<D>(from, to);
}

}  // namespace support

#endif
