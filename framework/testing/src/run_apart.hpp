// SPDX-License-Identifier: Apache-2.0
// Work in a child process, which may die of it.
#pragma once

#include <functional>
#include <string>

namespace xgm::testing {

/// Takes a line of text.
using Tell = std::function<void(const std::string&)>;

/// Calls `work` in a child process, and `take` here with each line that it tells. Returns how the
/// child died, as "signal 11 (Segmentation fault)"; "" if it came to its end. It is ended if it
/// tells nothing for so many seconds. Its standard output goes to standard error. Throws Error.
std::string run_apart(const std::function<void(const Tell&)>& work, const Tell& take,
                      double seconds);

}  // namespace xgm::testing
