// SPDX-License-Identifier: Apache-2.0
// The disparities to search: one interval for the whole image, or one per pixel.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm {

/// Half-open interval [begin, end) of integer disparities in pixels. If it is empty, there is
/// nothing to search.
struct Interval {
  int begin = 0;
  int end = 0;

  int size() const { return end > begin ? end - begin : 0; }
  bool empty() const { return end <= begin; }
  bool contains(int d) const { return begin <= d && d < end; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The intersection; empty ({0, 0}) if the intervals are disjoint.
inline Interval intersect(Interval a, Interval b) {
  const Interval both{std::max(a.begin, b.begin), std::min(a.end, b.end)};
  return both.empty() ? Interval{} : both;
}

/// The smallest interval that contains both. An empty interval is ignored.
inline Interval unite(Interval a, Interval b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// The disparities to search in an image of size(). Disparity d of a base pixel: x_match = x_base -
/// d.
class XGM_API DisparityRange {
 public:
  /// One interval for all pixels.
  static DisparityRange uniform(cv::Size size, Interval interval);
  /// One interval per pixel: [begin(p), end(p)). Both maps have the same size.
  DisparityRange(cv::Mat1i begin, cv::Mat1i end);
  /// The interval at(y, x) for each pixel; rows are computed on thread_count() threads. If `at`
  /// throws, the exception of the first such pixel is rethrown.
  template <class At>
  static DisparityRange of_pixels(cv::Size size, const At& at) {
    cv::Mat1i begin(size), end(size);
    parallel_for(0, size.height, [&](int y) {
      for (int x = 0; x < size.width; ++x) {
        const Interval interval = at(y, x);
        begin(y, x) = interval.begin;
        end(y, x) = interval.end;
      }
    });
    return {begin, end};
  }

  cv::Size size() const { return size_; }
  bool is_uniform() const { return begin_.data == nullptr; }
  Interval at(int y, int x) const {
    return is_uniform() ? hull_ : Interval{begin_(y, x), end_(y, x)};
  }
  /// Smallest interval that contains the intervals of all pixels.
  Interval hull() const { return hull_; }
  /// Of the maps; 0 for a uniform range.
  std::size_t bytes() const { return begin_.total() * 2 * sizeof(int); }
  /// Where the maps lie: equal for ranges that share them; null for a uniform range.
  const void* data() const { return begin_.data; }

  /// The range of the reverse map: pixel x' of the match image may take -d if some base pixel
  /// x = x' + d may take d. With per-pixel ranges, each match pixel gets the hull of these.
  DisparityRange reversed() const;

 private:
  DisparityRange(cv::Size size, Interval interval) : size_(size), hull_(interval) {}

  cv::Size size_;
  Interval hull_;
  cv::Mat1i begin_, end_;  // empty when uniform
};

}  // namespace xgm
