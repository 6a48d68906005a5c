// SPDX-License-Identifier: Apache-2.0
// Penalty "gradient": P2 falls with the change of intensity along the path.
#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/penalty/step_penalties/describe.hpp"
#include "plugins/penalty/step_penalties/grey_view.hpp"
#include "xgm/plugin.hpp"

namespace {

/// The class of a base pixel is |I(p) - I(p - r)| in whole grey levels, 255 at most.
class GradientField final : public xgm::PenaltyField {
 public:
  GradientField(const xgm::Image& base, xgm::penalty::Weights weights) : base_(base) {
    table_.base_classes = 256;
    table_.entries.clear();
    for (int gradient = 0; gradient < 256; ++gradient) {
      // Less than one level counts as one: P2 is never raised.
      const auto adapted = static_cast<int>(std::lround(
          static_cast<double>(weights.p2) / static_cast<double>(std::max(gradient, 1))));
      table_.entries.push_back({weights.p1, std::max(weights.p1, adapted)});
    }
  }

  xgm::PenaltyTable table(xgm::Direction) const override { return table_; }

  void classify(xgm::Direction r, int y, std::span<std::uint8_t> base,
                std::span<std::uint8_t> match) const override {
    std::vector<float> gradients(base.size());
    base_.differences(r, y, gradients);
    std::transform(gradients.begin(), gradients.end(), base.begin(), [](float gradient) {
      return static_cast<std::uint8_t>(std::min(gradient, 255.0F) + 0.5F);
    });
    std::fill(match.begin(), match.end(), std::uint8_t{0});
  }

 private:
  xgm::penalty::GreyView base_;
  xgm::PenaltyTable table_;
};

class Gradient final : public xgm::Penalty {
 public:
  using Parameters = xgm::penalty::Weights;

  static void describe(Parameters& p, xgm::ParameterSet& set) { xgm::penalty::describe(p, set); }

  explicit Gradient(const Parameters& p) : weights_(p) {}

  std::unique_ptr<const xgm::PenaltyField> run(const xgm::ImagePair& pair,
                                               const xgm::Context&) const override {
    return std::make_unique<GradientField>(pair.base, weights_);
  }

 private:
  xgm::penalty::Weights weights_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Gradient>("gradient",
                         "P2 is divided by the change of intensity along the path, down to P1.",
                         "Hirschmueller, Stereo processing by semiglobal matching and mutual "
                         "information, PAMI 2008");
}
