// SPDX-License-Identifier: Apache-2.0
// A plugin file with a pyramid whose levels have names of their own, and with a kind of stage of
// its own, is treated like ours: checked, described, run, reported, explained, planned.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/explain.hpp"
#include "xgm/evaluation/plan_json.hpp"
#include "xgm/evaluation/report.hpp"
#include "xgm/pipeline/describe.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/pipeline/plan.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const Registry& with_two_scales() {
  static const Registry registry = [] {
    Registry all = Registry::with_builtins();
    const bool loaded = all.load(std::string(XGM_EXAMPLE_PLUGINS) + "/xgm_two_scales.so");
    REQUIRE_MESSAGE(loaded, all.failures().front().reason);
    return all;
  }();
  return registry;
}

const std::string kMatcher =
    "matcher: {type: two_scales, matcher: {type: left_right, matcher: {type: semi_global, cost: "
    "census, penalty: constant, aggregation: {type: sgm, directions: 4}}}}\n";

Pipeline two_scales() {
  const LoadedPipeline loaded = load_pipeline_text(kMatcher, "two.yaml", with_two_scales());
  REQUIRE(loaded.pipeline);
  return *loaded.pipeline;
}

MatchRequest request() {
  SceneOptions options;
  options.size = {121, 91};
  options.disparities = {0, 24};
  const SyntheticScene scene = make_scene(options);
  return {scene.pair, DisparityRange::uniform(scene.pair.size(), scene.disparities), {}};
}

}  // namespace

TEST_CASE("own kind: known after loading, listed, described and checked like ours") {
  CHECK(with_two_scales().has_kind("upsampling"));
  CHECK_NOTHROW(require_kind("upsampling", with_two_scales()));
  CHECK(contains(error_of([] { require_kind("upsampling", builtins()); }), "no kind"));
  REQUIRE(with_two_scales().plugins("upsampling").size() == 1);
  const std::string text = describe_text(*with_two_scales().find("matcher", "two_scales"));
  CHECK(contains(text, "upsampling = nearest"));
  CHECK(contains(text, "a stage of kind upsampling"));

  std::string faulty = kMatcher;
  faulty.replace(faulty.find("two_scales,"), 11, "two_scales, upsampling: nearst,");
  const LoadedPipeline loaded = load_pipeline_text(faulty, "two.yaml", with_two_scales());
  REQUIRE(loaded.diagnostics.size() == 1);
  CHECK(contains(to_string(loaded.diagnostics[0]),
                 "there is no upsampling called 'nearst'; did you mean 'nearest'?"));
}

TEST_CASE("own kind: the schema has it where it may stand") {
  const auto schema = nlohmann::json::parse(pipeline_schema(with_two_scales()));
  CHECK(schema["definitions"].contains("upsampling"));
  CHECK_FALSE(schema["definitions"].contains("dataset"));
  CHECK_FALSE(
      nlohmann::json::parse(pipeline_schema(builtins()))["definitions"].contains("upsampling"));
}

TEST_CASE("own pyramid: the report shows its levels by their scales") {
  LevelCollector collector;
  two_scales().run(request(), {.observer = &collector});
  const auto levels = collector.levels();
  REQUIRE(levels.size() == 2);
  CHECK(levels[0].level.name == "thumbnail");
  CHECK(levels[0].level.scale == 3);
  CHECK(levels[0].map.size() == cv::Size(41, 31));
  CHECK(levels[1].level.name == "original");
  CHECK(levels[1].level.scale == 1);
  CHECK(levels[1].range.has_value());
}

TEST_CASE("own pyramid: explanations follow a pixel through its levels") {
  Explainer explainer({121, 91}, {{100, 50}});
  two_scales().run(request(), {.observer = &explainer});
  const Explanation explanation = explainer.explanations().front();
  REQUIRE(explanation.levels.size() == 2);
  CHECK(explanation.levels[0].level.name == "thumbnail");
  CHECK(explanation.levels[0].forward.pixel == cv::Point(33, 16));
  CHECK(explanation.levels[0].reverse.has_value());
  CHECK(explanation.levels[1].forward.pixel == cv::Point(100, 50));
  const std::string text = to_text(explanation);
  CHECK(contains(text, "thumbnail"));
  CHECK(contains(text, "upsampling nearest"));
}

TEST_CASE("own pyramid: plans know its levels, views and what the finer one searches") {
  const MatchRequest asked = request();
  const RunTrace trace = RunTrace::of_whole(two_scales(), asked, {.threads = 1});
  REQUIRE(trace.narrowing);
  PlanRequest larger{.load = Workload::dense({1210, 910}, 1, {0, 240})};
  const RunPlan plan = plan_run(trace, larger);
  CHECK(plan.estimated);
  int coarse = 0, fine = 0;
  for (const PlannedStage& stage : plan.stages) {
    if (stage.place.kind != "aggregation") continue;
    const bool thumbnail = stage.place.level.name == "thumbnail";
    ++(thumbnail ? coarse : fine);
    CHECK(stage.load.size == (thumbnail ? cv::Size(404, 304) : cv::Size(1210, 910)));
    CHECK(stage.load.estimated == !thumbnail);
    CHECK(stage.load.cells_per_pixel <= (thumbnail ? 96 : 240));
  }
  CHECK(coarse == 2);
  CHECK(fine == 2);
  const auto rows = nlohmann::json::parse(to_json(plan, larger))["stages"];
  CHECK(std::any_of(rows.begin(), rows.end(), [](const auto& row) {
    return row["level"] == "thumbnail" && row["view"] == "reverse" && row["scale"] == 3;
  }));
}
