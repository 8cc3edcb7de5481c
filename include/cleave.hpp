// SPDX-License-Identifier: Apache-2.0
/// Everything in cleave except the opt-in adapters (`cleave/execution/tbb.hpp`).
#ifndef CLEAVE_HPP
#define CLEAVE_HPP

#include <cleave/base.hpp>
#include <cleave/execution.hpp>

#endif
