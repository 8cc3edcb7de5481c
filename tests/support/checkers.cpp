// SPDX-License-Identifier: Apache-2.0
// The checkers of regions, compiled once for all tests.
#define CLEAVE_INSTANTIATE_CHECKERS
#include "support/region_checker.hpp"
