// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/least_squares_matching/warp.hpp"

#include <cmath>

#include "xgm/base/parallel.hpp"

namespace xgm::least_squares_matching {
namespace {

struct Sample {
  float value, slope;
};

/// Between v[1] and v[2], `t` behind the first.
Sample cubic(const float* v, float t) {
  const float b = (v[2] - v[0]) / 2;
  const float c = v[0] - 2.5F * v[1] + 2 * v[2] - v[3] / 2;
  const float d = 1.5F * (v[1] - v[2]) + (v[3] - v[0]) / 2;
  return {v[1] + t * (b + t * (c + t * d)), b + t * (2 * c + 3 * t * d)};
}

bool all_valid(const Image& image, int y, int first, int count) {
  for (int x = first; x < first + count; ++x) {
    if (!image.is_valid(y, x)) return false;
  }
  return true;
}

}  // namespace

Warped warp(const DisparityMap& map, const ImagePair& pair) {
  constexpr int kSamples = 4;
  Warped warped{pair.base.grey(), cv::Mat1f(map.size(), 0.0F), cv::Mat1f(map.size(), 0.0F),
                cv::Mat1f(map.size(), 0.0F)};
  const cv::Mat1f match = pair.match.grey();
  parallel_for(0, map.size().height, [&](int y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (map.at(y, x) != Status::matched || !pair.base.is_valid(y, x)) continue;
      const float there = static_cast<float>(x) - map.disparity(y, x);
      const int first = static_cast<int>(std::floor(there)) - 1;
      if (first < 0 || first + kSamples > match.cols) continue;
      if (!all_valid(pair.match, y, first, kSamples)) continue;
      const Sample sample = cubic(match[y] + first, there - std::floor(there));
      warped.match(y, x) = sample.value;
      warped.slope(y, x) = sample.slope;
      warped.seen(y, x) = 1;
    }
  });
  return warped;
}

}  // namespace xgm::least_squares_matching
