// SPDX-License-Identifier: Apache-2.0
/// Integers of any size, complete: `BasicInteger` with its operators, and the functions of integers.
#ifndef CLEAVE_NUMBER_INTEGER_HPP
#define CLEAVE_NUMBER_INTEGER_HPP

#include <cleave/number/basic_integer.hpp>
#include <cleave/number/integer_functions.hpp>

#endif
