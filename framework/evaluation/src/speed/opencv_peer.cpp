// SPDX-License-Identifier: Apache-2.0
#include "speed/opencv_peer.hpp"

#include <algorithm>
#include <array>
#include <opencv2/calib3d.hpp>

#include "speed/clocks.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace {

struct Mode {
  const char* name;
  const char* title;
  int value;
};
constexpr std::array<Mode, 4> kModes{
    {{"hh", "OpenCV HH", cv::StereoSGBM::MODE_HH},
     {"hh4", "OpenCV HH4", cv::StereoSGBM::MODE_HH4},
     {"sgbm", "OpenCV SGBM", cv::StereoSGBM::MODE_SGBM},
     {"sgbm_3way", "OpenCV SGBM_3WAY", cv::StereoSGBM::MODE_SGBM_3WAY}}};

const Mode& find_mode(const std::string& name) {
  const auto found = std::find_if(kModes.begin(), kModes.end(),
                                  [&](const Mode& mode) { return mode.name == name; });
  if (found == kModes.end()) {
    throw Error("OpenCV's StereoSGBM has no mode '" + name + "'; it has hh, hh4, sgbm, sgbm_3way");
  }
  return *found;
}

cv::Mat1b to_8bit_grey(const Image& image) {
  cv::Mat1b grey;
  image.grey().convertTo(grey, CV_8U);
  return grey;
}

}  // namespace

const std::vector<std::string>& opencv_modes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Mode& mode : kModes) all.emplace_back(mode.name);
    return all;
  }();
  return names;
}

namespace speed {

OpenCvPeer::OpenCvPeer(const ImagePair& pair, Interval disparities)
    : left_(to_8bit_grey(pair.base)),
      right_(to_8bit_grey(pair.match)),
      searched_{disparities.begin, disparities.begin + (disparities.size() + 15) / 16 * 16} {}

RunSeconds OpenCvPeer::run(const std::string& mode) const {
  // It holds sixteenths of a pixel in 16 bits, and matches only pixels that have all disparities.
  if (searched_.begin <= -2048 || searched_.end > 2047) {
    throw Error("knows disparities from -2047 to 2046 only");
  }
  constexpr int kBlock = 5, kPreFilterCap = 63, kCheck = 1;
  const int skipped = std::max(searched_.end, 0) - std::min(searched_.begin, 0);
  if (left_.rows < kBlock) throw Error("needs images of 5 rows at least");
  if (left_.cols < skipped + kBlock) {
    throw Error("skips all columns of images that are no wider than the search range");
  }
  const auto matcher = cv::StereoSGBM::create(searched_.begin, searched_.size(), kBlock,
                                              8 * kBlock * kBlock, 32 * kBlock * kBlock, kCheck,
                                              kPreFilterCap, 0, 0, 0, find_mode(mode).value);
  cv::Mat disparities;
  const Clocks clocks;
  matcher->compute(left_, right_, disparities);
  return clocks.seconds();
}

std::string peer_name(const std::string& mode) { return find_mode(mode).title; }

}  // namespace speed
}  // namespace xgm
