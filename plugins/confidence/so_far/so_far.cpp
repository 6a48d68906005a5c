// SPDX-License-Identifier: Apache-2.0
// The confidence that a map has already, so that others can be added to it.
#include "xgm/plugin.hpp"

namespace {

class SoFar final : public xgm::Confidence {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit SoFar(Parameters) {}

  bool needs_confidence() const override { return true; }

  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context&) const override {
    return evidence.map.confidence.clone();
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<SoFar>("so_far",
                      "What the map has already: in left_right, the confidence that the matcher "
                      "inside gave it. For use in weighted.");
}
