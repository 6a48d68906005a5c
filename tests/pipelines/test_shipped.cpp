// SPDX-License-Identifier: Apache-2.0
// Every shipped pipeline is sound, says what it is, and finds the truth of a generated scene.
#include <algorithm>
#include <array>
#include <fstream>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;

namespace {

std::vector<std::filesystem::path> shipped() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(XGM_SOURCE_DIR "/pipelines")) {
    if (entry.is_regular_file()) files.push_back(entry.path());  // others: tests/geo
  }
  std::sort(files.begin(), files.end());
  return files;
}

Pipeline load(const std::filesystem::path& file) {
  LoadedPipeline loaded = load_pipeline(file.string(), xgm::testing::builtins());
  for (const Diagnostic& d : loaded.diagnostics) MESSAGE(to_string(d));
  REQUIRE(loaded.pipeline.has_value());
  return *loaded.pipeline;
}

}  // namespace

TEST_CASE("the pipelines of the paper, the refined one, the best ones and the peer are shipped") {
  std::vector<std::string> names;
  for (const auto& file : shipped()) names.push_back(file.filename().string());
  CHECK(names == std::vector<std::string>{"fusion_best.yaml", "mgm16.yaml", "mgm8.yaml",
                                          "opencv_sgbm.yaml", "sgm16.yaml", "sgm8.yaml",
                                          "tmgm16.yaml", "tmgm16_best.yaml", "tmgm16_refined.yaml",
                                          "tmgm8.yaml", "tsgm16.yaml", "tsgm8.yaml",
                                          "tsgm8_rothermel.yaml"});
}

TEST_CASE("each begins with a comment: what it is, for whom, what it costs, where it comes from") {
  for (const auto& file : shipped()) {
    std::ifstream stream(file);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    CHECK_MESSAGE(text.starts_with("# "), file.string());
    for (const std::string part : {"# What: ", "# For whom: ", "# Cost: ", "# Source: "}) {
      CHECK_MESSAGE(text.find("\n" + part) != std::string::npos, file.string(), part);
    }
  }
}

TEST_CASE("each finds at least 85 % of a generated scene's visible pixels within 1 px") {
  const xgm::testing::SyntheticScene scene = xgm::synthesis::sample_pair();
  for (const auto& file : shipped()) {
    const MatchRequest request{
        scene.pair, DisparityRange::uniform(scene.pair.size(), scene.disparities), std::nullopt};
    const MatchResult result = load(file).run(request);
    const Evaluation score =
        evaluate(result.forward, scene.truth, {.deltas = {1.0}}, scene.non_occluded);
    MESSAGE(file.filename().string(), ": invalid ", 100 * score.invalid, " %, total error at 1 px ",
            100 * score.at[0].total, " %");
    CHECK_MESSAGE(score.at[0].total < 0.15, file.string());
  }
}
