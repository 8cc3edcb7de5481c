// SPDX-License-Identifier: Apache-2.0
// refused: (constraint|ExactRing)
// Built-in integers overflow without a word, so they are no exact ring.
#include <cleave/algebra/solve.hpp>
#include <cleave/number/builtin.hpp>

#if defined(CLEAVE_MUST_NOT_COMPILE)
using Number = long long;
#else
using Number = cleave::FixedInt<128>;
#endif

cleave::Solution<2, Number> solution;
