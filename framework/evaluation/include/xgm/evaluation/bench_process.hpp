// SPDX-License-Identifier: Apache-2.0
// Runs in separate processes, so that the memory or a crash of one run does not affect another.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/bench_jobs.hpp"

namespace xgm {

/// While an object exists, SIGINT, SIGTERM and SIGHUP are recorded instead of ending the process.
class XGM_API Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  /// The signal that was received; 0 if none.
  static int signal();
};

/// Runs the file `program`, its output going to `log`, until it ends or this process is told to; it
/// does not outlive this process. `words` are its command line, the program's own name first.
/// `failure` is the last error that it printed, or how it ended.
XGM_API RunOutcome run_program(const std::string& program, const std::vector<std::string>& words,
                               const std::string& log);

}  // namespace xgm
