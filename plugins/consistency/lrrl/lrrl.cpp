// SPDX-License-Identifier: Apache-2.0
// Left-right-right-left check (the paper's Eq. 5): a disparity stays if the pixel it points at
// points back. What fails is told apart as occluded or mismatched.
#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/consistency/lrrl/sight_lines.hpp"
#include "xgm/plugin.hpp"

namespace {

using xgm::DisparityMap;
using xgm::Status;
using xgm::lrrl::SightLines;

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
    const cv::Size size = result.forward.size();
    xgm::MatchResult checked{unset(size), unset(size)};
    constexpr int kBand = 16;  // rows that share their memory
    xgm::parallel_for(0, (size.height + kBand - 1) / kBand, [&](int band) {
      SightLines forward(size.width), reverse(size.width);
      for (int y = band * kBand; y < std::min(size.height, (band + 1) * kBand); ++y) {
        forward.load(result.forward.disparity[y], p_.threshold);
        reverse.load(result.reverse->disparity[y], p_.threshold);
        check(forward, reverse, result.forward.status[y], y, checked.forward);
        check(reverse, forward, result.reverse->status[y], y, *checked.reverse);
      }
    });
    return checked;
  }

 private:
  /// A map of which every pixel will be set.
  static DisparityMap unset(cv::Size size) {
    DisparityMap map;
    map.disparity.create(size);
    map.status.create(size);
    return map;
  }
  /// Checks a row against the other view's, which is as the matcher left it: the formula
  /// x_other = x - d holds for both views, so one function serves both.
  void check(const SightLines& row, const SightLines& other, const std::uint8_t* states, int y,
             DisparityMap& checked) const {
    float* const disparities = checked.disparity[y];
    std::uint8_t* const reasons = checked.status[y];
    for (int x = 0; x < row.width(); ++x) {
      const float disparity = row.disparity(x);
      // NaN, of a pixel without a disparity or for a target outside, compares false.
      const double round_trip = static_cast<double>(disparity) + other.disparity(row.target(x));
      const bool agrees = std::abs(round_trip) <= p_.threshold;
      const bool stays = agrees | !has_disparity(static_cast<Status>(states[x]));
      const Status reason = other.meet(x) ? Status::mismatched : Status::occluded;
      disparities[x] = stays ? disparity : std::numeric_limits<float>::quiet_NaN();
      reasons[x] = stays ? states[x] : static_cast<std::uint8_t>(reason);
    }
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
