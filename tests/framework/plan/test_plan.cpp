// SPDX-License-Identifier: Apache-2.0
// Plans: what a small run shows, scaled to the size asked for.
#include "support/paths.hpp"
#include "xgm/pipeline/plan.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/fake_stages.hpp"
#include "support/support.hpp"
#include "xgm/evaluation/plan_json.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

Pipeline shipped(const std::string& name) {
  const auto loaded =
      load_pipeline(std::string(XGM_SOURCE_DIR) + "/pipelines/" + name + ".yaml", builtins());
  REQUIRE(loaded.pipeline);
  return *loaded.pipeline;
}

MatchRequest small_request() {
  SceneOptions options;
  options.size = {160, 120};
  options.disparities = {0, 32};
  options.colour = true;
  const SyntheticScene scene = make_scene(options);
  return {scene.pair, DisparityRange::uniform(scene.pair.size(), scene.disparities), {}};
}

RunTrace trace_of(const Pipeline& pipeline) {
  return RunTrace::of_whole(pipeline, small_request(), {.threads = 1});
}

PlanRequest dense(cv::Size size, int disparities) {
  return {.load = Workload::dense(size, 3, {0, disparities})};
}

double memory_of(const RunPlan& plan, const std::string& path) {
  for (const PlannedStage& stage : plan.stages) {
    if (stage.place.path == path) return stage.memory;
  }
  FAIL("no stage ", path);
  return 0;
}

}  // namespace

TEST_CASE("a plan has the stages of a run, in their order") {
  const MatchRequest request = small_request();
  for (const std::string& name : shipped_pipelines(std::string(XGM_SOURCE_DIR) + "/pipelines")) {
    CAPTURE(name);
    const Pipeline pipeline = shipped(name.substr(0, name.find('.')));
    RunRecorder recorder;
    pipeline.run(request, {.observer = &recorder, .threads = 1});
    const RunPlan plan = plan_run(trace_of(pipeline), dense({2000, 1500}, 200));
    REQUIRE(plan.stages.size() == recorder.stages().size());
    for (std::size_t i = 0; i < plan.stages.size(); ++i) {
      CHECK(plan.stages[i].place.path == recorder.stages()[i].place.path);
      CHECK(plan.stages[i].place.plugin == recorder.stages()[i].place.plugin);
      CHECK(plan.stages[i].seconds > 0);
    }
  }
}

TEST_CASE("cells of dense volumes are known exactly, also of masked images and range maps") {
  const cv::Size size(37, 23);
  const auto cells = [&](const DisparityRange& range, const cv::Mat1b& mask) {
    ImagePair pair = shifted_pair(size, 2, 1);
    pair.base.valid = mask;
    const Workload load = workload_of({pair, range, {}}, 1);
    CHECK(load.cells() == doctest::Approx(double(VolumeShape(range, mask).cells())));
  };
  cells(DisparityRange::uniform(size, {-3, 14}), {});
  cells(DisparityRange::uniform(size, {0, 16}), random_mask(size, 0.3, 2));
  cells(random_range(size, {-20, 40}, 3), {});
  cells(random_range(size, {-20, 40}, 3), random_mask(size, 0.3, 2));
}

TEST_CASE("the maximum of memory is costs and sums of one view, and grows with the disparities") {
  const RunTrace trace = trace_of(shipped("sgm8"));
  const RunPlan few = plan_run(trace, dense({1000, 1000}, 64));
  const RunPlan many = plan_run(trace, dense({1000, 1000}, 128));
  CHECK(few.peak_stage.starts_with("matcher.reverse.matcher."));
  CHECK_FALSE(few.estimated);
  CHECK(few.peak_bytes > 3 * 64e6 + 24e6);  // the images, too
#ifndef XGM_SANITIZED                       // sanitizers need memory of their own
  CHECK(few.peak_bytes < 1.3 * (3 * 64e6 + 60e6));
#endif
  CHECK(many.peak_bytes - few.peak_bytes > 0.99 * 3 * 64e6);
  CHECK(many.peak_bytes - few.peak_bytes < 1.1 * 3 * 64e6);
}

TEST_CASE("the confidence of a map counts from when it is there") {
  const auto plan_of = [](const std::string& more) {
    const auto loaded = load_pipeline_text(
        "matcher: {type: semi_global, cost: census, penalty: constant, aggregation: sgm, filters: "
        "[median]" +
            more + "}\npostprocess: [median]\n",
        "p.yaml", builtins());
    REQUIRE(loaded.pipeline);
    return plan_run(trace_of(*loaded.pipeline), dense({1000, 1000}, 64));
  };
  const RunPlan with = plan_of(", confidence: peak_ratio"), without = plan_of("");
  const double more = memory_of(with, "postprocess[0]") - memory_of(without, "postprocess[0]");
  CHECK(more >= 4e6);  // bytes: a float of each pixel, of the map and of the filter's copy
  CHECK(more <= 3 * 4e6);
  CHECK(memory_of(with, "matcher.confidence") >= memory_of(without, "matcher.aggregation"));
}

TEST_CASE("freed volumes count until the matcher has ended, for they wait to be used again") {
  const RunPlan plan = plan_run(trace_of(shipped("tmgm16_refined")), dense({2000, 2000}, 200));
  const std::string finest = "matcher.s1.matcher.";
  CHECK(memory_of(plan, finest + "forward.matcher.filters[0]") >
        0.8 * memory_of(plan, finest + "forward.matcher.aggregation"));
  CHECK(memory_of(plan, "postprocess[0]") < 0.7 * plan.peak_bytes);
}

TEST_CASE("key points are searched in as many tiles at a time as there are threads, four at most") {
  const RunTrace trace = trace_of(shipped("tmgm16_refined"));
  const auto deskew = [&](int threads) {
    PlanRequest request = dense({3000, 2000}, 64);
    request.load.threads = threads;
    return memory_of(plan_run(trace, request), "preprocess[0]");
  };
  CHECK(deskew(2) > 1.2 * deskew(1));
  CHECK(deskew(4) > 1.2 * deskew(2));
  CHECK(deskew(8) == deskew(4));
}

TEST_CASE("a pyramid's finer levels are estimates, within what they may search") {
  RunTrace trace = trace_of(shipped("tsgm8"));
  REQUIRE(trace.narrowing);
  CHECK(trace.narrowing->spread > 0);
  trace.narrowing = Narrowing{.spread = 10, .lost = 0.5};
  const PlanRequest request = dense({800, 600}, 100);
  for (const PlannedStage& stage : plan_run(trace, request).stages) {
    const std::string& path = stage.place.path;
    if (path == "matcher.s8.matcher") CHECK(stage.load.cells_per_pixel == 16);
    if (path == "matcher.s4.matcher") CHECK(stage.load.cells_per_pixel == 10 + 0.5 * 26);
    if (path == "matcher.s4.matcher") CHECK(stage.load.size == cv::Size(200, 150));
    if (path == "matcher.s1.matcher") CHECK(stage.load.cells_per_pixel == 60);
  }
  trace.narrowing = Narrowing{.spread = 1000, .lost = 0};
  const RunPlan all = plan_run(trace, request);
  CHECK(all.estimated);
  for (const PlannedStage& stage : all.stages) CHECK(stage.load.cells_per_pixel <= 112);
  CHECK(trace_of(shipped("sgm8")).narrowing == std::nullopt);
}

TEST_CASE("beside a pyramid, a matcher of a fusion searches everything") {
  const auto traced = [](const std::string& matcher) {
    const std::string yaml = "matcher: " + matcher + "\n";
    return trace_of(*load_pipeline_text(yaml, "test.yaml", builtins()).pipeline);
  };
  const std::string flat =
      "{type: semi_global, cost: census, penalty: constant, aggregation: {type: sgm, directions: "
      "4}}";
  const std::string pyramid =
      "{type: pyramid, scale: 4, matcher: {type: left_right, matcher: " + flat + "}}";
  const RunTrace alone = traced(pyramid);
  const RunTrace fused = traced("{type: fusion, matchers: [" + flat + ", " + pyramid + "]}");
  REQUIRE(alone.narrowing);
  REQUIRE(fused.narrowing);
  CHECK(fused.narrowing->spread == doctest::Approx(alone.narrowing->spread));
  CHECK(fused.narrowing->lost == doctest::Approx(alone.narrowing->lost));
  int seen = 0;
  for (const PlannedStage& stage : plan_run(fused, dense({800, 600}, 100)).stages) {
    if (stage.place.path != "matcher.matchers[0]") continue;
    CHECK(stage.load.cells_per_pixel == 112);
    CHECK_FALSE(stage.load.estimated);
    ++seen;
  }
  CHECK(seen == 1);
}

TEST_CASE(
    "what equal matchers of a fusion find alike is counted once, and held until it is asked") {
  const auto planned = [](const std::string& other) {
    const std::string first =
        "{type: semi_global, cost: census, penalty: {type: constant, p1: 24, p2: 96}, "
        "aggregation: {type: sgm, directions: 4}}";
    const std::string second =
        "{type: semi_global, cost: census, penalty: {type: constant, p1: " + other +
        ", p2: 96}, aggregation: {type: sgm, directions: 4}}";
    const std::string yaml =
        "matcher: {type: fusion, matchers: [{type: left_right, matcher: " + first + "}, " + second +
        "]}\n";
    return plan_run(trace_of(*load_pipeline_text(yaml, "test.yaml", builtins()).pipeline),
                    dense({800, 600}, 100));
  };
  const RunPlan equal = planned("24"), unlike = planned("25");
  const auto aggregations = [](const RunPlan& plan) {
    return std::ranges::count_if(
        plan.stages, [](const PlannedStage& stage) { return stage.place.kind == "aggregation"; });
  };
  CHECK(aggregations(equal) == 2);
  CHECK(aggregations(unlike) == 3);
  const PlannedStage& last = equal.stages[equal.stages.size() - 2];
  CHECK(last.place.path == "matcher.matchers[1]");
  CHECK(last.same_as == "matcher.matchers[0].forward.matcher");
  CHECK(last.needs.updates == 0);
  CHECK(last.needs.working == 0);
  const std::string reverse = "matcher.matchers[0].reverse.matcher";
  constexpr double kMap = 5 * 800 * 600;
  CHECK(memory_of(equal, reverse) == doctest::Approx(memory_of(unlike, reverse) + kMap));
  CHECK(equal.peak_bytes <= unlike.peak_bytes + kMap + 1);
}

TEST_CASE("the disparities that fit are found") {
  const RunTrace trace = trace_of(shipped("sgm8"));
  const PlanRequest request = dense({1000, 500}, 300);
  const double all = plan_run(trace, request).peak_bytes;
  CHECK(max_disparities(trace, request, all) == 300);
  CHECK(max_disparities(trace, request, 1e6) == 0);
  const int fitting = max_disparities(trace, request, all / 2);
  CHECK(plan_run(trace, dense({1000, 500}, fitting)).peak_bytes <= all / 2 * 1.01);
  CHECK(plan_run(trace, dense({1000, 500}, fitting + 1)).peak_bytes > all / 2 * 0.99);
}

TEST_CASE("a matcher that tells nothing, and shows no stage inside, counts with costs and sums") {
  const auto loaded = load_pipeline_text(
      "xgm: 1\nmatcher: {type: fake_matcher, cost: fake_cost}\npostprocess: [fake_filter]\n",
      "p.yaml", fake_registry());
  REQUIRE(loaded.pipeline);
  const RunPlan plan = plan_run(trace_of(*loaded.pipeline), dense({1000, 1000}, 64));
  REQUIRE(plan.stages.size() == 2);
  CHECK(plan.stages[0].memory > 64e6 * 3);
  CHECK(plan.peak_stage == "matcher");
}

TEST_CASE("a plan as JSON has every stage") {
  const PlanRequest request = dense({100, 80}, 20);
  const RunPlan plan = plan_run(trace_of(shipped("tsgm8")), request);
  const auto json = nlohmann::json::parse(to_json(plan, request));
  CHECK(json["stages"].size() == plan.stages.size());
  CHECK(json["peak_memory_bytes"].get<double>() == doctest::Approx(plan.peak_bytes));
  CHECK(json["disparities"]["last"] == 19);
  CHECK(json["estimated"] == true);
}
