// SPDX-License-Identifier: Apache-2.0
// What a run came to, on stdout.
#pragma once

#include "xgm/evaluation/recorded_run.hpp"

namespace xgm::cli {

/// With its end; empty if nothing was reused.
std::string reused_line(const std::vector<std::string>& results, const std::string& folder);

void print_summary(const RecordedRun& result, const RecordRequest& request);

}  // namespace xgm::cli
