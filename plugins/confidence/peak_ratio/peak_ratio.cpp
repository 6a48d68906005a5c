// SPDX-License-Identifier: Apache-2.0
// How much lower the winner's sum is than that of its best rival, as a share.
#include "plugins/confidence/winning_sums/winning_sums.hpp"

namespace {

using xgm::winning_sums::Sums;

/// Hu and Mordohai's c2 / c1 grows without bound; (c2 - c1) / c2 has the same order, from 0 to 1.
/// Without a rival there is nothing to be mixed up with: 1.
class PeakRatio final : public xgm::Confidence {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit PeakRatio(Parameters) {}

  bool needs_sums() const override { return true; }

  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context&) const override {
    return xgm::winning_sums::of_winners(evidence, [](Sums sums, int winner) {
      const auto rival = xgm::winning_sums::runner_up(sums, winner);
      if (!rival) return 1.0F;
      const int lead = *rival - sums[static_cast<std::size_t>(winner)];
      return lead > 0 ? static_cast<float>(lead) / static_cast<float>(*rival) : 0.0F;
    });
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<PeakRatio>(
      "peak_ratio",
      "The lead of the lowest sum over the lowest one that is not beside it, as a share of that.",
      "X. Hu, P. Mordohai: A quantitative evaluation of confidence measures for stereo vision, "
      "IEEE "
      "TPAMI 34(11), 2012, peak ratio naive.");
}
