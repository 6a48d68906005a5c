// SPDX-License-Identifier: Apache-2.0
// Which cells a bench runs, with runs that are faked.
#include <doctest/doctest.h>

#include <filesystem>
#include <limits>

#include "support/temporary_folder.hpp"
#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::TemporaryFolder;

namespace {

constexpr float kTruth = 5;

/// Two pipelines on two scenes of 4 x 2 pixels; runs take the disparity 5 or 6 for all.
struct Bench {
  Bench() {
    request.output = folder / "out";
    request.threads = 2;
    request.pipelines = {
        {.name = "good", .file = "good.yaml", .overrides = {}, .resolved = R"({"p1": 4})"},
        {.name = "bad", .file = "bad.yaml", .overrides = {}, .resolved = R"({"p1": 9})"}};
    for (const std::string name : {"one", "two"}) {
      BenchScene& scene = request.scenes.emplace_back();
      scene.set = "set";
      scene.files.name = name;
      scene.files.disparities = Interval{0, 8};
      scene.files.images.left = folder.write(name + "0.png", "left of " + name);
      scene.files.images.right = folder.write(name + "1.png", "right of " + name);
      scene.files.truth.disparity.file = folder / (name + ".pfm");
      write_pfm(scene.files.truth.disparity.file, cv::Mat1f(2, 4, kTruth));
    }
    identify_images(request.scenes);
  }

  RunOutcome fake(const BenchPipeline& pipeline, const BenchScene& scene,
                  const std::string& where) {
    runs.push_back(pipeline.name + " " + scene.files.name);
    if (runs.size() == interrupt_at) return {.interrupted = true, .failure = {}};
    if (scene.files.name == broken) return {.interrupted = false, .failure = "is broken"};
    if (scene.files.name == silent) return {};
    cv::Mat1f map(2, 4, pipeline.name == "good" ? kTruth : kTruth + 1.5F);
    map(0, 0) = std::numeric_limits<float>::quiet_NaN();
    write_pfm((std::filesystem::path(where) / "disparity.pfm").string(), map);
    RunRecord record;
    record.resolved_pipeline = pipeline.resolved;
    record.size = {4, 2};
    record.disparities = {0, 8};
    record.matching_seconds = 0.5;
    record.peak_memory_bytes = 1000;
    record.valid_share = 7. / 8;
    const bool spoils = !spoilt.empty() && scene.files.name == "one";
    write_file((std::filesystem::path(where) / "run.json").string(),
               spoils ? spoilt : to_json(record));
    return {};
  }

  BenchResult run() {
    runs.clear();
    return run_bench(request, rules, {.run = [this](const auto&... all) { return fake(all...); }});
  }

  TemporaryFolder folder;
  BenchRequest request;
  BenchRules rules;
  std::vector<std::string> runs;
  std::size_t interrupt_at = 0;
  std::string broken, silent;
  std::string spoilt;  ///< what run.json holds of the scene "one", if not its record
};

const std::vector<std::string> kAll{"good one", "bad one", "good two", "bad two"};
const std::vector<std::string> kNone;

}  // namespace

TEST_CASE("every pipeline runs on every scene, and its map is judged by the truth") {
  Bench bench;
  const BenchResult result = bench.run();
  CHECK(bench.runs == kAll);
  const BenchCell& cell = result.at(1, 0);
  CHECK(cell.state == CellState::done);
  CHECK(cell.evaluations == 4 * 2 * 8);
  CHECK(cell.seconds == 0.5);
  const Evaluation* evaluation = judged(cell, result.rules);
  REQUIRE(evaluation != nullptr);
  CHECK(evaluation->judged == 8);
  CHECK(evaluation->invalid == 1. / 8);
  CHECK(evaluation->average_error == doctest::Approx(1.5));
  CHECK(evaluation->at[1].bad == 7. / 8);  // 1 px
  CHECK(evaluation->at[2].bad == 0);       // 2 px
}

TEST_CASE("a bench started again runs nothing, and gives the same tables") {
  Bench bench;
  const std::string first = bench_json(bench.run());
  CHECK(bench_json(bench.run()) == first);
  CHECK(bench.runs == kNone);
}

TEST_CASE("other thresholds, another scale and another truth need no run") {
  Bench bench;
  bench.run();
  bench.rules.scale = 4;
  bench.rules.thresholds = {5, 7};
  BenchResult result = bench.run();
  CHECK(bench.runs == kNone);
  CHECK(judged(result.at(1, 0), result.rules)->at[0].bad == 7. / 8);  // 6 > 5
  CHECK(judged(result.at(1, 0), result.rules)->at[1].bad == 0);
  write_pfm(bench.request.scenes[0].files.truth.disparity.file, cv::Mat1f(2, 4, kTruth + 1.5F));
  result = bench.run();
  CHECK(bench.runs == kNone);
  CHECK(judged(result.at(1, 0), result.rules)->average_error == 0);
}

TEST_CASE("the scale may be that of each scene, and maps may be clipped to its range") {
  Bench bench;
  bench.rules = {.thresholds = {1}, .scale = 0, .clip = true, .region = {}};
  bench.request.scenes[0].files.scale = 4;
  bench.request.scenes[1].files.disparities = Interval{0, 6};  // ndisp 6 moves 6.5 to 6
  const BenchResult result = bench.run();
  CHECK(judged(result.at(1, 0), result.rules)->average_error == doctest::Approx(4 * 1.5));
  CHECK(judged(result.at(1, 1), result.rules)->average_error == doctest::Approx(1));
}

TEST_CASE("what has changed is run again, and nothing else") {
  Bench bench;
  bench.run();
  SUBCASE("a parameter of a pipeline") {
    bench.request.pipelines[1].resolved = R"({"p1": 10})";
    bench.run();
    CHECK(bench.runs == std::vector<std::string>{"bad one", "bad two"});
  }
  SUBCASE("an image") {
    bench.folder.write("two1.png", "something else");
    identify_images(bench.request.scenes);
    bench.run();
    CHECK(bench.runs == std::vector<std::string>{"good two", "bad two"});
  }
  SUBCASE("a mask") {
    bench.request.scenes[0].files.images.left_mask = bench.folder.write("mask.png", "mask");
    identify_images(bench.request.scenes);
    bench.run();
    CHECK(bench.runs == std::vector<std::string>{"good one", "bad one"});
  }
  SUBCASE("the disparities searched") {
    bench.request.scenes[0].files.disparities = Interval{0, 9};
    bench.run();
    CHECK(bench.runs == std::vector<std::string>{"good one", "bad one"});
  }
  SUBCASE("the program") {
    bench.request.program = {{.bytes = 1, .fnv1a64 = "another"}};
    bench.run();
    CHECK(bench.runs == kAll);
  }
  SUBCASE("the threads: seconds of one table are comparable") {
    bench.request.threads = 1;
    bench.run();
    CHECK(bench.runs == kAll);
  }
  SUBCASE("a result that somebody wrote over") {
    bench.folder.write("out/good/set/one/run.json", "{}");
    bench.run();
    CHECK(bench.runs == std::vector<std::string>{"good one"});
  }
  SUBCASE("a map that is missing") {
    std::filesystem::remove(bench.folder / "out/bad/set/two/disparity.pfm");
    bench.run();
    CHECK(bench.runs == std::vector<std::string>{"bad two"});
  }
  SUBCASE("a mark that was cut short") {
    bench.folder.write("out/bad/set/one/cell.json", "{\"identity\": ");
    bench.run();
    CHECK(bench.runs == std::vector<std::string>{"bad one"});
  }
}

TEST_CASE("a run that left no record is a failed cell, and the others go on") {
  Bench bench;
  bench.silent = "one";
  const BenchResult result = bench.run();
  CHECK(bench.runs == kAll);
  CHECK(result.at(0, 0).state == CellState::failed);
  CHECK(contains(result.at(0, 0).failure, "run.json"));
  CHECK(result.at(1, 1).state == CellState::done);
}

TEST_CASE("a record that is none, or has figures that no run has, fails its cell by name") {
  const std::string figures = R"({"seconds": {"matching": 1}, "peak_memory_bytes": 1, )"
                              R"("valid_share": 1, "disparities": {"first": 0, "last": 1}, )";
  for (const std::string& text :
       {std::string("{"), std::string("[]"), std::string(100'000, '['), figures + "}",
        figures + R"("scene": {"width": -4, "height": 2}})",
        figures + R"("scene": {"width": 1e300, "height": 1e300}})"}) {
    CAPTURE(text.substr(0, 200));
    Bench bench;
    bench.spoilt = text;
    const BenchResult result = bench.run();
    CHECK(result.at(0, 0).state == CellState::failed);
    CHECK_MESSAGE(contains(result.at(0, 0).failure, "one/run.json: is no record of a run ("),
                  result.at(0, 0).failure);
    CHECK(result.at(0, 1).state == CellState::done);
  }
}

TEST_CASE("an interrupted bench keeps what is done, and goes on from there") {
  Bench bench;
  bench.interrupt_at = 3;
  BenchResult result = bench.run();
  CHECK(result.interrupted);
  CHECK(result.at(1, 0).state == CellState::done);
  CHECK(result.at(0, 1).state == CellState::not_run);
  bench.interrupt_at = 0;
  result = bench.run();
  CHECK(bench.runs == std::vector<std::string>{"good two", "bad two"});
  CHECK_FALSE(result.interrupted);
  CHECK(result.at(1, 1).state == CellState::done);
}

TEST_CASE("what later cells had is judged after an interruption, too") {
  Bench bench;
  bench.run();
  bench.request.pipelines[0].resolved = "{}";
  bench.interrupt_at = 1;
  const BenchResult result = bench.run();
  CHECK(bench.runs.size() == 1);
  CHECK(result.at(0, 0).state == CellState::not_run);
  CHECK(result.at(1, 1).state == CellState::done);
}

TEST_CASE("a failing cell does not end the bench, and is tried again") {
  Bench bench;
  bench.broken = "one";
  BenchResult result = bench.run();
  CHECK(bench.runs == kAll);
  CHECK(result.failures() == 2);
  CHECK(result.at(0, 0).failure == "is broken");
  CHECK(result.at(0, 1).state == CellState::done);
  bench.broken.clear();
  result = bench.run();
  CHECK(bench.runs == std::vector<std::string>{"good one", "bad one"});
  CHECK(result.failures() == 0);
}

TEST_CASE("a truth that cannot be read fails the cells of its scene, not the bench") {
  Bench bench;
  bench.folder.write("two.pfm", "Pf\n4 2\n-1\n short");
  const BenchResult result = bench.run();
  CHECK(result.failures() == 2);
  CHECK(contains(result.at(0, 1).failure, "two.pfm"));
  CHECK(result.at(0, 0).state == CellState::done);
}

TEST_CASE("scenes without truth have seconds, memory and density") {
  Bench bench;
  for (BenchScene& scene : bench.request.scenes) scene.files.truth = {};
  const BenchResult result = bench.run();
  CHECK(result.failures() == 0);
  CHECK(result.at(0, 0).density == 7. / 8);
  CHECK(result.at(0, 0).regions.empty());
  CHECK(contains(bench_text(result), "87.50"));
}

TEST_CASE("the time left is told once a run has shown how long they take") {
  Bench bench;
  std::vector<double> left;
  run_bench(bench.request, bench.rules,
            {.run = [&](const auto&... all) { return bench.fake(all...); },
             .tell =
                 [&](const BenchProgress& at) {
                   if (at.finished) left.push_back(at.seconds_left);
                   if (!at.finished && at.number == 1) CHECK(at.seconds_left < 0);
                 }});
  REQUIRE(left.size() == 4);
  CHECK(left[0] > 0);
  CHECK(left[3] == 0);
}
