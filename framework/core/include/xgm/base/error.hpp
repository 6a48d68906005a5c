// SPDX-License-Identifier: Apache-2.0
// What is thrown while a pipeline runs: failures, and that it was cancelled.
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

}  // namespace xgm
