// SPDX-License-Identifier: Apache-2.0
// The subcommands.
#pragma once

#include "interrupt.hpp"
#include "options.hpp"
#include "progress_bar.hpp"

/// Runs the subcommand. Returns the exit status; throws what the library throws for bad input, and Cancelled.
int run(const Options& options, Interrupt& interrupt, ProgressBar& bar);
