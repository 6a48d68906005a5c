// SPDX-License-Identifier: Apache-2.0
// The figures of evaluate() equal those of an independent evaluation on real scenes, for all pixels
// and for the non-occluded ones. The other one is written as plainly as the rules: pixels without a
// truth are skipped, masks count where they are 255, disparities are clipped first if that is asked
// for, an error is bad if it is larger than the threshold. It reads PFM by itself, too.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

struct Scene {
  std::string folder, truth, mask;
  int divisor;  ///< of a PNG truth; 0 = PFM
  int disparities;
};

/// One number per pixel, from the top row on.
struct Pixels {
  int width = 0, height = 0;
  std::vector<double> values;
};

/// "Pf\n<width> <height>\n<-1.0>\n", then little-endian floats, the bottom row first.
Pixels plain_pfm(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string magic;
  double order = 0;
  Pixels pixels;
  stream >> magic >> pixels.width >> pixels.height >> order;
  stream.get();
  REQUIRE(magic == "Pf");
  REQUIRE(order < 0);
  const auto width = static_cast<std::size_t>(pixels.width);
  const auto height = static_cast<std::size_t>(pixels.height);
  pixels.values.resize(width * height);
  for (std::size_t y = height; y-- > 0;) {
    for (std::size_t x = 0; x < width; ++x) {
      float value = 0;
      stream.read(reinterpret_cast<char*>(&value), sizeof value);
      pixels.values[y * width + x] = value;
    }
  }
  REQUIRE(stream.good());
  return pixels;
}

/// An 8-bit image; `none` in place of 0.
Pixels plain_image(const std::string& file, double divisor, double none) {
  const cv::Mat1b image = cv::imread(file, cv::IMREAD_GRAYSCALE);
  REQUIRE_FALSE(image.empty());
  Pixels pixels{image.cols, image.rows, {}};
  for (const uchar value : image) pixels.values.push_back(value == 0 ? none : value / divisor);
  return pixels;
}

struct Rules {
  double delta, scale;
  bool clip;
  double clip_low, clip_high;
};

struct Figures {
  double judged = 0, invalid = 0, bad = 0, d1 = 0, sum = 0, squares = 0;
  std::vector<double> errors;

  double a(double share) const {  // of sorted errors
    const auto count = static_cast<double>(errors.size());
    return errors[static_cast<std::size_t>(std::ceil(share * count)) - 1];
  }
};

Figures plain_evaluation(const Pixels& map, const Pixels& truth, const std::vector<double>& mask,
                         const Rules& rules) {
  Figures figures;
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    if (std::isinf(truth.values[i])) continue;
    if (!mask.empty() && mask[i] != 255) continue;
    figures.judged += 1;
    if (std::isinf(map.values[i])) {
      figures.invalid += 1;
      figures.d1 += 1;
      continue;
    }
    double d = map.values[i];
    if (rules.clip && d < rules.clip_low) d = rules.clip_low;
    if (rules.clip && d > rules.clip_high) d = rules.clip_high;
    const double error = std::fabs(d - truth.values[i]) * rules.scale;
    if (error > rules.delta) figures.bad += 1;
    if (error > 3 && std::fabs(d - truth.values[i]) > 0.05 * truth.values[i]) figures.d1 += 1;
    figures.sum += error;
    figures.squares += error * error;
    figures.errors.push_back(error);
  }
  std::sort(figures.errors.begin(), figures.errors.end());
  return figures;
}

DisparityMap match(const std::filesystem::path& folder, int disparities) {
  const ImagePair pair =
      read_pair({(folder / "im0.png").string(), (folder / "im1.png").string(), "", ""}).pair;
  const DisparityRange range = DisparityRange::uniform(pair.size(), {0, disparities});
  return stage<Matcher>("{type: opencv_sgbm, mode: hh4}")
      ->run({pair, range, {}}, Context{})
      .forward;
}

/// 0.01 %, and nothing for a figure of 0.
void check_equal(double ours, double plain) { CHECK(std::fabs(ours - plain) <= 1e-4 * plain); }

void compare(const DisparityMap& map, const GroundTruth& truth, const cv::Mat1b& mask,
             const Pixels& plain_map, const Pixels& plain_truth,
             const std::vector<double>& plain_mask, int disparities) {
  for (const double scale : {1.0, 4.0}) {
    for (const bool clip : {false, true}) {
      // A bound that many disparities exceed.
      const int low = disparities / 4, high = disparities / 2;
      EvaluationRules rules{.deltas = {0.5, 1, 2, 4}, .scale = scale};
      if (clip) rules.clip = {low, high + 1};
      const Evaluation ours = evaluate(map, truth.disparity, rules, mask);
      for (const ThresholdScore& score : ours.at) {
        const Figures plain =
            plain_evaluation(plain_map, plain_truth, plain_mask,
                             {score.delta, scale, clip, double(low), double(high)});
        const auto compared = static_cast<double>(plain.errors.size());
        CHECK(static_cast<double>(ours.judged) == plain.judged);
        check_equal(ours.invalid, plain.invalid / plain.judged);
        check_equal(score.bad, plain.bad / plain.judged);
        check_equal(score.total, (plain.bad + plain.invalid) / plain.judged);
        CHECK(score.total == ours.invalid + score.bad);
        check_equal(ours.average_error, plain.sum / compared);
        check_equal(ours.rms, std::sqrt(plain.squares / compared));
        check_equal(ours.d1, plain.d1 / plain.judged);
        check_equal(ours.a50, plain.a(.50));
        check_equal(ours.a90, plain.a(.90));
        check_equal(ours.a95, plain.a(.95));
        check_equal(ours.a99, plain.a(.99));
      }
    }
  }
}

}  // namespace

TEST_CASE("six scenes, both masks: figures equal those of an independent evaluation to 0.01 %") {
  const auto data = test_data("comparison with an independent evaluation");
  if (!data) return;
  const std::vector<Scene> scenes{
      {"middlebury_v3_trainingQ/Motorcycle", "disp0GT.pfm", "mask0nocc.png", 0, 70},
      {"middlebury_v3_trainingQ/Piano", "disp0GT.pfm", "mask0nocc.png", 0, 65},
      {"middlebury_v3_trainingQ/Teddy", "disp0GT.pfm", "mask0nocc.png", 0, 64},
      {"middlebury_v3_trainingQ/Pipes", "disp0GT.pfm", "mask0nocc.png", 0, 75},
      {"middlebury_v2/cones", "disp0GT.png", "mask0nocc.png", 4, 64},
      {"middlebury_2005_2006_third/Art", "disp0GT.png", "mask0nocc_derived.png", 3, 80},
  };
  const TemporaryFolder scratch;
  for (const Scene& scene : scenes) {
    CAPTURE(scene.folder);
    const auto folder = *data / "stereo" / scene.folder;
    const std::string truth_file = (folder / scene.truth).string();
    const std::string mask_file = (folder / scene.mask).string();
    const DisparityMap map = match(folder, scene.disparities);
    write_pfm(scratch / "map.pfm", map.disparity);
    const Pixels plain_map = plain_pfm(scratch / "map.pfm");
    const Pixels plain_truth = scene.divisor == 0
                                   ? plain_pfm(truth_file)
                                   : plain_image(truth_file, scene.divisor, INFINITY);
    const Pixels plain_mask = plain_image(mask_file, 1, 0);
    REQUIRE(plain_map.values.size() == plain_truth.values.size());
    REQUIRE(plain_map.values.size() == plain_mask.values.size());

    GroundTruth truth;
    truth.disparity = scene.divisor == 0 ? read_disparities(truth_file).value
                                         : read_disparities(truth_file, scene.divisor).value;
    truth.non_occluded = read_mask(mask_file, MaskUse::judged).value;
    compare(map, truth, {}, plain_map, plain_truth, {}, scene.disparities);
    compare(map, truth, truth.non_occluded, plain_map, plain_truth, plain_mask.values,
            scene.disparities);
  }
}
