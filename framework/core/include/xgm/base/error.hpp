// SPDX-License-Identifier: Apache-2.0
// What is thrown: failures of a run, that it was cancelled, and mistakes of the caller that are
// found before it.
#pragma once

#include <stdexcept>
#include <string>

#include "xgm/base/export.hpp"

namespace xgm {

/// A run that cannot go on. `message` says what is wrong and what to do about it; `stage_path`
/// names the stage that failed ("matcher.matcher.cost"), empty outside stages. Stages throw
/// Error(message); the slot that called the stage adds the path.
class XGM_API Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message);
  Error(const std::string& stage_path, const std::string& message);

  const std::string& stage_path() const { return stage_path_; }
  const std::string& message() const { return message_; }

 private:
  std::string stage_path_;
  std::string message_;
};

/// A run that was ended from outside, see RunOptions::stop: no failure of a stage, so it has no
/// path.
class XGM_API Cancelled : public Error {
 public:
  Cancelled();
};

/// A mistake of the caller, found before any work: a name that does not exist, a file that is
/// missing, values that contradict each other. Programs tell it from a run that failed (the command
/// line returns 2 instead of 1).
class XGM_API UsageError : public Error {
 public:
  explicit UsageError(const std::string& message);
};

}  // namespace xgm
