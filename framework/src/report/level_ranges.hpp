// SPDX-License-Identifier: Apache-2.0
// What a level of a pyramid searched.
#pragma once

#include <optional>

#include "report/encode.hpp"
#include "xgm/report.hpp"

namespace xgm::report {

/// The level's ranges, kept within the disparities of the run (as the record has them) at the
/// level's scale, as the pyramid does; all of those if the level has no ranges of its own. Nothing
/// if neither is known.
std::optional<DisparityRange> searched(const ReportLevel& level, const Json& record);

}  // namespace xgm::report
