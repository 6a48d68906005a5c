// SPDX-License-Identifier: Apache-2.0
// Where the shipped pipelines must stand on real scenes: the ten of Middlebury V3 (training,
// quarter resolution), non-occluded pixels, total error at 1 px, averaged with the benchmark's
// weights.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/io/scene.hpp"

using namespace xgm;

namespace {

struct Score {
  double invalid = 0, average_error = 0;
  std::vector<double> total = std::vector<double>(usual_thresholds().size());
};

Evaluation evaluate_scene(const Pipeline& pipeline, const SceneFiles& files) {
  const Scene scene = load_scene(files);
  const DisparityRange range =
      DisparityRange::uniform(scene.pair.size(), files.disparities.value());
  const DisparityMap map = pipeline.run({scene.pair, range, std::nullopt}).forward;
  const GroundTruth truth = load_truth(files.truth, map.size());
  return evaluate(map, truth.disparity, {.deltas = usual_thresholds()}, truth.non_occluded);
}

// Averages in percent and px; prints the row of the table.
Score average(const std::filesystem::path& data, const std::string& name,
              const std::vector<Override>& overrides = {}) {
  const LoadedPipeline loaded = load_pipeline(XGM_SOURCE_DIR "/pipelines/" + name + ".yaml",
                                              xgm::testing::builtins(), overrides);
  REQUIRE(loaded.pipeline.has_value());
  const std::vector<SceneFiles> scenes =
      find_scenes((data / "stereo/middlebury_v3_trainingQ").string(), xgm::testing::builtins());
  REQUIRE(scenes.size() == 10);
  double weights = 0;
  for (const SceneFiles& scene : scenes) weights += scene.weight;
  REQUIRE(weights == 9);  // PianoL and Playtable count half
  Score score;
  for (const SceneFiles& scene : scenes) {
    const Evaluation result = evaluate_scene(*loaded.pipeline, scene);
    const double share = scene.weight / weights;
    score.invalid += 100 * share * result.invalid;
    score.average_error += share * result.average_error;
    for (std::size_t i = 0; i < score.total.size(); ++i) {
      score.total[i] += 100 * share * result.at[i].total;
    }
  }
  MESSAGE(name, overrides.empty() ? "" : " " + overrides[0].value, ": invalid ", score.invalid,
          " %, average error ", score.average_error,
          " px, total error at 0.5/1/2/4 px: ", score.total[0], " ", score.total[1], " ",
          score.total[2], " ", score.total[3]);
  return score;
}

/// The numbers in the row of a pipeline in the first table of docs/accuracy.md.
std::vector<double> told(const std::string& name) {
  std::ifstream file(XGM_SOURCE_DIR "/docs/accuracy.md");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("| " + name + " |")) continue;
    std::vector<double> numbers;
    std::istringstream cells(line.substr(name.size() + 4));
    for (std::string cell; std::getline(cells, cell, '|');) {
      cell.erase(std::remove(cell.begin(), cell.end(), '*'), cell.end());
      numbers.push_back(std::stod(cell));
    }
    return numbers;
  }
  return {};
}

/// The row has average error, invalid, and then bad and total of each threshold.
void check_told(const std::string& name, const Score& score) {
  constexpr double kOtherCompilers = 0.05;
  const std::vector<double> row = told(name);
  REQUIRE(row.size() == 2 + 2 * score.total.size());
  CHECK(std::abs(row[0] - score.average_error) < kOtherCompilers);
  CHECK(std::abs(row[1] - score.invalid) < kOtherCompilers);
  for (std::size_t i = 0; i < score.total.size(); ++i) {
    CHECK(std::abs(row[3 + 2 * i] - score.total[i]) < kOtherCompilers);
  }
}

// The best that others reach on these scenes by the same rules: mgm, MGM with 8 directions, V-fit,
// median and left-right check.
constexpr double kBestPeerAtHalf = 20.60, kBestPeerAtOne = 13.71;

}  // namespace

TEST_CASE("sgm8 is no worse than StereoSGBM in any mode; tmgm16_refined is a quarter better") {
  const auto data = xgm::testing::test_data("accuracy on Middlebury scenes");
  if (!data) return;
  REQUIRE(usual_thresholds() == std::vector{0.5, 1.0, 2.0, 4.0});
  const double sgm8 = average(*data, "sgm8").total[1];
  for (const std::string mode : {"sgbm", "hh", "sgbm_3way", "hh4"}) {
    CHECK(sgm8 <= average(*data, "opencv_sgbm", {{"matcher.mode", mode}}).total[1]);
  }
  const Score refined = average(*data, "tmgm16_refined");
  CHECK(refined.total[1] <= 0.75 * sgm8);
  CHECK(refined.total[0] < kBestPeerAtHalf);
  CHECK(refined.total[1] < kBestPeerAtOne);
  check_told("tmgm16_refined", refined);
}

TEST_CASE("tmgm16_best is as accurate as docs/accuracy.md says, an eighth better than refined") {
  const auto data = xgm::testing::test_data("accuracy of tmgm16_best on Middlebury scenes");
  if (!data) return;
  const Score best = average(*data, "tmgm16_best");
  check_told("tmgm16_best", best);
  const std::vector<double> refined = told("tmgm16_refined");
  REQUIRE(refined.size() == 10);
  for (std::size_t i = 0; i < 3; ++i) CHECK(best.total[i] < 0.875 * refined[3 + 2 * i]);
}

TEST_CASE("fusion_best is as accurate as docs/accuracy.md says, more so than tmgm16_best") {
  const auto data = xgm::testing::test_data("accuracy of fusion_best on Middlebury scenes");
  if (!data) return;
  const Score fused = average(*data, "fusion_best");
  check_told("fusion_best", fused);
  const std::vector<double> best = told("tmgm16_best");
  REQUIRE(best.size() == 10);
  for (std::size_t i = 0; i < 3; ++i) CHECK(fused.total[i] < best[3 + 2 * i]);
}
