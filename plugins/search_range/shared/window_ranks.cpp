// SPDX-License-Identifier: Apache-2.0
// Sliding histograms: a step to the right adds one column of the window and removes one, so a
// pixel costs 2 * window reads instead of window * window.
// T. S. Huang, G. J. Yang, G. Y. Tang: A fast two-dimensional median filtering algorithm, 1979.
#include "plugins/search_range/shared/window_ranks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "xgm/base/parallel.hpp"

namespace xgm::search_range {
namespace {

/// A disparity as a whole number that keeps its order and tells both its fine_floor and its
/// fine_ceil: even codes are whole fine disparities, odd ones lie between two.
int code_of(float d) { return fine_floor(d) + fine_ceil(d); }
int floor_of(int code) { return code >> 1; }
int ceil_of(int code) { return (code + 1) >> 1; }

/// A map as indices into the ascending list of the codes that occur in it, -1 where it has none.
struct CodedMap {
  explicit CodedMap(const DisparityMap& map) : index(map.size(), -1) {
    for (int y = 0; y < index.rows; ++y) {
      for (int x = 0; x < index.cols; ++x) {
        if (map.valid(y, x)) codes.push_back(code_of(map.disparity(y, x)));
      }
    }
    std::sort(codes.begin(), codes.end());
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    parallel_for(0, index.rows, [&](int y) {
      for (int x = 0; x < index.cols; ++x) {
        if (!map.valid(y, x)) continue;
        const int code = code_of(map.disparity(y, x));
        const auto place = std::lower_bound(codes.begin(), codes.end(), code);
        index(y, x) = static_cast<int>(place - codes.begin());
      }
    });
  }

  std::vector<int> codes;
  cv::Mat1i index;
};

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
    const int rank = std::max(1, static_cast<int>(std::ceil(mark.percentile * total_ / 100)));
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

Proposal window_ranks(const DisparityMap& coarse, const cv::Mat1b& asked, int window,
                      Percentiles percentiles, int relaxation) {
  const CodedMap map(coarse);
  const int radius = window / 2;
  Proposal proposal(coarse.size());
  parallel_for(0, map.index.rows, [&](int y) {
    SlidingHistogram histogram(map.codes.size(), percentiles);
    const int top = std::max(0, y - radius);
    const int bottom = std::min(map.index.rows, y + radius + 1);
    for (int x = 0; x < radius; ++x) slide(histogram, map.index, x, top, bottom, 1);
    for (int x = 0; x < map.index.cols; ++x) {
      slide(histogram, map.index, x + radius, top, bottom, 1);
      slide(histogram, map.index, x - radius - 1, top, bottom, -1);
      if (asked(y, x) == 0 || histogram.total() == 0) continue;
      const int low = floor_of(map.codes[static_cast<std::size_t>(histogram.low())]);
      const int high = ceil_of(map.codes[static_cast<std::size_t>(histogram.high())]);
      proposal.set(y, x, {low - relaxation, high + relaxation + 1});
    }
  });
  return proposal;
}

cv::Mat1b valid_pixels(const DisparityMap& map) {
  cv::Mat1b valid(map.size());
  for (int y = 0; y < valid.rows; ++y) {
    for (int x = 0; x < valid.cols; ++x) valid(y, x) = map.valid(y, x) ? 255 : 0;
  }
  return valid;
}

}  // namespace xgm::search_range
