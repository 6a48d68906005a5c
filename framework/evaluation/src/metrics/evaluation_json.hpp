// SPDX-License-Identifier: Apache-2.0
// Evaluations as JSON: one form for run.json, `pipeline eval` and `pipeline bench`. Figures that
// are not known (NaN) are null. docs/evaluate.md lists the fields. Exported for the tests only: the
// header is not installed.
#pragma once

#include <nlohmann/json.hpp>

#include "xgm/evaluation/metrics.hpp"
#include "xgm/evaluation/sparsification.hpp"

namespace xgm {

XGM_API nlohmann::ordered_json to_json(const RegionEvaluation& evaluation);
XGM_API nlohmann::ordered_json to_json(const std::vector<RegionEvaluation>& evaluations);

nlohmann::ordered_json to_json(const RegionSparsification& sparsification);

}  // namespace xgm
