// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/volume.hpp"

#include <algorithm>
#include <new>

#include "xgm/base/parallel.hpp"

namespace xgm {

VolumeShape::VolumeShape(const DisparityRange& range, const cv::Mat1b& valid)
    : size_(range.size()) {
  CV_Assert(valid.empty() || valid.size() == size_);
  const auto rows = static_cast<std::size_t>(height());
  const std::size_t pixels = rows * static_cast<std::size_t>(width());
  slices_ = new_buffer(pixels * sizeof(Slice));
  Slice* const slices = new (slices_.get()) Slice[pixels];
  row_.assign(rows + 1, 0);
  std::vector<Interval> hulls(rows);
  std::vector<int> max_counts(rows);
  parallel_for(0, height(), [&](int y) {
    const std::uint8_t* const valid_row = valid.empty() ? nullptr : valid[y];
    Interval hull;
    int max_count = 0;
    std::uint32_t granules = 0;
    for (int x = 0; x < width(); ++x) {
      const bool used = valid_row == nullptr || valid_row[x] != 0;
      const Interval interval = used ? range.at(y, x) : Interval{};
      slices[static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
             static_cast<std::size_t>(x)] = {interval.begin, interval.size(), granules};
      granules += static_cast<std::uint32_t>(rounded_up(interval.size()) / kGranule);
      max_count = std::max(max_count, interval.size());
      hull = unite(hull, interval);
    }
    const auto row = static_cast<std::size_t>(y);
    row_[row + 1] = std::int64_t{granules} * kGranule;
    hulls[row] = hull;
    max_counts[row] = max_count;
  });
  for (std::size_t y = 0; y < rows; ++y) {
    row_[y + 1] += row_[y];
    hull_ = unite(hull_, hulls[y]);
    max_count_ = std::max(max_count_, max_counts[y]);
  }
}

std::size_t VolumeShape::bytes() const {
  return static_cast<std::size_t>(size_.area()) * sizeof(Slice) + row_.size() * sizeof(row_[0]);
}

}  // namespace xgm
