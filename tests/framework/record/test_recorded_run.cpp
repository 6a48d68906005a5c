// SPDX-License-Identifier: Apache-2.0
// Runs that are recorded: what is written, told and returned.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "framework/record/noise.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/recorded_run.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::builtins;
using xgm::testing::contains;
using xgm::testing::kNoisePipeline;
using xgm::testing::kNoiseSize;
using xgm::testing::noise;
using xgm::testing::noise_pipeline;
using xgm::testing::TemporaryFolder;

namespace {

nlohmann::json record_in(const TemporaryFolder& folder) {
  return nlohmann::json::parse(read_file(folder / "run.json"));
}

bool has(const TemporaryFolder& folder, const std::string& name) {
  return std::filesystem::exists(folder / name);
}

struct Listener : Observer {
  std::vector<std::string> warnings;
  int stages = 0;
  void log(LogLevel level, const StagePlace&, const std::string& text) override {
    if (level == LogLevel::warning) warnings.push_back(text);
  }
  void stage_end(const StagePlace&, const StageStatistics&, const Artifact&) override { ++stages; }
};

}  // namespace

TEST_CASE("record_scene: map, pictures and record, for a program without an observer") {
  const TemporaryFolder folder;
  const RecordedRun result =
      record_scene(noise_pipeline(), noise(9), {.folder = folder.path(), .command_line = {"mine"}});
  CHECK(result.failure.empty());
  CHECK(result.run.maps.forward.disparity(12, 60) == 9);
  CHECK(read_pfm(folder / "disparity.pfm")(12, 60) == 9);
  CHECK(folder.files() == 4);
  const auto record = record_in(folder);
  CHECK(record["command_line"][0] == "mine");
  CHECK(record["pipeline"]["file"] == "shift.yaml");
  CHECK(record["disparities"]["from"] == "noise");
  CHECK(record["stages"].size() == 5);
  CHECK(record["truth"][0]["region"] == "all");
  CHECK(record["warnings"].empty());
}

TEST_CASE("record_scene: a confidence is written, listed, and gone with the next run without one") {
  const TemporaryFolder folder;
  const LoadedPipeline loaded = load_pipeline_text(kNoisePipeline, "shift.yaml", builtins(),
                                                   {{"matcher.confidence", "peak_ratio"}});
  REQUIRE(loaded.pipeline);
  const RecordedRun result =
      record_scene(*loaded.pipeline, noise(9), {.folder = folder.path(), .report = true});
  const cv::Mat1f sure = read_pfm(folder / "confidence.pfm");
  REQUIRE(sure.size() == kNoiseSize);
  CHECK(sure(12, 60) == result.run.maps.forward.confidence(12, 60));
  CHECK(sure(12, 60) > 0);
  CHECK(record_in(folder)["outputs"].dump().find("confidence.pfm") != std::string::npos);
  CHECK(contains(read_file(folder / "report.html"), "\"confidence\":{"));
  record_scene(noise_pipeline(), noise(9), {.folder = folder.path()});
  CHECK_FALSE(has(folder, "confidence.pfm"));
  CHECK(folder.files() == 4);
}

TEST_CASE("record_in_memory: the same record, and no file") {
  const TemporaryFolder folder;
  const RecordedRun written = record_scene(noise_pipeline(), noise(9), {.folder = folder.path()});
  Listener listener;
  const RecordedRun result =
      record_in_memory(noise_pipeline(), noise(9), {}, {.observer = &listener});
  CHECK(result.failure.empty());
  CHECK(result.run.maps.forward.disparity(12, 60) == 9);
  CHECK(result.record.stages.size() == written.record.stages.size());
  CHECK(listener.stages == static_cast<int>(result.record.stages.size()));
  CHECK(result.record.valid_share == written.record.valid_share);
  CHECK(result.record.peak_memory_bytes > 0);
  CHECK(result.record.outputs.empty());
  CHECK_THROWS_AS(record_in_memory(noise_pipeline(), noise(9), {.report = true}), UsageError);
}

TEST_CASE("record_scene: report, explanations and dumps as far as they are asked for") {
  const TemporaryFolder folder;
  std::vector<std::string> told;
  Listener listener;
  const RecordedRun result =
      record_scene(noise_pipeline(), noise(9),
                   {.folder = folder.path(),
                    .dump = "*.cost",
                    .report = true,
                    .explained = {.pixels = {{60, 12}}},
                    .tell = [&](const std::string& what) { told.push_back(what); }},
                   {.observer = &listener});
  CHECK(has(folder, "report.html"));
  CHECK(has(folder, "explain.json"));
  CHECK(has(folder, "dump/matcher.cost.npy"));
  CHECK(result.record.dumps.size() == 1);
  CHECK(told == std::vector<std::string>{"reading the images", "matching", "writing the results"});
  CHECK(listener.stages == 5);
}

TEST_CASE("record_scene: what looks wrong is in the record, in the result, and told") {
  const TemporaryFolder folder;
  Listener listener;
  const RecordedRun result =
      record_scene(noise_pipeline(), noise(31), {.folder = folder.path(), .dump = "nothing"},
                   {.observer = &listener});
  REQUIRE(listener.warnings.size() >= 2);
  CHECK(contains(listener.warnings.front(), "--dump nothing: no stage has such a path"));
  CHECK(contains(listener.warnings.back(), "lie at 31, where the search range 0 to 31 ends"));
  CHECK(result.record.warnings == listener.warnings);
  CHECK(record_in(folder)["warnings"] == listener.warnings);
}

TEST_CASE("record_scene: an empty map is written, and called a failure") {
  const TemporaryFolder folder;
  SceneRequest request = noise(9);
  std::get<Scene>(request.scene).pair.base.valid = cv::Mat1b(kNoiseSize, 0);
  const RecordedRun result = record_scene(noise_pipeline(), request, {.folder = folder.path()});
  CHECK(contains(result.failure, "the map is empty"));
  CHECK(has(folder, "status.png"));
}

TEST_CASE("record_scene: mistakes leave the folder as it was") {
  const TemporaryFolder folder;
  const std::string output = folder / "output";
  SceneRequest request = noise(9);
  std::get<Scene>(request.scene).disparities.reset();
  CHECK_THROWS_AS(record_scene(noise_pipeline(), request, {.folder = output}), UsageError);
  CHECK_THROWS_AS(record_scene(noise_pipeline(), noise(9),
                               {.folder = output, .depth = {.cloud = folder / "a.ply"}}),
                  UsageError);
  CHECK(folder.files() == 0);
  CHECK_THROWS_AS(record_scene(noise_pipeline(), noise(9),
                               {.folder = output, .explained = {.pixels = {{80, 0}}}}),
                  UsageError);
  CHECK_FALSE(has(folder, "output/run.json"));
}
