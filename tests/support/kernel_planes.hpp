// SPDX-License-Identifier: Apache-2.0
/// Points and planes of a kernel in short.
#ifndef CLEAVE_TESTS_SUPPORT_KERNEL_PLANES_HPP
#define CLEAVE_TESTS_SUPPORT_KERNEL_PLANES_HPP

#include <cleave/geometry/kernel.hpp>

#include <array>
#include <cstddef>

namespace support {

template <std::size_t D>
using Doubles = std::array<double, D>;

/// The plane a x + b y + c z + d = 0, plus where the form is positive.
inline cleave::PlaneId plane_of(cleave::Kernel<3>& kernel, int a, int b, int c, int d) {
    using cleave::Integer;
    return kernel.planes.intern({Integer(a), Integer(b), Integer(c), Integer(d)});
}

}  // namespace support

#endif
