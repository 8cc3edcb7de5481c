// SPDX-License-Identifier: Apache-2.0
// refused: (constraint|ExactRing)
// Determinants of doubles would be approximate: double is not an exact ring.
#include <cleave/algebra/matrix.hpp>
#include <cleave/number/builtin.hpp>

#if defined(CLEAVE_MUST_NOT_COMPILE)
using Number = double;
#else
using Number = cleave::Integer;
#endif

cleave::Matrix<2, 3, Number> matrix;
