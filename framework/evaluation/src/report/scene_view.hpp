// SPDX-License-Identifier: Apache-2.0
// What the parts of the page need of a scene: records parsed, colours agreed upon.
#pragma once

#include <vector>

#include "report/encode.hpp"
#include "report/palette.hpp"
#include "xgm/evaluation/report.hpp"

namespace xgm::report {

struct SceneView {
  const ReportScene& scene;
  std::vector<Json> records;       ///< one per run; null if it has none
  std::vector<Json> explanations;  ///< one per run; an array
  Span span;                       ///< of disparities in all of the scene's maps, px

  bool has_truth() const { return !scene.truth.disparity.empty(); }
};

/// Throws Error: sizes that differ, texts that are no JSON.
SceneView view_of(const ReportScene& scene);

}  // namespace xgm::report
