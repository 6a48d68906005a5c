// SPDX-License-Identifier: Apache-2.0
// Image files of all formats: as a mask, as disparities, and as both images of a pair.
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "fuzz/support/memory_file.hpp"
#include "fuzz/support/target.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm::fuzz {
namespace {

int big_endian(std::string_view bytes) {
  unsigned value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return static_cast<int>(value);
}

/// The size that a PNG states; nothing of other files.
cv::Size stated_size(std::string_view input) {
  if (!input.starts_with("\x89PNG\r\n\x1a\n") || input.size() < 24) return {};
  return {big_endian(input.substr(16, 4)), big_endian(input.substr(20, 4))};
}

void check_warnings(const std::vector<std::string>& warnings, const std::string& file) {
  for (const std::string& warning : warnings) {
    require(warning.find(file) != std::string::npos, "a warning names the file");
  }
}

void check_pair(const std::string& file, cv::Size size) {
  ReadPair read;
  if (!accepts(file, [&] { read = read_pair({file, file}); })) return;
  check_warnings(read.warnings, file);
  require(read.pair.size() == size, "an image has the size of the file");
  constexpr float kWhite = 255, kRounding = 1e-3F;
  for (const cv::Mat1f& plane : read.pair.base.planes) {
    for (const float level : plane) {
      require(level >= -kRounding && level <= kWhite + kRounding, "grey levels are 0 to 255");
    }
  }
}

void check_disparities(const std::string& file, cv::Size size) {
  constexpr double kKittisDivisor = 256;
  Noted<cv::Mat1f> map;
  if (!accepts(file, [&] { map = read_disparities(file, kKittisDivisor); })) return;
  check_warnings(map.warnings, file);
  require(map.value.size() == size, "a map has the size of the file");
  for (const float value : map.value) require(!std::isinf(value), "no disparity is infinite");
}

}  // namespace

void check(std::string_view input) {
  static MemoryFile file;
  file.hold(input);
  Noted<cv::Mat1b> mask;
  if (!accepts(file.path(), [&] { mask = read_mask(file.path(), MaskUse::judged); })) return;
  check_warnings(mask.warnings, file.path());
  const cv::Size size = mask.value.size(), stated = stated_size(input);
  require(!size.empty(), "an image has pixels");
  require(stated.empty() || stated == size, "an image has the size that its file states");
  check_disparities(file.path(), size);
  check_pair(file.path(), size);
}

std::vector<std::string> seeds() {
  const cv::Mat grey(5, 7, CV_8UC1, cv::Scalar(90)), deep(5, 7, CV_16UC1, cv::Scalar(3000)),
      colour(5, 7, CV_8UC3, cv::Scalar(10, 20, 30)), alpha(5, 7, CV_8UC4, cv::Scalar(1, 2, 3, 0)),
      real(5, 7, CV_32FC1, cv::Scalar(0.5));
  std::vector<std::string> files;
  const auto add = [&](const char* ending, const cv::Mat& image) {
    std::vector<unsigned char> bytes;
    if (cv::imencode(ending, image, bytes)) files.emplace_back(bytes.begin(), bytes.end());
  };
  for (const cv::Mat& image : {grey, deep, colour, alpha}) add(".png", image);
  for (const cv::Mat& image : {grey, deep, colour, real}) add(".tiff", image);
  for (const cv::Mat& image : {grey, deep}) add(".pgm", image);
  for (const char* ending : {".jpg", ".bmp", ".ppm"}) add(ending, colour);
  files.emplace_back("P2\n# text\n2 1\n255\n7 8\n");
  files.emplace_back("Pf\n1 1\n-1\n\0\0\0\x3f", 14);
  return files;
}

std::vector<std::string> words() {
  return {"\x89PNG\r\n\x1a\n",
          "IHDR",
          "IDAT",
          "IEND",
          "PLTE",
          "tRNS",
          "P1\n",
          "P5\n",
          "P6\n",
          "P7\n",
          "Pf\n",
          "II*",
          "MM",
          "BM",
          "\xff\xd8\xff",
          "\xff\xc0",
          "65535\n",
          "1000000 "};
}

}  // namespace xgm::fuzz
