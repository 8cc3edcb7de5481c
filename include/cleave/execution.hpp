// SPDX-License-Identifier: Apache-2.0
/// Floor 1: how long work runs, reports and stops. Nothing geometric is seen from here.
#ifndef CLEAVE_EXECUTION_HPP
#define CLEAVE_EXECUTION_HPP

#include <cleave/execution/executor.hpp>
#include <cleave/execution/progress.hpp>

#endif
