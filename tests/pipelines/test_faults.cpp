// SPDX-License-Identifier: Apache-2.0
// What is planted in generated scenes hurts matching, and what alignment of rows is worth.
#include <cmath>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/synthesis/generate.hpp"

using namespace xgm;

namespace {

Pipeline load(const std::string& name, const std::vector<Override>& overrides = {}) {
  const LoadedPipeline loaded = load_pipeline(XGM_SOURCE_DIR "/pipelines/" + name + ".yaml",
                                              xgm::testing::builtins(), overrides);
  for (const Diagnostic& d : loaded.diagnostics) MESSAGE(to_string(d));
  REQUIRE(loaded.pipeline.has_value());
  return *loaded.pipeline;
}

/// Share of the visible pixels without a disparity, or more than 1 px off.
double total_error(const Pipeline& pipeline, const synthesis::GeneratedScene& scene) {
  const MatchRequest request{
      scene.pair, DisparityRange::uniform(scene.pair.size(), scene.disparities), std::nullopt};
  const MatchResult result = pipeline.run(request);
  return evaluate(result.forward, scene.truth, {.deltas = {1.0}}, scene.non_occluded).at[0].total;
}

}  // namespace

TEST_CASE("each fault, as strong as it is if nothing is said, hurts sgm8") {
  const Pipeline sgm8 = load("sgm8");
  for (const std::uint64_t seed : {11u, 12u}) {
    synthesis::Options options;
    options.size = {320, 240};
    options.disparities = {0, 32};
    options.seed = seed;
    const double clean = total_error(sgm8, synthesis::generate(options));
    CHECK(clean < 0.15);
    for (const synthesis::FaultKind& kind : synthesis::fault_kinds()) {
      options.faults = {};
      plant(options.faults, kind.name);
      const double faulty = total_error(sgm8, synthesis::generate(options));
      MESSAGE("seed ", seed, ", ", kind.name, ": total error at 1 px ", 100 * clean, " % -> ",
              100 * faulty, " %");
      CHECK_MESSAGE(faulty > 1.15 * clean, kind.name);
    }
  }
}

TEST_CASE("rows shifted by 0.01 y + 1.3 ruin matching, and ransac_deskew mends nearly all of it") {
  synthesis::Options options;
  options.seed = 21;
  const synthesis::GeneratedScene aligned = synthesis::generate(options);
  synthesis::plant(options.faults, "vertical=0,0.01,1.3");
  const synthesis::GeneratedScene shifted = synthesis::generate(options);
  for (const std::string name : {"sgm8", "tmgm16_refined"}) {
    const Pipeline without = load(name, {{"preprocess", "[]"}});
    const Pipeline with = load(name, {{"preprocess", "[ransac_deskew]"}});
    const double best = total_error(without, aligned);
    const double shifted_without = total_error(without, shifted);
    const double shifted_with = total_error(with, shifted);
    MESSAGE(name, ": total error at 1 px ", 100 * best, " % aligned, ", 100 * shifted_without,
            " % shifted, ", 100 * shifted_with, " % shifted and deskewed");
    CHECK(shifted_without > 0.3);
    CHECK(shifted_with < best + 0.02);
  }
}
