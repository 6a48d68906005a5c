// SPDX-License-Identifier: Apache-2.0
// A program of somebody else's that does the work of a stage.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/config/parameters.hpp"
#include "xgm/stage/context.hpp"

namespace xgm::exchange {

struct Program {
  std::vector<std::string> command;  ///< the program and its arguments; no shell reads them
  double time_limit = 600;           ///< s
  double memory_limit = 0;           ///< MB of address space of each of its processes; 0: any
};

/// The parameters of a stage that runs one.
XGM_API void declare(Program& program, ParameterSet& set);

/// Runs the command with one more argument, and waits for its end. What it prints is told to the
/// log line by line, as long as that is not too much. It has no input, and is a group of processes
/// of its own, which is gone when this returns or throws. Throws Error, in one line, if it cannot
/// be started, fails, takes too long or prints without end; Cancelled within half a second if the
/// run is.
XGM_API void run_program(const Program& program, const std::string& argument,
                         const Context& context);

}  // namespace xgm::exchange
