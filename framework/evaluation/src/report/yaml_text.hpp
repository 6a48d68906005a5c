// SPDX-License-Identifier: Apache-2.0
// A resolved pipeline as YAML for reading and for running again.
#pragma once

#include <string>

#include "xgm/base/json.hpp"

namespace xgm::report {

/// Short maps and lists of plain values stand in one line, as in the shipped pipelines.
std::string yaml_text(const Json& value);

}  // namespace xgm::report
