// SPDX-License-Identifier: Apache-2.0
// A scene at a fraction of its size, with its truth: how results depend on the size of images.
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/io/scene.hpp"

namespace {

using namespace xgm;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Left pixels whose point the right image shows, 255, by the truth of the left view alone: no
/// nearer surface projects to the same right pixel. 128: hidden, or outside of the right image.
cv::Mat1b visible(const cv::Mat1f& truth) {
  cv::Mat1b mask(truth.size(), std::uint8_t{0});
  for (int y = 0; y < truth.rows; ++y) {
    std::vector<float> nearest(static_cast<std::size_t>(truth.cols), 0.0F);
    const auto there = [&](int x) { return cvRound(static_cast<float>(x) - truth(y, x)); };
    for (int x = 0; x < truth.cols; ++x) {
      if (!std::isfinite(truth(y, x)) || there(x) < 0 || there(x) >= truth.cols) continue;
      float& most = nearest[static_cast<std::size_t>(there(x))];
      most = std::max(most, truth(y, x));
    }
    for (int x = 0; x < truth.cols; ++x) {
      if (!std::isfinite(truth(y, x))) continue;
      const bool inside = there(x) >= 0 && there(x) < truth.cols;
      // A slanted surface may put several of its own pixels onto one: they are within 1 px.
      const bool seen = inside && truth(y, x) > nearest[static_cast<std::size_t>(there(x))] - 1.0F;
      mask(y, x) = seen ? kJudged : 128;
    }
  }
  return mask;
}

/// The pixels of the full size that one small pixel covers.
struct Block {
  float lowest = std::numeric_limits<float>::infinity(), highest = -lowest, sum = 0;
  bool known = true, seen = true;
};

Block block_of(const GroundTruth& truth, cv::Rect pixels) {
  Block block;
  for (int y = pixels.y; y < pixels.br().y; ++y) {
    for (int x = pixels.x; x < pixels.br().x; ++x) {
      const float disparity = truth.disparity(y, x);
      block.known = block.known && std::isfinite(disparity);
      block.seen = block.seen && truth.non_occluded(y, x) == kJudged;
      block.lowest = std::min(block.lowest, disparity);
      block.highest = std::max(block.highest, disparity);
      block.sum += disparity;
    }
  }
  return block;
}

/// The mean of each block, where all of it is known and differs by at most one pixel of the small
/// size: a block on a depth edge has two disparities, and none that a map could be judged by.
void shrink_truth(const GroundTruth& truth, int factor, cv::Size size, cv::Mat1f& disparity,
                  cv::Mat1b& mask) {
  disparity = cv::Mat1f(size, kNone);
  mask = cv::Mat1b(size, std::uint8_t{0});
  const auto scale = static_cast<float>(factor);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Block block = block_of(truth, {x * factor, y * factor, factor, factor});
      if (!block.known || block.highest - block.lowest > scale) continue;
      disparity(y, x) = block.sum / (scale * scale) / scale;
      mask(y, x) = block.seen ? kJudged : 128;
    }
  }
}

cv::Mat3b shrunk(const Image& image, int factor, cv::Size size) {
  const cv::Mat3b whole = picture(image)(cv::Rect({}, size * factor));
  cv::Mat3b small;
  cv::resize(whole, small, size, 0, 0, cv::INTER_AREA);
  return small;
}

int shrink(const std::string& scene_folder, int factor, const std::filesystem::path& output) {
  const SceneFiles files = find_scene(scene_folder, Registry::with_builtins());
  const Scene scene = load_scene(files);
  GroundTruth truth = load_truth(files.truth, scene.size());
  require_judgeable(truth);
  if (!scene.disparities) throw Error(scene_folder + ": the disparities to search are not known");
  if (truth.non_occluded.empty()) truth.non_occluded = visible(truth.disparity);
  const cv::Size size = scene.size() / factor;
  std::filesystem::create_directories(output);
  write_png(output / "im0.png", shrunk(scene.pair.base, factor, size));
  write_png(output / "im1.png", shrunk(scene.pair.match, factor, size));
  cv::Mat1f disparity;
  cv::Mat1b mask;
  shrink_truth(truth, factor, size, disparity, mask);
  write_pfm(output / "disp0GT.pfm", disparity);
  write_png(output / "mask0nocc.png", mask);
  const int most = (scene.disparities->end - 1 + factor - 1) / factor;
  write_file((output / "calib.txt").string(), "ndisp=" + std::to_string(most + 1) + "\n");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int factor = argc == 4 ? std::atoi(argv[2]) : 0;
  if (factor < 1) {
    std::cerr << "usage: xgm_bench_shrink SCENE_DIR FACTOR OUTPUT_DIR\n"
                 "Writes the scene FACTOR times smaller: means of the images; the truth where all "
                 "of a pixel has nearly one disparity; what the right image hides.\n";
    return 2;
  }
  try {
    return shrink(argv[1], factor, argv[3]);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
