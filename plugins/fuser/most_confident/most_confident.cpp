// SPDX-License-Identifier: Apache-2.0
// The candidate that is surest of itself.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plugins/fuser/candidate_choice/choice.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace fuser = xgm::fuser;

class MostConfident final : public xgm::Fuser {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit MostConfident(Parameters) {}

  xgm::DisparityMap run(const xgm::Candidates& candidates, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    require_confidences(candidates);
    cv::Mat1f confidence(candidates.maps.front().size(), std::numeric_limits<float>::quiet_NaN());
    xgm::DisparityMap map = fuser::chosen(candidates, [&](int y, int x) {
      const int surest = most_confident(candidates.maps, y, x);
      if (surest == fuser::kNone) return surest;
      confidence(y, x) = candidates.maps[static_cast<std::size_t>(surest)].confidence(y, x);
      return surest;
    });
    map.confidence = confidence;
    return map;
  }

 private:
  /// The first one of the highest confidence. One that is not finite, as of pixels that were
  /// filled, is below all others.
  static int most_confident(const std::vector<xgm::DisparityMap>& maps, int y, int x) {
    int surest = fuser::kNone;
    float highest = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
      if (!maps[i].has_disparity(y, x)) continue;
      const float told = maps[i].confidence(y, x);
      const float confidence = std::isfinite(told) ? told : -1;
      if (surest != fuser::kNone && confidence <= highest) continue;
      surest = static_cast<int>(i);
      highest = confidence;
    }
    return surest;
  }

  static void require_confidences(const xgm::Candidates& candidates) {
    for (std::size_t i = 0; i < candidates.maps.size(); ++i) {
      if (candidates.maps[i].confidence.size() == candidates.maps[i].size()) continue;
      throw xgm::Error("the map of matchers[" + std::to_string(i) +
                       "] has no confidence; give that matcher a stage of kind confidence, or use "
                       "another fuser");
    }
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MostConfident>("most_confident",
                              "The disparity of the matcher that is surest of it; all need a "
                              "confidence.");
}
