// SPDX-License-Identifier: Apache-2.0
// All that a bench knows, as JSON.
#include "xgm/base/json.hpp"
#include "bench/table.hpp"
#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/evaluation/evaluation_json.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm {
namespace {

void add_figures(Json& json, const BenchCell& cell) {
  if (cell.state == CellState::failed) json["failure"] = cell.failure;
  if (cell.state != CellState::done) return;
  json["seconds"] = cell.seconds;
  json["peak_memory_bytes"] = cell.peak_bytes;
  json["disparity_evaluations"] = cell.evaluations;
  json["density"] = cell.density;
  json["truth"] = to_json(cell.regions);
}

Json pipelines(const BenchRequest& request) {
  Json list = Json::array();
  for (const BenchPipeline& pipeline : request.pipelines) {
    Json overrides = Json::array();
    for (const Override& change : pipeline.overrides) {
      overrides.push_back({{"path", change.path}, {"value", change.value}});
    }
    list.push_back({{"name", pipeline.name},
                    {"file", pipeline.file},
                    {"overrides", std::move(overrides)},
                    {"resolved", Json::parse(pipeline.resolved)}});
  }
  return list;
}

Json averages(const BenchResult& result) {
  Json list = Json::array();
  for (const std::string& set : sets(result)) {
    for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
      const BenchAverage mean = average(result, i, set);
      Json json = {{"set", set},
                   {"pipeline", result.request.pipelines[i].name},
                   {"scenes", mean.scenes},
                   {"of", mean.of},
                   {"comparable", mean.comparable}};
      add_figures(json, mean.figures);
      list.push_back(std::move(json));
    }
  }
  return list;
}

Json cells(const BenchResult& result) {
  Json list = Json::array();
  for (std::size_t scene = 0; scene < result.request.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
      const BenchCell& cell = result.at(i, scene);
      const BenchScene& where = result.request.scenes[scene];
      Json json = {{"set", where.set},
                   {"scene", where.files.name},
                   {"pipeline", result.request.pipelines[i].name},
                   {"weight", where.files.weight},
                   {"folder", cell_folder(result.request, i, scene)},
                   {"state", state_text(cell.state)}};
      add_figures(json, cell);
      list.push_back(std::move(json));
    }
  }
  return list;
}

}  // namespace

std::string bench_json(const BenchResult& result) {
  const BenchRules& rules = result.rules;
  Json json = {{"format", 1},
               {"xgm", XGM_VERSION},
               {"interrupted", result.interrupted},
               {"threads", result.request.threads},
               {"rules",
                {{"thresholds_px", rules.thresholds},
                 {"scale", rules.scale > 0 ? Json(rules.scale) : Json("full")},
                 {"clip", rules.clip},
                 {"region", rules.region.empty() ? "non-occluded, else all" : rules.region}}},
               {"pipelines", pipelines(result.request)},
               {"averages", averages(result)},
               {"cells", cells(result)}};
  return json.dump(2) + "\n";
}

}  // namespace xgm
