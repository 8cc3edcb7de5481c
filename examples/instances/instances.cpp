// SPDX-License-Identifier: Apache-2.0
#define CLEAVE_INSTANTIATE
#include <cleave/extern.hpp>
