// SPDX-License-Identifier: Apache-2.0
#include "xgm/testing/contract.hpp"

namespace xgm::testing {
namespace {

/// Whether `stage` is of the kind; if so, its violations.
template <class Kind>
bool check_as(const Stage& stage, Violations (*check)(const Kind&), Violations& violations) {
  const auto* kind = dynamic_cast<const Kind*>(&stage);
  if (kind != nullptr) violations = check(*kind);
  return kind != nullptr;
}

}  // namespace

Violations check_stage(const Stage& stage) {
  Violations found;
  const bool known =
      check_as(stage, check_preprocess, found) || check_as(stage, check_matcher, found) ||
      check_as(stage, check_cost, found) || check_as(stage, check_penalty, found) ||
      check_as(stage, check_aggregation, found) || check_as(stage, check_selection, found) ||
      check_as(stage, check_refinement, found) || check_as(stage, check_filter, found) ||
      check_as(stage, check_fuser, found) || check_as(stage, check_consistency, found) ||
      check_as(stage, check_confidence, found) ||
      check_as(stage, check_search_range, found) || check_as(stage, check_dataset, found);
  if (!known) found.emplace_back("the stage is of no kind that has a contract");
  return found;
}

}  // namespace xgm::testing
