// SPDX-License-Identifier: Apache-2.0
/// What takes longest to parse and changes never, for the precompiled headers of the tests.
#ifndef CLEAVE_TESTS_SUPPORT_PRECOMPILED_HPP
#define CLEAVE_TESTS_SUPPORT_PRECOMPILED_HPP

#include "support/property.hpp"

#if defined(CLEAVE_WITH_GMP)
#include <gmpxx.h>
#endif
#if defined(CLEAVE_WITH_BOOST)
#include <boost/multiprecision/cpp_int.hpp>
#if defined(CLEAVE_WITH_GMP)
#include <boost/multiprecision/gmp.hpp>
#endif
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#endif
