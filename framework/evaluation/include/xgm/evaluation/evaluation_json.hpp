// SPDX-License-Identifier: Apache-2.0
// Evaluations as JSON: one form for run.json, `pipeline eval` and `pipeline bench`. Figures that
// are not known (NaN) are null. docs/evaluate.md lists the fields.
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/evaluation/sparsification.hpp"

namespace xgm {

XGM_API Json to_json(const RegionEvaluation& evaluation);
XGM_API Json to_json(const std::vector<RegionEvaluation>& evaluations);
/// What to_json made of an evaluation. Throws Error if it is none.
XGM_API Evaluation evaluation_of(const Json& region);

XGM_API Json to_json(const RegionSparsification& sparsification);

}  // namespace xgm
