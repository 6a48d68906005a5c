// SPDX-License-Identifier: Apache-2.0
// Runs a pipeline with an eye on pixels.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/support.hpp"
#include "xgm/evaluation/explain.hpp"
#include "xgm/testing/synthetic.hpp"

namespace xgm::testing {

inline std::vector<cv::Point> all_pixels(cv::Size size) { return pixel_grid(size, 1); }

/// A pipeline's result and the explanations of all pixels, in row-major order.
struct Explained {
  MatchResult result;
  std::vector<Explanation> pixels;

  const Explanation& at(int y, int x) const {
    return pixels[static_cast<std::size_t>(y * result.forward.size().width + x)];
  }
};

inline Pipeline loaded(const std::string& yaml) {
  LoadedPipeline result = load_pipeline_text(yaml, "test.yaml", builtins());
  for (const Diagnostic& diagnostic : result.diagnostics) FAIL(to_string(diagnostic));
  return *result.pipeline;
}

inline Explained explain_all(const Pipeline& pipeline, const ImagePair& pair,
                             const DisparityRange& range, const cv::Mat1f& truth = {}) {
  Explainer explainer(pair.size(), all_pixels(pair.size()), truth);
  MatchResult result = pipeline.run({pair, range, std::nullopt}, {.observer = &explainer});
  return {std::move(result), explainer.explanations()};
}

inline Explained explain_all(const std::string& yaml, const SyntheticScene& scene) {
  return explain_all(loaded(yaml), scene.pair,
                     DisparityRange::uniform(scene.pair.size(), scene.disparities), scene.truth);
}

inline SyntheticScene small_scene(std::uint64_t seed = 3) {
  return make_scene(
      {.size = {61, 43}, .disparities = {0, 12}, .seed = seed, .objects = 3, .shift = {}});
}

inline PixelState state_at(const DisparityMap& map, int y, int x) {
  return {map.disparity(y, x), map.at(y, x)};
}

}  // namespace xgm::testing
