// SPDX-License-Identifier: Apache-2.0
// What `pipeline eval` finds, as files for programs.
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

/// Indented JSON; figures that are not known are null.
XGM_API std::string to_json(const EvaluationReport& report);

/// A line of headings, then a line per region (RFC 4180); figures that are not known are empty.
XGM_API std::string to_csv(const EvaluationReport& report);

}  // namespace xgm
