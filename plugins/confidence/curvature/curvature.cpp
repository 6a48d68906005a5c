// SPDX-License-Identifier: Apache-2.0
// How sharp the minimum of the sums is.
#include "plugins/confidence/winning_sums/winning_sums.hpp"

namespace {

using xgm::winning_sums::kNoMatch;
using xgm::winning_sums::Sums;

/// c(d - 1) - 2 c(d) + c(d + 1). At an end of the range, and beside what cannot match, the one
/// neighbour that is there stands for both, as Hu and Mordohai have it; without any, nothing can be
/// told.
class Curvature final : public xgm::Confidence {
 public:
  struct Parameters {
    double half = 50;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("half", p.half,
            "A curvature of this size has confidence 0.5: curvature / (curvature + half).")
        .unit("cost, sum of all paths")
        .range(1e-3, 1e6);
  }
  explicit Curvature(Parameters p) : half_(p.half) {}

  bool needs_sums() const override { return true; }

  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context&) const override {
    const double half = half_ * (1 << evidence.sums->fraction_bits);
    return xgm::winning_sums::of_winners(evidence, [half](Sums sums, int winner) {
      const int before = sum_at(sums, winner - 1), after = sum_at(sums, winner + 1);
      if (before == kNoMatch && after == kNoMatch) return std::numeric_limits<float>::quiet_NaN();
      const int sides =
          (before == kNoMatch ? after : before) + (after == kNoMatch ? before : after);
      const int curvature = sides - 2 * sum_at(sums, winner);
      return curvature > 0 ? xgm::winning_sums::saturated(curvature, half) : 0.0F;
    });
  }

 private:
  static int sum_at(Sums sums, int i) {
    return i >= 0 && i < static_cast<int>(sums.size()) ? sums[static_cast<std::size_t>(i)]
                                                       : kNoMatch;
  }

  double half_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Curvature>("curvature", "The second difference of the sums at their minimum.",
                          "X. Hu, P. Mordohai: A quantitative evaluation of confidence measures "
                          "for stereo vision, IEEE "
                          "TPAMI 34(11), 2012, curvature.");
}
