// SPDX-License-Identifier: Apache-2.0
// The operations on regions, compiled once for all tests, as <cleave/extern.hpp> tells users to.
#define CLEAVE_INSTANTIATE
#include <cleave/extern.hpp>
