// SPDX-License-Identifier: Apache-2.0
// Stages of every kind that do what a test says, called by slots as in a run.
#pragma once

#include <functional>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"

namespace xgm::testing {

/// A stage of the kind whose run() takes these inputs.
template <class OfKind, class Result, class... Inputs>
class Doing final : public OfKind {
 public:
  using Kind = OfKind;
  using Does = std::function<Result(Inputs...)>;
  explicit Doing(Does does) : does_(std::move(does)) {}
  Result run(Inputs... inputs, const Context&) const override { return does_(inputs...); }

 private:
  Does does_;
};

using DoingPreprocess = Doing<Preprocess, ImagePair, const ImagePair&>;
using DoingMatcher = Doing<Matcher, MatchResult, const MatchRequest&>;
using DoingCost = Doing<Cost, CostVolume, const ImagePair&, const VolumeShapePtr&>;
using DoingPenalty = Doing<Penalty, std::unique_ptr<const PenaltyField>, const ImagePair&>;
using DoingAggregation =
    Doing<Aggregation, AggregatedVolume, const CostVolume&, const PenaltyField&>;
using DoingSelection = Doing<Selection, DisparityMap, const AggregatedVolume&>;
using DoingRefinement =
    Doing<Refinement, DisparityMap, const DisparityMap&, const AggregatedVolume&>;
using DoingFilter = Doing<Filter, DisparityMap, const DisparityMap&, const ImagePair&>;
using DoingConsistency = Doing<Consistency, MatchResult, const MatchResult&>;
using DoingConfidence = Doing<Confidence, cv::Mat1f, const Evidence&>;
using DoingSearchRange =
    Doing<SearchRange, DisparityRange, const DisparityMap&, const DisparityRange&>;

/// The slot "here" with such a stage, whose plugin is called "bad".
template <class Stage>
auto slot_of(typename Stage::Does does) {
  Slot<typename Stage::Kind> slot;
  slot.assign(std::make_shared<const Stage>(std::move(does)), "bad", "here", {});
  return slot;
}

}  // namespace xgm::testing
