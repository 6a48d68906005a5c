// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/map_summary.hpp"

#include <algorithm>

namespace xgm {
namespace {

std::int64_t matched_near(const DisparityMap& map, const cv::Mat1b& matched, int end) {
  const cv::Mat1b near((map.disparity > end - 1.0) & (map.disparity < end + 1.0) & matched);
  return cv::countNonZero(near);
}

}  // namespace

void MapSummary::add(const DisparityMap& part) {
  pixels_ += static_cast<std::int64_t>(part.status.total());
  for (int i = 0; i < kStatusCount; ++i) {
    of_status_[static_cast<std::size_t>(i)] += cv::countNonZero(part.status == i);
  }
  const cv::Mat1b matched(part.status == static_cast<int>(Status::matched));
  near_end_[0] += matched_near(part, matched, searched_.begin);
  near_end_[1] += matched_near(part, matched, searched_.end - 1);
}

std::array<double, kStatusCount> MapSummary::status_shares() const {
  std::array<double, kStatusCount> shares{};
  for (std::size_t i = 0; i < kStatusCount && pixels_ > 0; ++i) {
    shares[i] = static_cast<double>(of_status_[i]) / static_cast<double>(pixels_);
  }
  return shares;
}

double MapSummary::density() const {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < kStatusCount; ++i) {
    if (has_disparity(static_cast<Status>(i))) count += of_status_[i];
  }
  return pixels_ > 0 ? static_cast<double>(count) / static_cast<double>(pixels_) : 0;
}

double MapSummary::share_at(std::size_t end) const {
  const std::int64_t matched = of_status_[static_cast<std::size_t>(Status::matched)];
  return static_cast<double>(near_end_[end]) / std::max(1.0, static_cast<double>(matched));
}

}  // namespace xgm
