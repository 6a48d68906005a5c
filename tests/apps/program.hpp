// SPDX-License-Identifier: Apache-2.0
// Runs the built command line as a user would.
#pragma once

#include <string>

namespace xgm::testing {

struct Outcome {
  int exit_code = -1;  ///< 128 + signal if it was killed
  std::string output;  ///< stdout
  std::string errors;  ///< stderr
};

/// `arguments` go through a shell, in a folder of the test's own. `before` stands before the call:
/// "NAME=value " or "ulimit ... && ".
Outcome pipeline(const std::string& folder, const std::string& arguments,
                 const std::string& before = {});

/// Exit code 2, and a message with this text.
void check_usage_error(const Outcome& outcome, const std::string& message);

}  // namespace xgm::testing
