// SPDX-License-Identifier: Apache-2.0
// Left-right-right-left check (the paper's Eq. 5): a disparity stays if the pixel it points at
// points back. What fails is told apart as occluded or mismatched.
#include <cmath>

#include "plugins/consistency/lrrl/pointed_at.hpp"
#include "xgm/plugin.hpp"

namespace {

using xgm::DisparityMap;
using xgm::Status;

class Lrrl final : public xgm::Consistency {
 public:
  struct Parameters {
    double threshold = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("threshold", p.threshold,
            "Largest difference between a disparity and that of the pixel it points at. A pixel "
            "that fails is mismatched if some disparity of the other view points at it, else "
            "occluded.")
        .unit("px")
        .range(0, 1000);
  }
  explicit Lrrl(Parameters p) : p_(p) {}

  xgm::MatchResult run(const xgm::MatchResult& result, const xgm::Context&) const override {
    if (!result.reverse) {
      throw xgm::Error("there is no reverse map to check against; use a matcher that makes one");
    }
    return {checked(result.forward, *result.reverse), checked(*result.reverse, result.forward)};
  }

 private:
  /// `map` checked against `other`, which is as the matcher left it: the formula x_other = x - d
  /// holds for both views, so one function serves both.
  DisparityMap checked(const DisparityMap& map, const DisparityMap& other) const {
    const cv::Size size = map.size();
    DisparityMap result;
    result.disparity.create(size);
    result.status.create(size);
    cv::Mat1b marks(size.height, size.width + 2);
    xgm::parallel_for(0, size.height, [&](int y) {
      xgm::lrrl::mark_pointed_at(other.disparity, y, p_.threshold, marks[y]);
      check_row(map, other, y, marks[y] + 1, result);
    });
    return result;
  }
  void check_row(const DisparityMap& map, const DisparityMap& other, int y,
                 const std::uint8_t* pointed, DisparityMap& result) const {
    const float* const disparities = map.disparity[y];
    const std::uint8_t* const states = map.status[y];
    for (int x = 0; x < map.size().width; ++x) {
      const auto status = static_cast<Status>(states[x]);
      if (!has_disparity(status) ||
          agrees(x, disparities[x], other.disparity[y], other.size().width)) {
        result.set(y, x, disparities[x], status);
      } else {
        result.invalidate(y, x, pointed[x] != 0 ? Status::mismatched : Status::occluded);
      }
    }
  }
  /// False also where the disparity points outside the other view, or at a pixel without one.
  bool agrees(int x, float disparity, const float* other, int width) const {
    const int q = xgm::lrrl::target(x, disparity, width);
    if (q < 0 || q >= width) return false;
    const double back = other[q];  // NaN compares false
    return std::abs(static_cast<double>(disparity) + back) <= p_.threshold;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Lrrl>("lrrl",
                     "Keeps disparities of both views that agree; the rest becomes occluded or "
                     "mismatched.",
                     "Patil et al., A comparative evaluation of SGM variants for dense stereo "
                     "matching, Eq. 5; classes: Hirschmueller, Stereo processing by semiglobal "
                     "matching and mutual information, PAMI 2008");
}
