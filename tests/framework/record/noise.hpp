// SPDX-License-Identifier: Apache-2.0
// A small run for tests of what is kept of runs.
#pragma once

#include "support/support.hpp"
#include "xgm/pipeline/scene_inputs.hpp"

namespace xgm::testing {

inline const cv::Size kNoiseSize(80, 24);

inline const std::string kNoisePipeline =
    "matcher: {type: semi_global, cost: census, penalty: {type: constant, p1: 3, p2: 12}, "
    "aggregation: sgm}\n";

inline Pipeline noise_pipeline() {
  const LoadedPipeline loaded = load_pipeline_text(kNoisePipeline, "shift.yaml", builtins());
  REQUIRE(loaded.pipeline.has_value());
  return *loaded.pipeline;
}

/// A scene in memory whose disparity is the same everywhere.
inline SceneRequest noise(int disparity) {
  Scene scene{.name = "noise",
              .pair = shifted_pair(kNoiseSize, disparity, 5),
              .disparities = Interval{0, 32}};
  scene.truth.disparity = cv::Mat1f(kNoiseSize, static_cast<float>(disparity));
  return {.scene = scene};
}

}  // namespace xgm::testing
