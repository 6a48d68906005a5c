// SPDX-License-Identifier: Apache-2.0
// Median of the disparities around a pixel: removes outliers, keeps edges, fills nothing.
#include <algorithm>
#include <array>
#include <cmath>

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
    if (size_ == 9) return median_of_nine();
    const auto middle = values_.begin() + static_cast<std::ptrdiff_t>((size_ - 1) / 2);
    std::nth_element(values_.begin(), middle, values_.begin() + static_cast<std::ptrdiff_t>(size_));
    return *middle;
  }

 private:
  /// The common case, a whole 3x3 window, without branches: sorts three columns; the median of the
  /// nine is the median of the largest low, the middle middle and the smallest high value.
  float median_of_nine() const {
    std::array<float, 3> low{}, middle{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
      const float a = values_[i], b = values_[i + 3], c = values_[i + 6];
      low[i] = std::min(std::min(a, b), c);
      high[i] = std::max(std::max(a, b), c);
      middle[i] = median_of_three(a, b, c);
    }
    return median_of_three(std::max(std::max(low[0], low[1]), low[2]),
                           median_of_three(middle[0], middle[1], middle[2]),
                           std::min(std::min(high[0], high[1]), high[2]));
  }
  static float median_of_three(float a, float b, float c) {
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
  }

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
    xgm::DisparityMap filtered = map.clone();
    xgm::parallel_for(0, map.size().height, [&](int y) {
      Samples samples;
      for (int x = 0; x < map.size().width; ++x) {
        if (!map.valid(y, x)) continue;
        collect(map.disparity, y, x, samples);
        filtered.disparity(y, x) = samples.lower_median();
      }
    });
    return filtered;
  }

 private:
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
