// SPDX-License-Identifier: Apache-2.0
// Statuses out of status.png, which shows one colour for each.
#include <algorithm>
#include <array>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "bench/judge.hpp"
#include "xgm/io/outputs.hpp"

namespace xgm {
namespace {

std::array<cv::Vec3b, kStatusCount> colours() {
  DisparityMap one_of_each(cv::Size(kStatusCount, 1));
  for (int i = 0; i < kStatusCount; ++i) one_of_each.status(0, i) = static_cast<std::uint8_t>(i);
  const cv::Mat3b picture = status_picture(one_of_each);
  std::array<cv::Vec3b, kStatusCount> found;
  for (int i = 0; i < kStatusCount; ++i) found[static_cast<std::size_t>(i)] = picture(0, i);
  return found;
}

}  // namespace

void read_statuses(const std::string& folder, DisparityMap& map) {
  const auto file = std::filesystem::path(folder) / "status.png";
  const cv::Mat picture = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (picture.rows < map.status.rows || picture.cols < map.status.cols) return;
  const auto known = colours();
  for (int y = 0; y < map.status.rows; ++y) {
    for (int x = 0; x < map.status.cols; ++x) {
      const auto* found = std::find(known.begin(), known.end(), picture.at<cv::Vec3b>(y, x));
      const auto status = static_cast<Status>(found - known.begin());
      if (found != known.end() && has_disparity(status) == map.has_disparity(y, x)) {
        map.status(y, x) = static_cast<std::uint8_t>(status);
      }
    }
  }
}

}  // namespace xgm
