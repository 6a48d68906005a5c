// SPDX-License-Identifier: Apache-2.0
// What makes a map look wrong, though the run went well.
#pragma once

#include <string>
#include <vector>

#include "xgm/data/map_summary.hpp"
#include "xgm/evaluation/run_record.hpp"

namespace xgm {

/// Sentences about a map with few matched pixels, or with many at an end of the search range.
std::vector<std::string> doubts(const MapSummary& map, const RunRecord& record);

}  // namespace xgm
