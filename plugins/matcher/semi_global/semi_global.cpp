// SPDX-License-Identifier: Apache-2.0
// The chain inside a single-scale matcher: cost, aggregation, selection, refinement, filters.
#include "plugins/matcher/semi_global/matchable.hpp"
#include "xgm/plugin.hpp"

namespace {

/// Matches one direction at one scale (the paper's Algorithms 1 and 2, one half of each).
/// Range maps are cut to what lies inside the match image: it changes no result, and in a pyramid
/// the pixels that search everything sit mostly at the border where little of it can match (on
/// Middlebury's Motorcycle it saves 8 to 12 % of the cells). A uniform range stays as it is, so
/// that aggregations see a dense volume.
class SemiGlobal final : public xgm::Matcher {
 public:
  struct Parameters {
    xgm::Slot<xgm::Cost> cost;
    xgm::Slot<xgm::Penalty> penalty;
    xgm::Slot<xgm::Aggregation> aggregation;
    xgm::Slot<xgm::Selection> selection;
    xgm::Slot<xgm::Refinement> refinement;
    xgm::Slot<xgm::Confidence> confidence;
    xgm::SlotList<xgm::Filter> filters;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("cost", p.cost, "How unlike a pixel and its candidate are.");
    set.add("penalty", p.penalty, "What a step of the disparity costs between neighbours.");
    set.add("aggregation", p.aggregation, "How costs are summed along paths through the image.");
    set.add("selection", p.selection, "How each pixel's disparity is chosen from the sums.")
        .default_stage("wta");
    set.add("refinement", p.refinement, "How disparities are refined below one pixel, if at all.")
        .optional();
    set.add("confidence", p.confidence, "How sure each disparity is, by the sums, if asked for.")
        .optional();
    set.add("filters", p.filters, "What is done to the map afterwards, in this order.");
    add_rules(p, set);
  }

  explicit SemiGlobal(Parameters parameters) : stages_(std::move(parameters)) {}

  bool accepts_range_maps() const override { return stages_.aggregation->accepts_ragged_volumes(); }
  bool gives_confidence() const override { return static_cast<bool>(stages_.confidence); }

  xgm::MatchResult run(const xgm::MatchRequest& request,
                       const xgm::Context& context) const override {
    xgm::DisparityMap map = select(request, context.part(0, 0.97));
    double share = 0.97;
    const double step = stages_.filters.empty() ? 0 : 0.03 / double(stages_.filters.size());
    for (const auto& filter : stages_.filters) {
      map = filter(context.part(share, share + step), map, request.pair);
      share += step;
    }
    mark_masked(map, request.pair.base);  // again, should a filter have filled them
    return {std::move(map), std::nullopt};
  }

 private:
  static void add_rules(Parameters& p, xgm::ParameterSet& set) {
    set.rule({"confidence"},
             "needs the map of the other view, which is not there yet; give it to left_right",
             [&p] { return !p.confidence || !p.confidence->needs_other_view(); });
    set.rule({"confidence"},
             "needs a confidence that the map has already, and here it has none; give it to "
             "left_right around this matcher",
             [&p] { return !p.confidence || !p.confidence->needs_confidence(); });
    set.rule({"filters", "confidence"}, "hold one that needs a confidence; give 'confidence', too",
             [&p] { return p.confidence || !xgm::any_needs_confidence(p.filters); });
  }

  xgm::DisparityMap select(const xgm::MatchRequest& request, const xgm::Context& context) const {
    const xgm::AggregatedVolume sums = aggregate(request, context.part(0, 0.95));
    xgm::DisparityMap map = stages_.selection(context.part(0.95, 0.97), sums);
    mark_masked(map, request.pair.base);
    if (stages_.refinement) map = stages_.refinement(context.part(0.97, 0.98), map, sums);
    if (stages_.confidence) {
      const xgm::Evidence evidence{.pair = request.pair, .map = map, .sums = &sums};
      map.confidence = stages_.confidence(context.part(0.98, 1), evidence);
    }
    return map;
  }

  /// A function of its own so that costs and penalties are gone before the sums are read.
  xgm::AggregatedVolume aggregate(const xgm::MatchRequest& request,
                                  const xgm::Context& context) const {
    const auto penalties = stages_.penalty(context.part(0, 0.02), request.pair);
    const xgm::CostVolume costs =
        stages_.cost(context.part(0.02, 0.15), request.pair, shape_of(request));
    return stages_.aggregation(context.part(0.15, 1), costs, *penalties);
  }

  xgm::VolumeShapePtr shape_of(const xgm::MatchRequest& request) const {
    const cv::Mat1b& valid = request.pair.base.valid;
    const xgm::DisparityRange& range = request.range;
    const bool ragged =
        !range.is_uniform() || (!valid.empty() && cv::countNonZero(valid) < int(valid.total()));
    if (ragged && !accepts_range_maps()) {
      throw xgm::Error(
          "this aggregation needs the same disparities at every pixel, but the image is masked or "
          "the search range is a map; use another aggregation");
    }
    return std::make_shared<const xgm::VolumeShape>(
        range.is_uniform() ? range : xgm::semi_global::matchable(range), valid);
  }

  static void mark_masked(xgm::DisparityMap& map, const xgm::Image& base) {
    if (base.valid.empty()) return;
    xgm::parallel_for(0, map.size().height, [&](int y) {
      const std::uint8_t* const valid = base.valid[y];
      for (int x = 0; x < map.size().width; ++x) {
        if (valid[x] == 0) map.invalidate(y, x, xgm::Status::masked);
      }
    });
  }

  Parameters stages_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<SemiGlobal>(
      "semi_global",
      "Matches the base view at one scale: cost, penalties, aggregation, selection, refinement and "
      "filters.",
      "H. Hirschmueller: Stereo processing by semiglobal matching and mutual information, IEEE "
      "TPAMI 30(2), 2008.");
}
