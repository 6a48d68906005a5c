// SPDX-License-Identifier: Apache-2.0
// Cost "birchfield_tomasi": a difference of grey levels that does not mind where pixels are
// sampled.
#include <algorithm>
#include <vector>

#include "plugins/cost/birchfield_tomasi/intensity_range.hpp"
#include "plugins/cost/shared/candidates.hpp"
#include "plugins/cost/shared/truncated_mean.hpp"
#include "xgm/plugin.hpp"

namespace {

using xgm::birchfield_tomasi::intensity_row;
using xgm::birchfield_tomasi::IntensityRow;

/// Distance of a grey level to the nearest level in [low, high].
float distance(float value, float low, float high) {
  return std::max({0.0F, value - high, low - value});
}

/// The publication's d(x_L, x_R): the pixel of one view against the range of the other, whichever
/// way is closer.
float dissimilarity(const IntensityRow& a, std::size_t i, const IntensityRow& b, std::size_t j) {
  return std::min(distance(a.value[i], b.low[j], b.high[j]),
                  distance(b.value[j], a.low[i], a.high[i]));
}

class BirchfieldTomasi final : public xgm::Cost {
 public:
  struct Parameters {
    int truncation = 64;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("truncation", p.truncation, "Largest cost; greater differences count as this one.")
        .unit("grey levels")
        .range(1, 254);
  }

  explicit BirchfieldTomasi(const Parameters& p) : truncation_(p.truncation) {}

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
    std::vector<IntensityRow> base, match;
    for (std::size_t c = 0; c < channels; ++c) {
      base.push_back(intensity_row(pair.base, c, y));
      match.push_back(mirrored(intensity_row(pair.match, c, y)));
    }
    xgm::cost::fill_row(costs, pair.match.valid, y, [&](const xgm::cost::Candidates& candidates) {
      xgm::cost::fill_truncated_mean(candidates, static_cast<int>(channels),
                                     static_cast<float>(truncation_), [&](int channel, int i) {
                                       const auto c = static_cast<std::size_t>(channel);
                                       return dissimilarity(base[c],
                                                            static_cast<std::size_t>(candidates.x),
                                                            match[c], static_cast<std::size_t>(i));
                                     });
    });
  }

  int truncation_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<BirchfieldTomasi>(
      "birchfield_tomasi",
      "Sampling-insensitive absolute difference, mean over channels, truncated.",
      "Birchfield & Tomasi, A pixel dissimilarity measure that is insensitive to image sampling, "
      "PAMI 1998");
}
