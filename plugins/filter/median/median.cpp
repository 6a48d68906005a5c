// SPDX-License-Identifier: Apache-2.0
// Median of the disparities around a pixel: removes outliers, keeps edges, fills nothing.
#include <algorithm>
#include <array>
#include <cmath>

#include "plugins/filter/median/three_by_three.hpp"
#include "xgm/plugin.hpp"

namespace {

constexpr int kMaxWindow = 31;

/// The disparities in a window, on the stack: the filter visits millions of windows.
class Samples {
 public:
  void clear() { size_ = 0; }
  void add_row(const float* begin, const float* end) {
    for (; begin != end; ++begin) {
      values_[size_] = *begin;
      size_ += std::isnan(*begin) ? 0U : 1U;  // no branch: the next sample overwrites a NaN
    }
  }
  /// The middle value, the lower one of two: always a disparity that occurs.
  float lower_median() {
    const auto middle = values_.begin() + static_cast<std::ptrdiff_t>((size_ - 1) / 2);
    std::nth_element(values_.begin(), middle, values_.begin() + static_cast<std::ptrdiff_t>(size_));
    return *middle;
  }

 private:
  std::array<float, std::size_t{kMaxWindow} * kMaxWindow + 1> values_;  // one to be overwritten
  std::size_t size_ = 0;
};

class Median final : public xgm::Filter {
 public:
  struct Parameters {
    int window = 3;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window,
            "Side of the square window, cut off at the image border. Only pixels that have a "
            "disparity count and change; of an even number the lower of the two middle ones is "
            "taken.")
        .unit("px")
        .range(3, kMaxWindow)
        .odd();
  }
  explicit Median(Parameters p) : radius_(p.window / 2) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    const cv::Size size = map.size();
    xgm::DisparityMap filtered;
    filtered.disparity.create(size);
    filtered.status.create(size);
    xgm::parallel_for(0, size.height, [&](int y) {
      std::copy_n(map.status[y], size.width, filtered.status[y]);
      if (radius_ == 1) {
        xgm::median::three_by_three(map.disparity, y, filtered.disparity[y]);
      } else {
        filter_row(map.disparity, y, filtered.disparity[y]);
      }
    });
    return filtered;
  }

 private:
  void filter_row(const cv::Mat1f& disparity, int y, float* result) const {
    Samples samples;
    for (int x = 0; x < disparity.cols; ++x) {
      result[x] = disparity(y, x);
      if (std::isnan(result[x])) continue;
      collect(disparity, y, x, samples);
      result[x] = samples.lower_median();
    }
  }
  void collect(const cv::Mat1f& disparity, int y, int x, Samples& samples) const {
    const int left = std::max(0, x - radius_), right = std::min(disparity.cols, x + radius_ + 1);
    const int bottom = std::min(disparity.rows, y + radius_ + 1);
    samples.clear();
    for (int row = std::max(0, y - radius_); row < bottom; ++row) {
      samples.add_row(disparity[row] + left, disparity[row] + right);
    }
  }

  int radius_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Median>("median",
                       "Replaces each disparity by the median of the disparities in a window.",
                       "Patil et al., A comparative evaluation of SGM variants for dense stereo "
                       "matching, section 4.1 (window 3)");
}
