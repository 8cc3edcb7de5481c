// SPDX-License-Identifier: Apache-2.0
// The floors that need no numbers of others.
#include <cleave/base.hpp>
#include <cleave/execution.hpp>

#if defined(CLEAVE_HAS_GMP) || defined(CLEAVE_HAS_BOOST)
#error "the core uses a third party because its header happens to be installed"
#endif

int main() {
    return cleave::BooleanFunction::union_(2)(1) ? 0 : 1;
}
