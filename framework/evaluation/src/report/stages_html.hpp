// SPDX-License-Identifier: Apache-2.0
// Where the time of a run went, from the stages in its record.
#pragma once

#include <string>

#include "report/encode.hpp"

namespace xgm::report {

/// Time per plugin with bars, and every call below; "" if the record has no stages.
std::string stages_html(const Json& record);

/// Seconds of the stage at this path; NaN if it did not run.
double seconds_of(const Json& record, const std::string& stage_path);

}  // namespace xgm::report
