// SPDX-License-Identifier: Apache-2.0
// The errors above which a pixel counts as bad.
#pragma once

#include <string>
#include <vector>

#include "command_line/command.hpp"

namespace xgm::cli {

/// --thresholds.
void add_thresholds_option(Command command, std::string& thresholds);

/// "0.5,1,2": rising, 0 or more; the usual ones if it is empty. Throws UsageError.
std::vector<double> parse_thresholds(const std::string& text);

}  // namespace xgm::cli
