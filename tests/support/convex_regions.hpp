// SPDX-License-Identifier: Apache-2.0
/// The sets of convex_sets.hpp as regions.
#ifndef CLEAVE_TESTS_SUPPORT_CONVEX_REGIONS_HPP
#define CLEAVE_TESTS_SUPPORT_CONVEX_REGIONS_HPP

#include "support/convex_sets.hpp"

#include <cleave/region/convex.hpp>

#include <vector>

namespace support {

/// The intersection of the half-spaces n . x + c <= 0.
template <int D>
[[nodiscard]] cleave::Region<D> region_of(const std::vector<IntegerPlane<D>>& list) {
    std::vector<cleave::Plane<D, cleave::Integer>> planes;
    for (const IntegerPlane<D>& p : list) planes.push_back(cleave::make_plane<cleave::Integer>(p));
    return cleave::half_spaces<D, cleave::Integer>(planes);
}

}  // namespace support

#endif
