// SPDX-License-Identifier: Apache-2.0
// The floors that need no numbers of others, with the library's own integers.
#include <cleave/base.hpp>
#include <cleave/clip/concepts.hpp>
#include <cleave/execution.hpp>
#include <cleave/number/fixed_int.hpp>
#include <cleave/number/integer.hpp>

#if defined(CLEAVE_HAS_GMP) || defined(CLEAVE_HAS_BOOST)
#error "the core uses a third party because its header happens to be installed"
#endif

int main() {
    const cleave::Integer two = 2;
    const bool right = cleave::BooleanFunction::union_(2)(1) && two * two == cleave::Integer(4);
    return right ? 0 : 1;
}
