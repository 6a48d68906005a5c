// SPDX-License-Identifier: Apache-2.0
// A disk that fills during a run, and has room for the next one.
#pragma once

#include <functional>
#include <string>

#include "apps/program.hpp"

namespace xgm::testing {

/// A run in `folder` that writes to `out` with --resume; `before` stands before its call.
using ResumedRun = std::function<Outcome(const std::string& before)>;

/// Runs it with `out` on a disk of `size` bytes (480k), then again with room, and copies what came
/// of it to `saved`. The full disk must be one error that leaves only what the next run goes on
/// from. False, and said, where this user may not mount a file system.
bool goes_on_after_full_disk(const std::string& folder, const std::string& size,
                             const ResumedRun& run);

}  // namespace xgm::testing
