// SPDX-License-Identifier: Apache-2.0
// Evaluations as JSON: one form for run.json, `pipeline eval` and `pipeline bench`. Figures that
// are not known (NaN) are null. docs/evaluate.md lists the fields. Exported for the tests only: the
// header is not installed.
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/evaluation/sparsification.hpp"

namespace xgm {

XGM_API Json to_json(const RegionEvaluation& evaluation);
XGM_API Json to_json(const std::vector<RegionEvaluation>& evaluations);

Json to_json(const RegionSparsification& sparsification);

}  // namespace xgm
