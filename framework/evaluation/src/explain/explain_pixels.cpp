// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/explain_pixels.hpp"

namespace xgm {

std::unique_ptr<Explainer> make_explainer(const ExplainPixels& wanted, const Scene& scene) {
  const cv::Size size = scene.pair.size();
  std::vector<cv::Point> pixels = wanted.pixels;
  if (wanted.every > 0) {
    for (const cv::Point& pixel : pixel_grid(size, wanted.every)) pixels.push_back(pixel);
  }
  return std::make_unique<Explainer>(size, std::move(pixels), scene.truth.disparity);
}

}  // namespace xgm
