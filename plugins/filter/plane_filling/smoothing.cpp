// SPDX-License-Identifier: Apache-2.0
// Each row is summed downwards first, then sideways, in plain loops that compilers vectorise.
#include "plugins/filter/plane_filling/smoothing.hpp"

#include <algorithm>

#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

/// Sums of three rows with their weights; a 0 before the first column and one after the last.
class ThreeRows {
 public:
  explicit ThreeRows(std::size_t width)
      : width_(width), sums_(width + 2, 0.0F), weights_(width + 2, 0.0F) {}

  /// `valid`: 0 where there are no data; null: there are everywhere.
  void add(const float* levels, const std::uint8_t* valid, float weight) {
    float* const sums = sums_.data() + 1;
    float* const weights = weights_.data() + 1;
    for (std::size_t x = 0; x < width_; ++x) {
      const bool has_data = valid == nullptr || valid[x] != 0;
      sums[x] += has_data ? weight * levels[x] : 0.0F;
      weights[x] += has_data ? weight : 0.0F;
    }
  }
  void means(float* mean) const {
    for (std::size_t x = 0; x < width_; ++x) {
      const float sum = sums_[x] + 2 * sums_[x + 1] + sums_[x + 2];
      const float weight = weights_[x] + 2 * weights_[x + 1] + weights_[x + 2];
      mean[x] = sum / std::max(weight, 1.0F);  // 1 is the least that is not 0
    }
  }

 private:
  std::size_t width_;
  std::vector<float> sums_, weights_;
};

}  // namespace

std::vector<cv::Mat1f> smoothed(const Image& image) {
  const cv::Size size = image.size();
  std::vector<cv::Mat1f> smooth;
  for (const cv::Mat1f& plane : image.planes) {
    cv::Mat1f mean(size);
    parallel_for(0, size.height, [&](int y) {
      ThreeRows rows(static_cast<std::size_t>(size.width));
      for (int v = std::max(0, y - 1); v <= std::min(size.height - 1, y + 1); ++v) {
        rows.add(plane[v], image.valid.empty() ? nullptr : image.valid[v], v == y ? 2.0F : 1.0F);
      }
      rows.means(mean[y]);
    });
    smooth.push_back(mean);
  }
  return smooth;
}

}  // namespace xgm::plane_filling
