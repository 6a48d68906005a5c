// SPDX-License-Identifier: Apache-2.0
// A stage of each kind that fails in each check of its contract.
#include <stdexcept>
#include <xgm/plugin.hpp>

namespace {

constexpr int kTooLarge = 999;

cv::Size larger(cv::Size size) { return {size.width + 1, size.height + 1}; }

template <class Kind>
class Bad : public Kind {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
};

struct BadPreprocess final : Bad<xgm::Preprocess> {
  explicit BadPreprocess(Parameters) {}
  xgm::ImagePair run(const xgm::ImagePair& pair, const xgm::Context&) const override {
    return {pair.base, xgm::Image(cv::Mat1f(larger(pair.size()), 0.0F))};
  }
};

struct BadMatcher final : Bad<xgm::Matcher> {
  explicit BadMatcher(Parameters) {}
  xgm::MatchResult run(const xgm::MatchRequest& request, const xgm::Context&) const override {
    return {xgm::DisparityMap(larger(request.pair.size())), std::nullopt};
  }
};

struct BadFamily final : Bad<xgm::StereoFamily> {
  explicit BadFamily(Parameters) {}
  xgm::MatchResult run(const xgm::MatchRequest& request, const xgm::Context&) const override {
    return {xgm::DisparityMap(larger(request.pair.size())), std::nullopt};
  }
  std::optional<xgm::Interval> disparities() const override { return std::nullopt; }
  bool accepts_range_maps() const override { return true; }
};

struct BadCost final : Bad<xgm::Cost> {
  explicit BadCost(Parameters) {}
  xgm::CostVolume run(const xgm::ImagePair&, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    xgm::CostVolume costs(shape, kTooLarge);
    std::fill_n(costs.data(), shape->cells(), std::uint8_t{0});
    return costs;
  }
};

struct BadPenalty final : Bad<xgm::Penalty> {
  explicit BadPenalty(Parameters) {}
  std::unique_ptr<const xgm::PenaltyField> run(const xgm::ImagePair&,
                                               const xgm::Context&) const override {
    return nullptr;
  }
};

struct BadAggregation final : Bad<xgm::Aggregation> {
  explicit BadAggregation(Parameters) {}
  xgm::AggregatedVolume run(const xgm::CostVolume& costs, const xgm::PenaltyField&,
                            const xgm::Context&) const override {
    xgm::AggregatedVolume sums(costs.shape_ptr(), kTooLarge);
    std::fill_n(sums.data(), sums.shape().cells(), std::uint16_t{0});
    return sums;
  }
};

struct BadSelection final : Bad<xgm::Selection> {
  explicit BadSelection(Parameters) {}
  xgm::DisparityMap run(const xgm::AggregatedVolume& sums, const xgm::Context&) const override {
    return xgm::DisparityMap(larger(sums.shape().size()));
  }
};

struct BadRefinement final : Bad<xgm::Refinement> {
  explicit BadRefinement(Parameters) {}
  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::AggregatedVolume&,
                        const xgm::Context&) const override {
    return xgm::DisparityMap(larger(map.size()));
  }
};

struct BadFilter final : Bad<xgm::Filter> {
  explicit BadFilter(Parameters) {}
  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    return xgm::DisparityMap(larger(map.size()));
  }
};

struct BadFuser final : Bad<xgm::Fuser> {
  explicit BadFuser(Parameters) {}
  xgm::DisparityMap run(const xgm::Candidates& candidates, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    return xgm::DisparityMap(larger(candidates.maps.front().size()));
  }
};

struct BadConsistency final : Bad<xgm::Consistency> {
  explicit BadConsistency(Parameters) {}
  xgm::MatchResult run(const xgm::MatchResult& maps, const xgm::Context&) const override {
    return {maps.forward.clone(), std::nullopt};
  }
};

struct BadSearchRange final : Bad<xgm::SearchRange> {
  explicit BadSearchRange(Parameters) {}
  xgm::DisparityRange run(const xgm::DisparityMap&, const xgm::DisparityRange& limits,
                          const xgm::Context&) const override {
    return xgm::DisparityRange::uniform(larger(limits.size()), limits.hull());
  }
};

struct BadDataset final : Bad<xgm::Dataset> {
  explicit BadDataset(Parameters) {}
  std::vector<xgm::SceneFiles> scenes(const std::string&) const override {
    throw std::runtime_error("no");
  }
  std::string layout() const override { return ""; }
};

struct BadConfidence final : Bad<xgm::Confidence> {
  explicit BadConfidence(Parameters) {}
  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context&) const override {
    return cv::Mat1f(larger(evidence.map.size()), 2.0F);
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<BadPreprocess>("bad_preprocess", "Images of two sizes.");
  registry.add<BadMatcher>("bad_matcher", "A map of another size.");
  registry.add<BadFamily>("bad_pipeline", "A map of another size.");
  registry.add<BadCost>("bad_cost", "A bound that no cost can have.");
  registry.add<BadPenalty>("bad_penalty", "Nothing.");
  registry.add<BadAggregation>("bad_aggregation", "More fraction bits than there are.");
  registry.add<BadSelection>("bad_selection", "A map of another size.");
  registry.add<BadRefinement>("bad_refinement", "A map of another size.");
  registry.add<BadFilter>("bad_filter", "A map of another size.");
  registry.add<BadFuser>("bad_fuser", "A map of another size.");
  registry.add<BadConsistency>("bad_consistency", "One map instead of two.");
  registry.add<BadSearchRange>("bad_search_range", "A range of another size.");
  registry.add<BadDataset>("bad_dataset", "Always throws.");
  registry.add<BadConfidence>("bad_confidence", "A confidence of another size.");
}
