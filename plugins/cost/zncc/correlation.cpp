// SPDX-License-Identifier: Apache-2.0
// Correlation from six box sums, in double: variances are small differences of large sums.
#include "plugins/cost/zncc/correlation.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace xgm::zncc {
namespace {

// Windows of less variance (grey levels squared) are flat: far below one level in one pixel of the
// largest window, far above rounding.
constexpr double kFlat = 1e-6;

}  // namespace

Correlator::Correlator(const ImagePair& pair, cv::Rect tile, int window)
    : pair_(pair),
      tile_(tile),
      window_(window),
      support_(tile.x - window / 2, tile.y - window / 2, tile.width + window - 1,
               tile.height + window - 1),
      samples_(support_.size()),
      result_(tile.size()) {}

const cv::Mat1d& Correlator::at(int d) {
  const std::size_t channels = pair_.base.planes.size();
  const int radius = window_ / 2;
  result_ = 0.0;
  for (std::size_t channel = 0; channel < channels; ++channel) {
    sample(channel, d);
    // Any border will do: only windows inside the support are read.
    cv::boxFilter(samples_, sums_, CV_64F, {window_, window_}, {-1, -1}, false);
    for (int y = 0; y < tile_.height; ++y) {
      for (int x = 0; x < tile_.width; ++x) {
        result_(y, x) += correlation(sums_(y + radius, x + radius)) / static_cast<double>(channels);
      }
    }
  }
  return result_;
}

void Correlator::sample(std::size_t channel, int d) {
  const cv::Rect image({0, 0}, pair_.size());
  const cv::Rect common = support_ & image & (image + cv::Point(d, 0));
  samples_ = Sample::all(0);
  for (int y = common.y; y < common.y + common.height; ++y) {
    for (int x = common.x; x < common.x + common.width; ++x) {
      if (!pair_.base.is_valid(y, x) || !pair_.match.is_valid(y, x - d)) continue;
      const double b = pair_.base.planes[channel](y, x);
      const double m = pair_.match.planes[channel](y, x - d);
      samples_(y - support_.y, x - support_.x) = {1, b, m, b * b, m * m, b * m};
    }
  }
}

double Correlator::correlation(const Sample& sums) {
  const double n = sums[0];
  const double base_variance = n * sums[3] - sums[1] * sums[1];  // times n squared, as below
  const double match_variance = n * sums[4] - sums[2] * sums[2];
  const double covariance = n * sums[5] - sums[1] * sums[2];
  if (std::min(base_variance, match_variance) <= kFlat * n * n) return 0;
  return std::clamp(covariance / std::sqrt(base_variance * match_variance), -1.0, 1.0);
}

}  // namespace xgm::zncc
