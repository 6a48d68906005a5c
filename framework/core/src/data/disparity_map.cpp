// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/disparity_map.hpp"

#include <array>
#include <limits>

namespace xgm {

std::string_view to_string(Status status) {
  static constexpr std::array<std::string_view, kStatusCount> kNames{
      "valid", "filled", "masked", "out_of_range", "ambiguous", "occluded", "mismatched", "peak"};
  return kNames[static_cast<std::size_t>(status)];
}

DisparityMap::DisparityMap(cv::Size size, Status why)
    : disparity(size, std::numeric_limits<float>::quiet_NaN()),
      status(size, static_cast<std::uint8_t>(why)) {}

void DisparityMap::invalidate(int y, int x, Status why) {
  set(y, x, std::numeric_limits<float>::quiet_NaN(), why);
}

double DisparityMap::density() const {
  if (disparity.empty()) return 0;
  std::size_t count = 0;
  for (const std::uint8_t s : status) count += xgm::has_disparity(static_cast<Status>(s));
  return static_cast<double>(count) / static_cast<double>(status.total());
}

void DisparityMap::inherit_confidence(const DisparityMap& origin) {
  const cv::Mat1f& inherited = confidence.empty() ? origin.confidence : confidence;
  if (inherited.empty()) return;
  confidence = inherited.clone();  // another map may share it
  confidence.setTo(std::numeric_limits<float>::quiet_NaN(),
                   status != static_cast<int>(Status::matched));
}

DisparityMap DisparityMap::clone() const {
  DisparityMap copy;
  copy.disparity = disparity.clone();
  copy.status = status.clone();
  copy.confidence = confidence.clone();
  return copy;
}

}  // namespace xgm
