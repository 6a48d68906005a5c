// SPDX-License-Identifier: Apache-2.0
// Tuning with runs whose errors are planted: what is chosen, what is run, and what is told of it.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/tune.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

constexpr int kWidth = 20, kHeight = 5, kPixels = kWidth * kHeight;
constexpr const char* kRecord =
    R"({"seconds": {"matching": 1}, "peak_memory_bytes": 1, "valid_share": 1,
        "scene": {"width": 20, "height": 5}, "disparities": {"first": 0, "last": 9}})";

/// Pixels that a pipeline gets wrong on a scene.
using Planted = std::function<int(const BenchPipeline&, const BenchScene&)>;

/// Scenes with a truth, and pipelines p0, p1, ... whose runs are made up.
class Desk {
 public:
  Desk(int pipelines, int scenes, Planted planted) : planted_(std::move(planted)) {
    request.bench.output = folder_ / "out";
    request.bench.threads = 1;
    request.rules.thresholds = {1};
    const std::string truth = folder_ / "truth.pfm";
    write_pfm(truth, cv::Mat1f(kHeight, kWidth, 5.0F));
    for (int i = 0; i < pipelines; ++i) {
      BenchPipeline& pipeline = request.bench.pipelines.emplace_back();
      pipeline.name = "p" + std::to_string(i);
      pipeline.resolved = R"({"matcher": {"type": "p", "value": )" + std::to_string(i) + "}}";
    }
    for (int i = 0; i < scenes; ++i) {
      BenchScene& scene = request.bench.scenes.emplace_back();
      scene.set = "set";
      scene.files.name = "s" + std::to_string(i);
      scene.files.truth.disparity.file = truth;
    }
  }

  TuneResult run() {
    return run_tune(request,
                    {.run = [this](const auto& pipeline, const auto& scene, const auto& folder) {
                      return run_one(pipeline, scene, folder);
                    }});
  }

  TuneRequest request;
  std::multiset<std::string> runs;  ///< "p1 s3"

 private:
  RunOutcome run_one(const BenchPipeline& pipeline, const BenchScene& scene,
                     const std::string& folder) {
    runs.insert(pipeline.name + " " + scene.files.name);
    const int wrong = planted_(pipeline, scene);
    if (wrong < 0) return {.failure = "planted"};
    cv::Mat1f map(kHeight, kWidth, 5.0F);
    for (int i = 0; i < wrong; ++i) map(i / kWidth, i % kWidth) = 9;
    write_pfm(folder + "/disparity.pfm", map);
    std::ofstream(folder + "/run.json") << kRecord;
    return {};
  }

  TemporaryFolder folder_;
  Planted planted_;
};

int number(const BenchPipeline& pipeline) { return std::stoi(pipeline.name.substr(1)); }

}  // namespace

TEST_CASE("tune: the best pipeline is found with the runs planned, none of them twice") {
  Desk desk(8, 10,
            [](const auto& pipeline, const auto&) { return 40 - 5 * (number(pipeline) % 6); });
  const TuneResult result = desk.run();
  CHECK(result.best().pipeline == 5);
  CHECK(result.best().error == doctest::Approx(15.0 / kPixels));
  CHECK(result.start().error == doctest::Approx(40.0 / kPixels));
  CHECK(result.start().scenes == 7);
  CHECK(result.tuning.size() == 7);
  CHECK(result.held_out.size() == 3);
  CHECK(result.runs == runs_of(plan_rungs(8, 7)) + 2 * 3);
  CHECK(desk.runs.size() == result.runs);
  CHECK(std::set(desk.runs.begin(), desk.runs.end()).size() == result.runs);
  CHECK(result.ranking.size() == 8);
}

TEST_CASE("tune: scenes held back are run by the first and the best pipeline only, and decide") {
  std::set<std::string> held;
  Desk desk(6, 10, [&](const auto& pipeline, const auto& scene) {
    const bool is_held = held.contains(scene.files.name);
    return is_held ? 10 + 5 * number(pipeline) : 40 - 5 * number(pipeline);
  });
  {
    Desk scout(6, 10, [](const auto&, const auto&) { return 0; });
    const TuneResult seen = scout.run();
    for (const std::size_t i : seen.held_out) held.insert(seen.request.bench.scenes[i].files.name);
  }
  const TuneResult result = desk.run();
  CHECK(result.best().pipeline == 5);
  CHECK(result.error_before == doctest::Approx(10.0 / kPixels));
  CHECK(result.error_after == doctest::Approx(35.0 / kPixels));
  for (const std::string& run : desk.runs) {
    const bool of_held = held.contains(run.substr(3));
    CHECK_MESSAGE((!of_held || run[1] == '0' || run[1] == '5'), run);
  }
  CHECK(contains(tune_markdown(result), "there the best is no better: keep the pipeline as it is"));
}

TEST_CASE("tune: the seed decides which scenes are held back, and nothing else is left to chance") {
  const auto held = [](std::uint64_t seed) {
    Desk desk(3, 12, [](const auto& pipeline, const auto&) { return number(pipeline); });
    desk.request.seed = seed;
    return desk.run().held_out;
  };
  CHECK(held(1) == held(1));
  CHECK(held(1) != held(2));
}

TEST_CASE("tune: a pipeline that fails comes last, and is told with the reason") {
  Desk desk(3, 2, [](const auto& pipeline, const auto&) {
    return number(pipeline) == 2 ? -1 : 5 + number(pipeline);
  });
  desk.request.held_out = 0;
  const TuneResult result = desk.run();
  CHECK(result.best().pipeline == 0);
  CHECK(result.ranking.back().pipeline == 2);
  const std::string text = tune_markdown(result);
  CHECK(contains(text, "p2 failed on s"));
  CHECK(contains(text, "planted"));
  CHECK(contains(text, "no scene was held back"));
}

TEST_CASE("tune: the files name scenes, figures and the best pipeline") {
  Desk desk(4, 4, [](const auto& pipeline, const auto&) { return 20 - number(pipeline); });
  const TuneResult result = desk.run();
  const auto json = nlohmann::json::parse(tune_json(result));
  CHECK(json["best"]["name"] == "p3");
  CHECK(json["best"]["held_out"].get<double>() == doctest::Approx(0.17));
  CHECK(json["start"]["held_out"].get<double>() == doctest::Approx(0.2));
  CHECK(json["held_out_scenes"].size() == 1);
  CHECK(json["ranking"].size() == 4);
  const std::string yaml = best_yaml(result);
  CHECK(contains(yaml, "matcher: {type: p, value: 3}"));
  CHECK(contains(yaml, "17.00 on those held back (20.00)"));
}

TEST_CASE("tune: a scene without truth is refused before any run") {
  Desk desk(2, 2, [](const auto&, const auto&) { return 0; });
  desk.request.bench.scenes[1].files.truth.disparity.file.clear();
  CHECK(contains(error_of([&] { desk.run(); }), "scene 's1' has no ground truth"));
  CHECK(desk.runs.empty());
}
