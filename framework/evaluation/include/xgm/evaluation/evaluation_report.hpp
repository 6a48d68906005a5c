// SPDX-License-Identifier: Apache-2.0
// The results of `pipeline eval` as JSON and CSV.
#pragma once

#include <string>
#include <vector>

#include "xgm/evaluation/metrics.hpp"
#include "xgm/evaluation/sparsification.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {

struct EvaluationReport {
  std::vector<InputFile> inputs;  ///< roles "map", "truth", "truth mask", "object map", ...
  cv::Size size;
  EvaluationRules rules;
  std::vector<RegionEvaluation> regions;
  std::vector<RegionSparsification> confidence;  ///< empty without a confidence
};

/// Indented JSON; unknown figures are null.
XGM_API std::string to_json(const EvaluationReport& report);

/// A header line, then a line per region (RFC 4180); unknown figures are empty.
XGM_API std::string to_csv(const EvaluationReport& report);

}  // namespace xgm
