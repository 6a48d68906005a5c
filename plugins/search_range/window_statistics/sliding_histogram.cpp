// SPDX-License-Identifier: Apache-2.0
// Plain, and the reference of the column histograms.
#include <algorithm>
#include <vector>

#include "plugins/search_range/window_statistics/ranked_windows.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::search_range {
namespace {

/// Counts of indices, and a bookmark per percentile that moves little from window to window.
class SlidingHistogram {
 public:
  SlidingHistogram(std::size_t bins, Percentiles percentiles)
      : counts_(bins), low_{percentiles.low}, high_{percentiles.high} {}

  void add(int index, int times) {
    counts_[static_cast<std::size_t>(index)] += times;
    total_ += times;
    if (index < low_.index) low_.below += times;
    if (index < high_.index) high_.below += times;
  }
  int total() const { return total_; }
  /// Only while total() is not 0.
  int low() { return move(low_); }
  int high() { return move(high_); }

 private:
  struct Bookmark {
    double percentile;
    int index = 0;
    int below = 0;  // how many values are smaller than index
  };

  int count(int index) const { return counts_[static_cast<std::size_t>(index)]; }
  int move(Bookmark& mark) {
    const int rank = RankedWindows::rank(mark.percentile, total_);
    while (mark.below >= rank) mark.below -= count(--mark.index);
    while (mark.below + count(mark.index) < rank) mark.below += count(mark.index++);
    return mark.index;
  }

  std::vector<int> counts_;
  int total_ = 0;
  Bookmark low_, high_;
};

/// Adds (times = 1) or removes (times = -1) what column x has in rows [top, bottom).
void slide(SlidingHistogram& histogram, const cv::Mat1i& index, int x, int top, int bottom,
           int times) {
  if (x < 0 || x >= index.cols) return;
  for (int y = top; y < bottom; ++y) {
    if (index(y, x) >= 0) histogram.add(index(y, x), times);
  }
}

}  // namespace

void rank_by_sliding(const RankedWindows& windows) {
  const cv::Mat1i& index = windows.map.index;
  const int radius = windows.radius;
  parallel_for(0, index.rows, [&](int y) {
    SlidingHistogram histogram(windows.map.codes.size(), windows.percentiles);
    const int top = std::max(0, y - radius);
    const int bottom = std::min(index.rows, y + radius + 1);
    for (int x = 0; x < radius; ++x) slide(histogram, index, x, top, bottom, 1);
    for (int x = 0; x < index.cols; ++x) {
      slide(histogram, index, x + radius, top, bottom, 1);
      slide(histogram, index, x - radius - 1, top, bottom, -1);
      if (windows.asked(y, x) == 0 || histogram.total() == 0) continue;
      const int low = histogram.low();
      windows.answer(y, x, low, histogram.high());
    }
  });
}

}  // namespace xgm::search_range
