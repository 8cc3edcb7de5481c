// SPDX-License-Identifier: Apache-2.0
/// Floor 0: configuration, contracts, errors, Boolean functions, winding rules and source tags. Needs the standard
/// library alone.
#ifndef CLEAVE_BASE_HPP
#define CLEAVE_BASE_HPP

#include <cleave/base/boolean_function.hpp>
#include <cleave/base/config.hpp>
#include <cleave/base/contract.hpp>
#include <cleave/base/disjoint_sets.hpp>
#include <cleave/base/error.hpp>
#include <cleave/base/large_vector.hpp>
#include <cleave/base/operation.hpp>
#include <cleave/base/source.hpp>
#include <cleave/base/winding_rule.hpp>

#endif
