// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "xgm/base/json.hpp"
#include "xgm/evaluation/plan_json.hpp"

namespace xgm {
namespace {

Json stage_json(const PlannedStage& stage) {
  const StagePlace& place = stage.place;
  return {{"stage", place.path},
          {"kind", place.kind},
          {"plugin", place.plugin},
          {"level", place.level.name.empty() ? Json() : Json(place.level.name)},
          {"scale", place.level.scale},
          {"view", to_string(place.view)},
          {"width", stage.load.size.width},
          {"height", stage.load.size.height},
          {"cells_per_pixel", stage.load.cells_per_pixel},
          {"estimated", stage.load.estimated},
          {"cells", std::round(stage.load.cells())},
          {"updates", std::round(stage.needs.updates)},
          {"moved_bytes", std::round(stage.needs.moved)},
          {"memory_bytes", std::round(stage.memory)},
          {"seconds", stage.seconds},
          {"same_as", stage.same_as.empty() ? Json() : Json(stage.same_as)}};
}

}  // namespace

std::string to_json(const RunPlan& plan, const PlanRequest& request) {
  Json json{
      {"width", request.load.size.width},
      {"height", request.load.size.height},
      {"planes", request.load.planes},
      {"disparities", {{"first", request.load.range.begin}, {"last", request.load.range.end - 1}}},
      {"threads", request.load.threads},
      {"peak_memory_bytes", std::round(plan.peak_bytes)},
      {"peak_stage", plan.peak_stage},
      {"seconds", plan.seconds},
      {"estimated", plan.estimated}};
  if (plan.narrowing) {
    json["narrowing"] = {{"spread", plan.narrowing->spread}, {"lost", plan.narrowing->lost}};
  }
  json["stages"] = Json::array();
  for (const PlannedStage& stage : plan.stages) json["stages"].push_back(stage_json(stage));
  return json.dump(2) + "\n";
}

}  // namespace xgm
