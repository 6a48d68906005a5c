// SPDX-License-Identifier: Apache-2.0
// A plan of a run for programs.
#pragma once

#include <string>

#include "xgm/base/export.hpp"
#include "xgm/pipeline/plan.hpp"

namespace xgm {

/// Indented JSON: what was asked, the peak, and all stages in the order in which they begin. Bytes,
/// seconds, px.
XGM_API std::string to_json(const RunPlan& plan, const PlanRequest& request);

}  // namespace xgm
