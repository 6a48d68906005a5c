// SPDX-License-Identifier: Apache-2.0
// What `pipeline eval` finds, as files for programs.
#pragma once

#include <string>
#include <vector>

#include "xgm/io/scene.hpp"
#include "xgm/metrics.hpp"
#include "xgm/sparsification.hpp"

namespace xgm {

struct Judgement {
  std::vector<InputFile> inputs;  ///< roles "map", "truth", "truth mask", "object map", ...
  cv::Size size;
  EvaluationRules rules;
  std::vector<RegionEvaluation> regions;
  std::vector<RegionSparsification> confidence;  ///< empty without a confidence
};

/// Indented JSON; figures that are not known are null.
XGM_API std::string to_json(const Judgement& judgement);

/// A line of headings, then a line per region (RFC 4180); figures that are not known are empty.
XGM_API std::string to_csv(const Judgement& judgement);

}  // namespace xgm
