// SPDX-License-Identifier: Apache-2.0
// Cost "absolute_difference": mean over the channels of |I_b(p) - I_m(p - d)|, truncated.
#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/cost/shared/candidates.hpp"
#include "plugins/cost/shared/truncated_mean.hpp"
#include "xgm/plugin.hpp"

namespace {

class AbsoluteDifference final : public xgm::Cost {
 public:
  struct Parameters {
    int truncation = 64;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("truncation", p.truncation, "Largest cost; greater differences count as this one.")
        .unit("grey levels")
        .range(1, 254);
  }

  explicit AbsoluteDifference(const Parameters& p) : truncation_(p.truncation) {}

  xgm::CostVolume run(const xgm::ImagePair& images, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    const xgm::ImagePair pair = xgm::cost::comparable(images);
    xgm::CostVolume costs(shape, truncation_);
    xgm::parallel_for(0, shape->height(), [&](int y) { fill_row(pair, y, costs); });
    return costs;
  }

 private:
  void fill_row(const xgm::ImagePair& pair, int y, xgm::CostVolume& costs) const {
    const auto channels = pair.base.planes.size();
    std::vector<std::vector<float>> match(channels);
    for (std::size_t c = 0; c < channels; ++c) {
      const float* const row = pair.match.planes[c][y];
      match[c].assign(row, row + pair.size().width);
      std::reverse(match[c].begin(), match[c].end());
    }
    xgm::cost::fill_row(costs, pair.match.valid, y, [&](const xgm::cost::Candidates& candidates) {
      xgm::cost::fill_truncated_mean(candidates, static_cast<int>(channels),
                                     static_cast<float>(truncation_), [&](int channel, int i) {
                                       const auto c = static_cast<std::size_t>(channel);
                                       return std::abs(pair.base.planes[c](y, candidates.x) -
                                                       match[c][static_cast<std::size_t>(i)]);
                                     });
    });
  }

  int truncation_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<AbsoluteDifference>(
      "absolute_difference", "Absolute difference of grey levels, mean over channels, truncated.",
      "Scharstein & Szeliski, A taxonomy and evaluation of dense two-frame stereo correspondence "
      "algorithms, IJCV 2002");
}
