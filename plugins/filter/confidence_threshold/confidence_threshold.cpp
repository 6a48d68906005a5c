// SPDX-License-Identifier: Apache-2.0
// Takes away disparities that are not sure enough.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "xgm/plugin.hpp"

namespace {

class ConfidenceThreshold final : public xgm::Filter {
 public:
  struct Parameters {
    double min = 0;
    double keep = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("min", p.min, "Disparities of a lower confidence are taken away.").range(0, 1);
    set.add("keep", p.keep,
            "Share of the pixels that have a disparity to keep: the surest ones. Those as sure as "
            "the last of them stay, too.")
        .range(0, 1);
    set.rule({"min", "keep"}, "is 0 and keep is 1, which keeps everything; give one of them",
             [&p] { return p.min > 0 || p.keep < 1; });
  }
  explicit ConfidenceThreshold(Parameters p) : p_(p) {}

  bool needs_confidence() const override { return true; }

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    if (map.confidence.size() != map.size()) {
      throw xgm::Error("the map has no confidence; give its matcher one");
    }
    const float lowest = std::max(static_cast<float>(p_.min), lowest_kept(map));
    xgm::DisparityMap kept = map.clone();
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (!map.has_disparity(y, x) || sureness(map, y, x) >= lowest) continue;
        kept.invalidate(y, x, xgm::Status::ambiguous);
      }
    });
    return kept;
  }

 private:
  /// What has no confidence, because it was filled or nothing could be told, is the least sure.
  static float sureness(const xgm::DisparityMap& map, int y, int x) {
    const float sure = map.confidence(y, x);
    return std::isnan(sure) ? -1 : sure;
  }

  float lowest_kept(const xgm::DisparityMap& map) const {
    std::vector<float> sure;
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (map.has_disparity(y, x)) sure.push_back(sureness(map, y, x));
      }
    }
    const auto count = std::ceil(p_.keep * static_cast<double>(sure.size()));
    if (count < 1) return std::numeric_limits<float>::infinity();  // nothing is kept
    const auto last = sure.begin() + static_cast<std::ptrdiff_t>(count) - 1;
    std::nth_element(sure.begin(), last, sure.end(), std::greater<>());
    return *last;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<ConfidenceThreshold>(
      "confidence_threshold",
      "Takes away disparities of low confidence: they become ambiguous. What was filled has no "
      "confidence and goes first.",
      "X. Hu, P. Mordohai: A quantitative evaluation of confidence measures for stereo vision, "
      "IEEE "
      "TPAMI 34(11), 2012, sparsification.");
}
