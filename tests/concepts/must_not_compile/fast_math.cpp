// SPDX-License-Identifier: Apache-2.0
// Under -ffast-math a floating-point filter is no proof, so the library stops the build.
// refused: cannot be compiled with -ffast-math
#ifdef CLEAVE_MUST_NOT_COMPILE
#define __FAST_MATH__ 1
#endif
#include <cleave/base/config.hpp>
