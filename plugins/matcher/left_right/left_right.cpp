// SPDX-License-Identifier: Apache-2.0
// Matches both views and keeps what agrees.
#include "xgm/plugin.hpp"

namespace {

/// The inner matcher runs on the pair and on the swapped pair; the consistency stage compares the
/// two maps (the paper's Eq. 5).
class LeftRight final : public xgm::Matcher {
 public:
  struct Parameters {
    xgm::Slot<xgm::Matcher> matcher;
    xgm::Slot<xgm::Consistency> consistency;
    xgm::Slot<xgm::Confidence> confidence;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("matcher", p.matcher, "Matches one view; is run once for each of the two.");
    set.add("consistency", p.consistency, "Decides which disparities of the two maps agree.")
        .default_stage("lrrl");
    set.add(
           "confidence", p.confidence,
           "How sure the disparities that agree are, in place of what the matcher said of them, if "
           "asked for.")
        .optional();
    set.rule({"matcher"},
             "must be one that matches a single view; left_right inside left_right would match "
             "four times",
             [&p] { return !p.matcher->gives_reverse_map(); });
    set.rule({"confidence"},
             "needs the sums that disparities are selected by, which are gone; give it to the "
             "matcher inside, and here 'so_far'",
             [&p] { return !p.confidence || !p.confidence->needs_sums(); });
    set.rule({"confidence", "matcher"},
             "needs a confidence that maps have already; give the matcher inside one", [&p] {
               return !p.confidence || !p.confidence->needs_confidence() ||
                      p.matcher->gives_confidence();
             });
  }

  explicit LeftRight(Parameters parameters) : stages_(std::move(parameters)) {}

  bool accepts_range_maps() const override { return stages_.matcher->accepts_range_maps(); }
  bool gives_reverse_map() const override { return true; }
  bool gives_confidence() const override {
    return stages_.confidence || stages_.matcher->gives_confidence();
  }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    const xgm::MatchRequest forward{request.pair, request.range, std::nullopt};
    const xgm::MatchRequest reverse{
        request.pair.swapped(),
        request.reverse_range ? *request.reverse_range : request.range.reversed(), std::nullopt};
    xgm::MatchResult both;
    both.forward = stages_.matcher(context.part(0, 0.49).scope("forward"), forward).forward;
    both.reverse = stages_.matcher(context.part(0.49, 0.98).scope("reverse"), reverse).forward;
    both = stages_.consistency(context.part(0.98, 0.99), both);
    if (stages_.confidence) judge(both, forward.pair, reverse.pair, context.part(0.99, 1));
    return both;
  }

 private:
  void judge(xgm::MatchResult& both, const xgm::ImagePair& pair, const xgm::ImagePair& swapped,
             const xgm::Context& context) const {
    xgm::DisparityMap& other = *both.reverse;
    cv::Mat1f sure =
        stages_.confidence(context.part(0, 0.5).scope("forward"),
                           xgm::Evidence{.pair = pair, .map = both.forward, .other = &other});
    other.confidence =
        stages_.confidence(context.part(0.5, 1).other_view(),
                           xgm::Evidence{.pair = swapped, .map = other, .other = &both.forward});
    both.forward.confidence = std::move(sure);  // not before the other view has been judged
  }

  Parameters stages_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<LeftRight>(
      "left_right",
      "Runs a matcher from left to right and from right to left and keeps the disparities that "
      "agree.",
      "H. Hirschmueller: Stereo processing by semiglobal matching and mutual information, IEEE "
      "TPAMI 30(2), 2008.");
}
