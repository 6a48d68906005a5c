// SPDX-License-Identifier: Apache-2.0
// Left-right-right-left check (the paper's Eq. 5): a disparity stays if the pixel it points at
// points back. What fails is told apart as occluded or mismatched.
#include <algorithm>

#include "plugins/consistency/lrrl/sight_lines.hpp"
#include "xgm/plugin.hpp"

namespace {

using xgm::DisparityMap;
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
        const auto check = [&](const SightLines& row, const SightLines& other,
                               const DisparityMap& map, DisparityMap& to) {
          xgm::lrrl::check(row, other, p_.threshold, map.status[y], to.disparity[y], to.status[y]);
        };
        forward.load(result.forward.disparity[y], p_.threshold);
        reverse.load(result.reverse->disparity[y], p_.threshold);
        check(forward, reverse, result.forward, checked.forward);
        check(reverse, forward, *result.reverse, *checked.reverse);
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
