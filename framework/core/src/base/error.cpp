// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/error.hpp"

namespace xgm {

Error::Error(const std::string& message) : Error("", message) {}

Error::Error(const std::string& stage_path, const std::string& message)
    : std::runtime_error(stage_path.empty() ? message : stage_path + ": " + message),
      stage_path_(stage_path),
      message_(message) {}

UsageError::UsageError(const std::string& message) : Error(message) {}
Cancelled::Cancelled() : Error("the run was cancelled") {}

}  // namespace xgm
