// SPDX-License-Identifier: Apache-2.0
/// Floor 1: how long work runs, reports and stops. Nothing geometric is seen from here.
#ifndef CLEAVE_EXECUTION_HPP
#define CLEAVE_EXECUTION_HPP

#include <cleave/execution/chunks.hpp>
#include <cleave/execution/executor.hpp>
#include <cleave/execution/executor_ref.hpp>
#include <cleave/execution/progress.hpp>
#include <cleave/execution/thread_pool.hpp>

#endif
