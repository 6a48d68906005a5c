// SPDX-License-Identifier: Apache-2.0
// Makes a large scene of a small one: 6 megapixel pairs with known ranges, and of these pairs of
// any size, from what is at hand.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
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

cv::Size size_of(const std::string& text) {
  cv::Size size;
  if (std::sscanf(text.c_str(), "%dx%d", &size.width, &size.height) == 2 && !size.empty()) {
    return size;
  }
  throw Error("a size is WIDTHxHEIGHT, for example 2964x1988, not " + text);
}

/// Grey, side by side and mirrored downwards: what lies in one row keeps its disparities.
cv::Mat1b covering(const cv::Mat3b& image, cv::Size size) {
  cv::Mat grey, wide, all;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::copyMakeBorder(grey, wide, 0, 0, 0, size.width - grey.cols, cv::BORDER_WRAP);
  cv::copyMakeBorder(wide, all, 0, size.height - wide.rows, 0, 0, cv::BORDER_REFLECT);
  return all;
}

void write_view(const std::filesystem::path& file, const Image& image, cv::Size size,
                cv::Size covered) {
  const cv::Mat3b view = enlarged(image, size);
  if (covered == size) return write_png(file.string() + ".png", view);
  constexpr int kUncompressed = 1;
  cv::imwrite(file.string() + ".tif", covering(view, covered),
              {cv::IMWRITE_TIFF_COMPRESSION, kUncompressed});
}

int enlarge(const std::string& scene_folder, cv::Size size, int disparities,
            const std::filesystem::path& output, cv::Size covered) {
  if (covered.width < size.width || covered.height < size.height) {
    throw Error("the size that is covered is smaller than that of the images");
  }
  const Scene scene = load_scene(find_scene(scene_folder, Registry::with_builtins()));
  std::filesystem::create_directories(output);
  write_view(output / "im0", scene.pair.base, size, covered);
  write_view(output / "im1", scene.pair.match, size, covered);
  write_file((output / "calib.txt").string(), "ndisp=" + std::to_string(disparities) + "\n");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int disparities = argc == 5 || argc == 6 ? std::atoi(argv[3]) : 0;
  if (disparities < 1) {
    std::cerr << "usage: xgm_bench_enlarge SCENE_DIR WIDTHxHEIGHT DISPARITIES OUTPUT_DIR "
                 "[COVERED_WIDTHxHEIGHT]\n"
                 "Writes the scene's images in this size, and how many disparities to search; in "
                 "grey, and repeated until they cover the last size, if that is given.\n";
    return 2;
  }
  try {
    const cv::Size size = size_of(argv[2]);
    return enlarge(argv[1], size, disparities, argv[4], argc == 6 ? size_of(argv[5]) : size);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
