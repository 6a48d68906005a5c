// SPDX-License-Identifier: Apache-2.0
// How much lower the winner's sum is than that of its best rival, in units of the cost.
#include "plugins/confidence/winning_sums/winning_sums.hpp"

namespace {

using xgm::winning_sums::Sums;

class MaximumMargin final : public xgm::Confidence {
 public:
  struct Parameters {
    double half = 100;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("half", p.half, "A lead of this size has confidence 0.5: lead / (lead + half).")
        .unit("cost, sum of all paths")
        .range(1e-3, 1e6);
  }
  explicit MaximumMargin(Parameters p) : half_(p.half) {}

  bool needs_sums() const override { return true; }

  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context&) const override {
    const double half = half_ * (1 << evidence.sums->fraction_bits);
    return xgm::winning_sums::of_winners(evidence, [half](Sums sums, int winner) {
      const auto rival = xgm::winning_sums::runner_up(sums, winner);
      if (!rival) return 1.0F;  // nothing to be mixed up with
      const int lead = *rival - sums[static_cast<std::size_t>(winner)];
      return lead > 0 ? xgm::winning_sums::saturated(lead, half) : 0.0F;
    });
  }

 private:
  double half_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MaximumMargin>(
      "maximum_margin", "The lead of the lowest sum over the lowest one that is not beside it.",
      "X. Hu, P. Mordohai: A quantitative evaluation of confidence measures for stereo vision, "
      "IEEE "
      "TPAMI 34(11), 2012, maximum margin naive.");
}
