// SPDX-License-Identifier: Apache-2.0
// A matcher and what is done to its maps.
#include "xgm/plugin.hpp"

namespace {

/// Filters inside a pipeline's matcher see one view before the check of both; those of its
/// postprocess see the final map. This is for between: holes of one of several matchers filled
/// before they are compared, for example.
class Filtered final : public xgm::Matcher {
 public:
  struct Parameters {
    xgm::Slot<xgm::Matcher> matcher;
    xgm::SlotList<xgm::Filter> filters;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("matcher", p.matcher, "Matches.");
    set.add("filters", p.filters,
            "What is done to its map afterwards, in this order; to the reverse map, too, if there "
            "is one.");
    set.rule(
        {"filters", "matcher"},
        "holds one that needs a confidence, which the maps do not have; give the matcher one "
        "(confidence of semi_global or left_right)",
        [&p] { return p.matcher->gives_confidence() || !xgm::any_needs_confidence(p.filters); });
  }

  explicit Filtered(Parameters parameters) : stages_(std::move(parameters)) {}

  bool accepts_range_maps() const override { return stages_.matcher->accepts_range_maps(); }
  int coarsest_scale() const override { return stages_.matcher->coarsest_scale(); }
  bool gives_reverse_map() const override { return stages_.matcher->gives_reverse_map(); }
  bool gives_confidence() const override { return stages_.matcher->gives_confidence(); }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    xgm::MatchResult result = stages_.matcher(context.part(0, 0.96), request);
    result.forward = filtered(result.forward, request.pair, context.part(0.96, 0.98));
    if (result.reverse) {
      result.reverse =
          filtered(*result.reverse, request.pair.swapped(), context.part(0.98, 1).other_view());
    }
    return result;
  }

 private:
  xgm::DisparityMap filtered(xgm::DisparityMap map, const xgm::ImagePair& pair,
                             const xgm::Context& context) const {
    for (const auto& filter : stages_.filters) map = filter(context, map, pair);
    return map;
  }

  Parameters stages_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Filtered>("filtered", "Runs a matcher, then filters on its maps.");
}
