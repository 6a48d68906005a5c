// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/volume.hpp"

#include <algorithm>

namespace xgm {

VolumeShape::VolumeShape(const DisparityRange& range, const cv::Mat1b& valid)
    : size_(range.size()) {
  CV_Assert(valid.empty() || valid.size() == size_);
  const auto pixels =
      static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
  begin_.reserve(pixels);
  offset_.reserve(pixels + 1);
  offset_.push_back(0);
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      const bool used = valid.empty() || valid(y, x) != 0;
      const Interval interval = used ? range.at(y, x) : Interval{};
      begin_.push_back(interval.begin);
      offset_.push_back(offset_.back() + interval.size());
      max_count_ = std::max(max_count_, interval.size());
      if (interval.empty()) continue;
      if (hull_.empty()) hull_ = interval;
      hull_ = {std::min(hull_.begin, interval.begin), std::max(hull_.end, interval.end)};
    }
  }
}

std::size_t VolumeShape::bytes() const {
  return begin_.size() * sizeof(begin_[0]) + offset_.size() * sizeof(offset_[0]);
}

}  // namespace xgm
