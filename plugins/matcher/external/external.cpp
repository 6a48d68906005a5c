// SPDX-License-Identifier: Apache-2.0
// A program of the user's as a matcher: a neural network, or any other one.
#include "xgm/exchange/answers.hpp"
#include "xgm/exchange/request.hpp"
#include "xgm/plugin.hpp"

namespace {

class External final : public xgm::Matcher, public xgm::StatesNeeds {
 public:
  struct Parameters {
    xgm::exchange::Program program;
    xgm::exchange::ImageFiles images = xgm::exchange::ImageFiles::png;
    bool range_maps = false;
    bool confidence = false;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    xgm::exchange::declare(p.program, set);
    xgm::exchange::declare(p.images, set);
    set.add("range_maps", p.range_maps,
            "Whether the program heeds a range per pixel; a pyramid needs that.");
    set.add("confidence", p.confidence, "Whether it writes a confidence beside its disparities.");
  }

  explicit External(Parameters parameters) : p_(std::move(parameters)) {}

  bool accepts_range_maps() const override { return p_.range_maps; }
  bool gives_confidence() const override { return p_.confidence; }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    if (!request.range.is_uniform() && !p_.range_maps) {
      throw xgm::Error("the search range is a map, and the program takes one for the whole image");
    }
    if (context.run().rehearsal || !xgm::exchange::can_match(request)) {
      return {judged(xgm::exchange::rehearsed_map(request)), std::nullopt};
    }
    xgm::exchange::Request question("matcher", request.pair, p_.images, context);
    question.add(request.range);
    question.run(p_.program);
    xgm::DisparityMap map =
        xgm::exchange::to_matched(question.disparities(), request, "what the program wrote");
    if (!p_.confidence) return {std::move(map), std::nullopt};
    xgm::DisparityMap sure;
    sure.confidence = question.confidence();
    if (sure.confidence.empty()) {
      throw xgm::Error(
          "the program wrote neither confidence.npy nor confidence.pfm; let it, or "
          "set confidence to false");
    }
    map.inherit_confidence(sure);
    return {std::move(map), std::nullopt};
  }

  /// Of this process, for what it hands over; the program has memory of its own.
  xgm::Needs needs(const xgm::Workload& load) const override {
    return {.working = 2 * load.image_bytes() + 12 * load.pixels(), .updates = load.cells()};
  }

 private:
  /// With a confidence like that of a program's answer, so that memory is planned for it.
  xgm::DisparityMap judged(xgm::DisparityMap map) const {
    if (p_.confidence) map.confidence = cv::Mat1f(map.size(), 1.0F);
    return map;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<External>("external",
                         "Runs a program of yours that matches; pairs and ranges are handed over "
                         "as files, see docs/external.md.");
}
