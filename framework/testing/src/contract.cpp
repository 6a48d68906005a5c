// SPDX-License-Identifier: Apache-2.0
#include "xgm/testing/contract.hpp"

namespace xgm::testing {
namespace {

/// Whether `stage` is of the kind; if so, its violations.
template <class Kind>
bool check_as(const Stage& stage, Violations (*check)(const Kind&, const Watch&),
              const Watch& watch, Violations& violations) {
  const auto* kind = dynamic_cast<const Kind*>(&stage);
  if (kind != nullptr) violations = check(*kind, watch);
  return kind != nullptr;
}

}  // namespace

Violations check_stage(const Stage& stage, const Watch& watch) {
  Violations found;
  const bool known =
      check_as(stage, check_preprocess, watch, found) ||
      check_as(stage, check_matcher, watch, found) || check_as(stage, check_cost, watch, found) ||
      check_as(stage, check_penalty, watch, found) ||
      check_as(stage, check_aggregation, watch, found) ||
      check_as(stage, check_selection, watch, found) ||
      check_as(stage, check_refinement, watch, found) ||
      check_as(stage, check_filter, watch, found) || check_as(stage, check_fuser, watch, found) ||
      check_as(stage, check_consistency, watch, found) ||
      check_as(stage, check_confidence, watch, found) ||
      check_as(stage, check_search_range, watch, found) ||
      check_as(stage, check_dataset, watch, found) || check_as(stage, check_pipeline, watch, found);
  if (!known) found.emplace_back("the stage is of no kind that has a contract");
  return found;
}

}  // namespace xgm::testing
