// SPDX-License-Identifier: Apache-2.0
// Ctrl-C and its like end a run in order: nothing half done is left.
#pragma once

#include <optional>
#include <stop_token>
#include <thread>

#include "xgm/evaluation/bench_process.hpp"

namespace xgm::cli {

/// While it exists, the first SIGINT, SIGTERM or SIGHUP asks the run that has the token to stop;
/// the second ends the process at once.
class StopOnSignal {
 public:
  StopOnSignal();
  std::stop_token token() const { return run_.get_token(); }

 private:
  std::stop_source run_;
  std::optional<Interruptible> interruptible_;
  std::jthread watch_;  // ends before what it uses
};

}  // namespace xgm::cli
