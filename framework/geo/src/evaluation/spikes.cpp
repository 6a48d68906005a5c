// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/evaluation/spikes.hpp"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace xgm::geo {

double spikes_on_flats(const cv::Mat1f& surface, const cv::Mat1f& truth, double posting,
                       const SpikeRules& rules) {
  const int side = 2 * static_cast<int>(std::lround(rules.reach / posting)) + 1;
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {side, side});
  // A cell without a truth is as if it stood out of any flat.
  constexpr float kFar = std::numeric_limits<float>::max() / 4;
  cv::Mat1f known = truth.clone(), highest, lowest;
  for (float& height : known) {
    if (!std::isfinite(height)) height = kFar;
  }
  cv::dilate(known, highest, window);
  cv::erode(known, lowest, window);
  std::int64_t cells = 0, spikes = 0;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      const bool flat = double{highest(y, x)} - double{lowest(y, x)} <= rules.level;
      if (!flat || !std::isfinite(truth(y, x)) || !std::isfinite(surface(y, x))) continue;
      ++cells;
      spikes += std::abs(double{surface(y, x)} - double{truth(y, x)}) > rules.size;
    }
  }
  return static_cast<double>(spikes) / static_cast<double>(cells);
}

}  // namespace xgm::geo
