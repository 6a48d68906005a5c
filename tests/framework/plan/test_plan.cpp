// SPDX-License-Identifier: Apache-2.0
// Plans keep the same books as runs: the same stages, and what they hold.
#include "xgm/pipeline/plan.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "support/fake_stages.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
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

PlanRequest dense(cv::Size size, int disparities) {
  return {.load = Workload::dense(size, 3, {0, disparities})};
}

double memory_of(const RunPlan& plan, const std::string& path) {
  for (const PlannedStage& stage : plan.stages) {
    if (stage.path == path) return stage.memory;
  }
  FAIL("no stage ", path);
  return 0;
}

}  // namespace

TEST_CASE("a plan has the stages of a run, in their order") {
  const SyntheticScene scene = make_scene({});
  const MatchRequest request{
      scene.pair, DisparityRange::uniform(scene.pair.size(), scene.disparities), {}};
  for (const std::string& name : shipped_pipelines(std::string(XGM_SOURCE_DIR) + "/pipelines")) {
    CAPTURE(name);
    const Pipeline pipeline = shipped(name.substr(0, name.find('.')));
    RunRecorder recorder;
    pipeline.run(request, {.observer = &recorder, .threads = 1});
    const RunPlan plan = plan_run(pipeline, {.load = workload_of(request, 1)});
    REQUIRE(plan.stages.size() == recorder.stages().size());
    for (std::size_t i = 0; i < plan.stages.size(); ++i) {
      CHECK(plan.stages[i].path == recorder.stages()[i].path);
      CHECK(plan.stages[i].plugin == recorder.stages()[i].plugin);
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
    CHECK(load.shape_bytes() <= double(VolumeShape(range, mask).bytes()));
    CHECK(load.shape_bytes() > 0.9 * double(VolumeShape(range, mask).bytes()));
  };
  cells(DisparityRange::uniform(size, {-3, 14}), {});
  cells(DisparityRange::uniform(size, {0, 16}), random_mask(size, 0.3, 2));
  cells(random_range(size, {-20, 40}, 3), {});
  cells(random_range(size, {-20, 40}, 3), random_mask(size, 0.3, 2));
}

TEST_CASE("the most of memory is costs and sums of one view, and grows with the disparities") {
  const Pipeline pipeline = shipped("sgm8");
  const RunPlan few = plan_run(pipeline, dense({1000, 1000}, 64));
  const RunPlan many = plan_run(pipeline, dense({1000, 1000}, 128));
  CHECK(few.peak_stage.starts_with("matcher.reverse.matcher."));
  CHECK_FALSE(few.estimated);
  CHECK(many.peak_bytes - few.peak_bytes > 0.99 * 3 * 64e6);
  CHECK(many.peak_bytes - few.peak_bytes < 1.1 * 3 * 64e6);
}

TEST_CASE("freed volumes count until the matcher has ended, for they wait to be used again") {
  const RunPlan plan = plan_run(shipped("tmgm16_refined"), dense({2000, 2000}, 200));
  const std::string finest = "matcher.s1.matcher.";
  CHECK(memory_of(plan, finest + "forward.matcher.filters[0]") >
        0.8 * memory_of(plan, finest + "forward.matcher.aggregation"));
  CHECK(memory_of(plan, "postprocess[0]") < 0.5 * plan.peak_bytes);
}

TEST_CASE("key points are searched in as many tiles at a time as there are threads, four at most") {
  const auto deskew = [](int threads) {
    PlanRequest request = dense({3000, 2000}, 64);
    request.load.threads = threads;
    return memory_of(plan_run(shipped("tmgm16_refined"), request), "preprocess[0]");
  };
  CHECK(deskew(2) > 1.2 * deskew(1));
  CHECK(deskew(4) > 1.2 * deskew(2));
  CHECK(deskew(8) == deskew(4));
}

TEST_CASE("a pyramid's finer levels are estimates, within what they may search") {
  const Pipeline pipeline = shipped("tsgm8");
  PlanRequest request = dense({800, 600}, 100);
  request.experience.narrowing = Narrowing{.spread = 10, .lost = 0.5};
  for (const PlannedStage& stage : plan_run(pipeline, request).stages) {
    if (stage.path == "matcher.s8.matcher") CHECK(stage.load.cells_per_pixel == 16);
    if (stage.path == "matcher.s4.matcher") CHECK(stage.load.cells_per_pixel == 10 + 0.5 * 26);
    if (stage.path == "matcher.s1.matcher") CHECK(stage.load.cells_per_pixel == 60);
  }
  request.experience.narrowing = Narrowing{.spread = 1000, .lost = 0};
  const RunPlan all = plan_run(pipeline, request);
  CHECK(all.estimated);
  for (const PlannedStage& stage : all.stages) CHECK(stage.load.cells_per_pixel <= 112);
}

TEST_CASE("the disparities that fit are found") {
  const Pipeline pipeline = shipped("sgm8");
  const PlanRequest request = dense({1000, 500}, 300);
  const double all = plan_run(pipeline, request).peak_bytes;
  CHECK(max_disparities(pipeline, request, all) == 300);
  CHECK(max_disparities(pipeline, request, 1e6) == 0);
  const int fitting = max_disparities(pipeline, request, all / 2);
  CHECK(plan_run(pipeline, dense({1000, 500}, fitting)).peak_bytes <= all / 2 * 1.01);
  CHECK(plan_run(pipeline, dense({1000, 500}, fitting + 1)).peak_bytes > all / 2 * 0.99);
}

TEST_CASE("a probe finds speeds of all stages, and what a pyramid leaves to search") {
  SceneOptions options;
  options.size = {320, 240};
  options.disparities = {0, 64};
  const SyntheticScene scene = make_scene(options);
  const MatchRequest request{
      scene.pair, DisparityRange::uniform(scene.pair.size(), scene.disparities), {}};
  const Pipeline pipeline = shipped("tsgm8");
  const Experience experience = probe(pipeline, request, 1);
  REQUIRE(experience.narrowing);
  CHECK(experience.narrowing->spread > 0);
  CHECK(experience.bandwidth > 1e8);
  const RunPlan plan =
      plan_run(pipeline, {.load = workload_of(request, 1), .experience = experience});
  for (const PlannedStage& stage : plan.stages) {
    CAPTURE(stage.path);
    CHECK(stage.seconds > 0);
  }
  CHECK(probe(shipped("sgm8"), request, 1).narrowing == std::nullopt);
}

TEST_CASE("a plugin that tells nothing counts with what its kind returns") {
  const auto loaded = load_pipeline_text(
      "xgm: 1\nmatcher: {type: fake_matcher, cost: fake_cost, filters: "
      "[fake_filter]}\npostprocess: [fake_filter]\n",
      "p.yaml", fake_registry());
  REQUIRE(loaded.pipeline);
  const RunPlan plan = plan_run(*loaded.pipeline, dense({1000, 1000}, 64));
  REQUIRE(plan.stages.size() == 2);
  CHECK(plan.stages[0].memory > 64e6 * 3);
  CHECK(plan.peak_stage == "matcher");
}

TEST_CASE("a plan as JSON has every stage") {
  const PlanRequest request = dense({100, 80}, 20);
  const RunPlan plan = plan_run(shipped("tsgm8"), request);
  const auto json = nlohmann::json::parse(to_json(plan, request));
  CHECK(json["stages"].size() == plan.stages.size());
  CHECK(json["peak_memory_bytes"].get<double>() == doctest::Approx(plan.peak_bytes));
  CHECK(json["disparities"]["last"] == 19);
  CHECK(json["estimated"] == true);
}
