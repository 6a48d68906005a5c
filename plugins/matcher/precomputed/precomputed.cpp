// SPDX-License-Identifier: Apache-2.0
// A map that is there already, as a matcher.
#include <optional>

#include "xgm/exchange/answers.hpp"
#include "xgm/exchange/stored.hpp"
#include "xgm/plugin.hpp"

namespace {

class Precomputed final : public xgm::Matcher, public xgm::StatesNeeds {
 public:
  struct Parameters {
    std::string file;
    double divisor = 0;
    double reverse_divisor = 0;
    std::string confidence;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("file", p.file,
            "The disparities: PFM or another float image (px), or an image of whole numbers with "
            "divisor. {scene} stands for the name of the scene, {view} for left or right, {scale} "
            "for how many times smaller the level of a pyramid is; relative paths are from where "
            "the run was started.");
    set.add("divisor", p.divisor, "Numbers of the file divided by this are px; 0: they are px.")
        .range(-1e6, 1e6);
    set.add("reverse_divisor", p.reverse_divisor,
            "The same for the right view, whose disparities have the other sign here: negative, if "
            "its files hold positive numbers. 0: divisor.")
        .range(-1e6, 1e6);
    set.add(
        "confidence", p.confidence,
        "File with the confidence of each disparity, 0 to 1, with the same placeholders; empty: "
        "none.");
    set.rule({"file"}, "must name a file", [&p] { return !p.file.empty(); });
  }

  explicit Precomputed(Parameters parameters) : p_(std::move(parameters)) {}

  bool gives_confidence() const override { return !p_.confidence.empty(); }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    const xgm::ImagePair& pair = request.pair;
    xgm::DisparityMap map;
    cv::Mat1f sure;
    if (context.run().rehearsal) {
      map = xgm::exchange::rehearsed_map(request);
      if (gives_confidence()) sure = cv::Mat1f(pair.size(), 1.0F);
    } else {
      const std::string file = xgm::exchange::stored_file(p_.file, pair, context);
      map = xgm::exchange::to_matched(
          xgm::exchange::read_stored(file, divisor(pair.is_reverse), pair.size()), request, file);
      if (gives_confidence()) {
        sure = xgm::exchange::read_stored(xgm::exchange::stored_file(p_.confidence, pair, context),
                                          std::nullopt, pair.size());
      }
    }
    xgm::DisparityMap judged;
    judged.confidence = sure;
    map.inherit_confidence(judged);
    return {std::move(map), std::nullopt};
  }

  xgm::Needs needs(const xgm::Workload& load) const override {
    return {.working = 12 * load.pixels(), .updates = load.pixels()};
  }

 private:
  std::optional<double> divisor(bool is_reverse) const {
    const double own = is_reverse && p_.reverse_divisor != 0 ? p_.reverse_divisor : p_.divisor;
    return own == 0 ? std::nullopt : std::optional(own);
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Precomputed>(
      "precomputed",
      "Reads the map of each scene from a file, to be refined, filled, judged "
      "and compared like one of ours.");
}
