// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/edges.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plugins/filter/plane_filling/smoothing.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

constexpr std::uint16_t kNotJoined = 256 * Edge::kSteps;

/// The weights of the edges from one row to another, or from it to itself, `ahead` columns ahead.
class RowOfEdges {
 public:
  RowOfEdges(const DisparityMap& map, const Image& image, const std::vector<cv::Mat1f>& planes,
             float jump)
      : map_(map), image_(image), planes_(planes), jump_(jump) {}

  /// Of each pixel to `weight[2 * x]`.
  void find(int from, int to, int ahead, std::uint16_t* weight) const {
    const int width = map_.size().width - ahead;
    std::vector<float> difference(static_cast<std::size_t>(map_.size().width), 0.0F);
    for (const cv::Mat1f& plane : planes_) {
      const float *const a = plane[from], *const b = plane[to] + ahead;
      for (int x = 0; x < width; ++x) {
        difference[static_cast<std::size_t>(x)] += std::abs(a[x] - b[x]);
      }
    }
    const float steps = static_cast<float>(Edge::kSteps) / static_cast<float>(planes_.size());
    for (int x = 0; x < width; ++x) {
      if (is_parted(from, to, x, x + ahead)) continue;
      const float here = std::min(steps * difference[static_cast<std::size_t>(x)],
                                  static_cast<float>(kNotJoined - 1));
      weight[2 * x] = static_cast<std::uint16_t>(here);
    }
  }

 private:
  bool is_parted(int y, int v, int x, int u) const {
    // Comparisons with NaN are false: what has no disparity is joined.
    const bool leaps = std::abs(map_.disparity(y, x) - map_.disparity(v, u)) > jump_;
    return leaps || (!image_.valid.empty() && (image_.valid(y, x) == 0 || image_.valid(v, u) == 0));
  }

  const DisparityMap& map_;
  const Image& image_;
  const std::vector<cv::Mat1f>& planes_;
  float jump_;
};

/// Of pixel i the weight of the edge to the right at 2 * i, of that to the pixel below behind it.
std::vector<std::uint16_t> weights_of(const DisparityMap& map, const Image& image, double jump) {
  const std::vector<cv::Mat1f> smooth = smoothed(image);
  const RowOfEdges edges(map, image, smooth, static_cast<float>(jump));
  std::vector<std::uint16_t> weights(2 * map.disparity.total(), kNotJoined);
  const auto width = static_cast<std::size_t>(map.size().width);
  parallel_for(0, map.size().height, [&](int y) {
    std::uint16_t* const row = weights.data() + 2 * static_cast<std::size_t>(y) * width;
    edges.find(y, y, 1, row);
    if (y + 1 < map.size().height) edges.find(y, y + 1, 0, row + 1);
  });
  return weights;
}

}  // namespace

std::vector<Edge> sorted_edges(const DisparityMap& map, const Image& image, double jump) {
  const std::vector<std::uint16_t> weights = weights_of(map, image, jump);
  std::vector<std::uint32_t> next(kNotJoined + 2, 0);
  for (const std::uint16_t w : weights) ++next[w + std::size_t{1}];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Edge> sorted(next[kNotJoined]);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const std::uint16_t w = weights[i];
    if (w == kNotJoined) continue;
    sorted[next[w]++] = {static_cast<std::uint32_t>(i / 2), w, static_cast<std::uint16_t>(i % 2)};
  }
  return sorted;
}

}  // namespace xgm::plane_filling
