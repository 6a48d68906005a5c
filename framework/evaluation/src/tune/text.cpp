// SPDX-License-Identifier: Apache-2.0
// The result of a tuning for people and for programs.
#include <cmath>

#include "report/yaml_text.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/base/text.hpp"
#include "xgm/evaluation/record_json.hpp"
#include "xgm/evaluation/table.hpp"
#include "xgm/evaluation/tune.hpp"

namespace xgm {
namespace {

constexpr double kPercent = 100;

std::string percent(double share) { return figure_text(kPercent * share, 2); }

std::string measure(const TuneResult& result) {
  return "total error at " + short_number(result.request.rules.thresholds.front()) + " px, %";
}

const BenchPipeline& pipeline(const TuneResult& result, const TunedPipeline& tuned) {
  return result.request.bench.pipelines[tuned.pipeline];
}

std::string name(const TuneResult& result, const TunedPipeline& tuned) {
  return pipeline(result, tuned).name + (tuned.pipeline == 0 ? " (as it is)" : "");
}

std::vector<std::string> scene_names(const TuneResult& result,
                                     const std::vector<std::size_t>& scenes) {
  std::vector<std::string> names;
  for (const std::size_t i : scenes) names.push_back(result.request.bench.scenes[i].files.name);
  return names;
}

std::string scenes_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " scene" : " scenes");
}

/// What the scenes held back say of the choice.
std::string held_out_note(const TuneResult& result) {
  if (result.held_out.empty()) {
    return "no scene was held back: the error of the best is that of the scenes it was chosen by, "
           "and too good";
  }
  std::string text = "held back: " + scenes_text(result.held_out.size()) + " (" +
                     join(scene_names(result, result.held_out)) +
                     "): " + percent(result.error_before) + " % as it is, " +
                     percent(result.error_after) + " % with the best";
  if (result.best().pipeline == 0) {
    text += "; nothing was better than the pipeline as it is";
  } else if (!(result.error_after < result.error_before)) {
    text += "; there the best is no better: keep the pipeline as it is";
  }
  return text;
}

Table table(const TuneResult& result) {
  Table table{.title = "Tuning on " + scenes_text(result.tuning.size()) + " (" +
                       join(scene_names(result, result.tuning)) + ")",
              .header = {"pipeline", "scenes", measure(result)}};
  for (const TunedPipeline& tuned : result.ranking) {
    table.rows.push_back({{name(result, tuned)},
                          {std::to_string(tuned.scenes)},
                          {percent(tuned.error), &tuned == &result.best()}});
  }
  if (result.ranking.back().scenes < result.best().scenes) {
    table.notes.push_back("errors over other numbers of scenes cannot be compared");
  }
  table.notes.push_back(held_out_note(result));
  table.notes.push_back(std::to_string(result.runs) + " runs, seed " +
                        std::to_string(result.request.seed));
  for (const TunedPipeline& tuned : result.ranking) {
    if (!tuned.failure.empty())
      table.notes.push_back(name(result, tuned) + " failed on " + tuned.failure);
  }
  return table;
}

Json figure(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

std::string tune_markdown(const TuneResult& result) { return table_markdown(table(result)); }
std::string tune_text(const TuneResult& result) { return table_text(table(result)); }

std::string tune_json(const TuneResult& result) {
  Json ranking = Json::array();
  for (const TunedPipeline& tuned : result.ranking) {
    Json entry = {{"name", pipeline(result, tuned).name},
                  {"overrides", to_json(pipeline(result, tuned).overrides)},
                  {"scenes", tuned.scenes},
                  {"error", figure(tuned.error)}};
    if (!tuned.failure.empty()) entry["failure"] = tuned.failure;
    ranking.push_back(std::move(entry));
  }
  const Json json = {
      {"pipeline", result.request.bench.pipelines.front().file},
      {"threshold_px", result.request.rules.thresholds.front()},
      {"seed", result.request.seed},
      {"runs", result.runs},
      {"tuning_scenes", Json(scene_names(result, result.tuning))},
      {"held_out_scenes", Json(scene_names(result, result.held_out))},
      {"start",
       {{"tuning", figure(result.start().error)}, {"held_out", figure(result.error_before)}}},
      {"best",
       {{"name", pipeline(result, result.best()).name},
        {"overrides", to_json(pipeline(result, result.best()).overrides)},
        {"tuning", figure(result.best().error)},
        {"held_out", figure(result.error_after)}}},
      {"ranking", ranking}};
  return json.dump(2) + "\n";
}

std::string best_yaml(const TuneResult& result) {
  const BenchPipeline& best = pipeline(result, result.best());
  std::string head =
      "# Chosen by pipeline tune. " + measure(result) + ": " + percent(result.best().error) +
      " on the scenes of the choice (as it was: " + percent(result.start().error) + ")";
  if (!result.held_out.empty()) {
    head += ", " + percent(result.error_after) + " on those held back (" +
            percent(result.error_before) + ")";
  }
  return head + ".\n" + report::yaml_text(Json::parse(best.resolved));
}

}  // namespace xgm
