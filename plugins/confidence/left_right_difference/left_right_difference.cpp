// SPDX-License-Identifier: Apache-2.0
// How well the disparity of a pixel agrees with that of the pixel of the other view it points at.
#include <cmath>
#include <limits>

#include "xgm/plugin.hpp"

namespace {

class LeftRightDifference final : public xgm::Confidence {
 public:
  struct Parameters {
    double half = 0.5;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("half", p.half,
            "A difference of this size has confidence 0.5: half / (half + difference).")
        .unit("px")
        .range(1e-3, 1000);
  }
  explicit LeftRightDifference(Parameters p) : half_(p.half) {}

  bool needs_other_view() const override { return true; }

  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context&) const override {
    const xgm::DisparityMap& map = evidence.map;
    cv::Mat1f confidence(map.size(), std::numeric_limits<float>::quiet_NaN());
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (map.at(y, x) != xgm::Status::matched) continue;
        confidence(y, x) = agreement(x, map.disparity(y, x), *evidence.other, y);
      }
    });
    return confidence;
  }

 private:
  /// 0 if the disparity points outside, or at a pixel that has none. Half pixels go to the right,
  /// as in the consistency check.
  float agreement(int x, float disparity, const xgm::DisparityMap& other, int y) const {
    const double seen = std::floor(x - static_cast<double>(disparity) + 0.5);
    if (!(seen >= 0 && seen < other.size().width)) return 0;
    const int there = static_cast<int>(seen);
    if (!other.has_disparity(y, there)) return 0;
    const double round_trip = static_cast<double>(disparity) + other.disparity(y, there);
    return static_cast<float>(half_ / (half_ + std::abs(round_trip)));
  }

  double half_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<LeftRightDifference>(
      "left_right_difference",
      "The difference between a disparity and that of the pixel of the other view it points at.",
      "X. Hu, P. Mordohai: A quantitative evaluation of confidence measures for stereo vision, "
      "IEEE "
      "TPAMI 34(11), 2012, left right consistency.");
}
