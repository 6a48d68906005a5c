// SPDX-License-Identifier: Apache-2.0
// Makes a large scene of a small one: 6 megapixel pairs with known ranges, from what is at hand.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <opencv2/imgproc.hpp>

#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/scene.hpp"

namespace {

using namespace xgm;

cv::Mat3b enlarged(const Image& image, cv::Size size) {
  cv::Mat3b result;
  cv::resize(picture(image), result, size, 0, 0, cv::INTER_CUBIC);
  return result;
}

int enlarge(const std::string& scene_folder, const std::string& size_text, int disparities,
            const std::filesystem::path& output) {
  cv::Size size;
  if (std::sscanf(size_text.c_str(), "%dx%d", &size.width, &size.height) != 2 || size.empty()) {
    throw Error("the size is WIDTHxHEIGHT, for example 2964x1988, not " + size_text);
  }
  const Scene scene = load_scene(find_scene(scene_folder, Registry::with_builtins()));
  std::filesystem::create_directories(output);
  write_png((output / "im0.png").string(), enlarged(scene.pair.base, size));
  write_png((output / "im1.png").string(), enlarged(scene.pair.match, size));
  write_file((output / "calib.txt").string(), "ndisp=" + std::to_string(disparities) + "\n");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int disparities = argc == 5 ? std::atoi(argv[3]) : 0;
  if (disparities < 1) {
    std::cerr << "usage: xgm_bench_enlarge SCENE_DIR WIDTHxHEIGHT DISPARITIES OUTPUT_DIR\n"
                 "Writes the scene's images in this size, and how many disparities to search.\n";
    return 2;
  }
  try {
    return enlarge(argv[1], argv[2], disparities, argv[4]);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
