// SPDX-License-Identifier: Apache-2.0
// Where the shipped pipelines must stand on real scenes: the ten of Middlebury V3 (training,
// quarter resolution), non-occluded pixels, total error at 1 px, averaged with the benchmark's
// weights.
#include <array>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "support/support.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/metrics.hpp"

using namespace xgm;

namespace {

const std::vector kDeltas{0.5, 1.0, 2.0, 4.0};
constexpr std::array kScenes{"Adirondack", "Jadeplant", "Motorcycle", "MotorcycleE", "Piano",
                             "PianoL",     "Pipes",     "Playtable",  "Recycle",     "Teddy"};

// Weights of the benchmark's table.
double weight(const std::string& scene) {
  return scene == "PianoL" || scene == "Playtable" ? 0.5 : 1;
}

Evaluation score(const Pipeline& pipeline, const std::filesystem::path& folder) {
  const Scene scene = load_scene(find_scene(folder.string(), xgm::testing::builtins()));
  Observer silent;
  const MatchRequest request{scene.pair,
                             DisparityRange::uniform(scene.pair.size(), scene.disparities.value()),
                             std::nullopt};
  const DisparityMap map = pipeline.run(request, silent).forward;
  const cv::Mat1b mask = cv::imread((folder / "mask0nocc.png").string(), cv::IMREAD_GRAYSCALE);
  return evaluate(map, read_pfm((folder / "disp0GT.pfm").string()), {.deltas = kDeltas}, mask);
}

// Weighted total error at 1 px in percent; prints the row of the table.
double total_error(const std::filesystem::path& data, const std::string& name,
                   const std::vector<Override>& overrides = {}) {
  const LoadedPipeline loaded = load_pipeline(XGM_SOURCE_DIR "/pipelines/" + name + ".yaml",
                                              xgm::testing::builtins(), overrides);
  REQUIRE(loaded.pipeline.has_value());
  double weights = 0, invalid = 0, error = 0;
  std::vector<double> total(kDeltas.size());
  for (const std::string scene : kScenes) {
    const Evaluation result =
        score(*loaded.pipeline, data / "stereo" / "middlebury_v3_trainingQ" / scene);
    const double w = weight(scene);
    weights += w;
    invalid += 100 * w * result.invalid;
    error += w * result.average_error;
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += 100 * w * result.at[i].total;
  }
  MESSAGE(name, overrides.empty() ? "" : " " + overrides[0].value, ": invalid ", invalid / weights,
          " %, average error ", error / weights,
          " px, total error at 0.5/1/2/4 px: ", total[0] / weights, " ", total[1] / weights, " ",
          total[2] / weights, " ", total[3] / weights);
  return total[1] / weights;
}

}  // namespace

TEST_CASE(
    "sgm8 is no worse than StereoSGBM in any mode, and tmgm16_refined a fifth better than sgm8") {
  const auto data = xgm::testing::test_data("accuracy on Middlebury scenes");
  if (!data) return;
  const double sgm8 = total_error(*data, "sgm8");
  for (const std::string mode : {"sgbm", "hh", "sgbm_3way", "hh4"}) {
    CHECK(sgm8 <= total_error(*data, "opencv_sgbm", {{"matcher.mode", mode}}));
  }
  CHECK(total_error(*data, "tmgm16_refined") <= 0.8 * sgm8);
}
