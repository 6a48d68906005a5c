// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/disparity_range.hpp"

#include <algorithm>

#include "xgm/base/parallel.hpp"

namespace xgm {
namespace {

// Row of the reverse range: base pixel x with range [b, e) reaches the match pixels x' = x - d, d
// in [b, e), with reverse disparity -d. Extends each x' it can reach.
void reverse_row(const DisparityRange& range, int y, int* begin, int* end) {
  const int width = range.size().width;
  for (int x = 0; x < width; ++x) {
    const Interval reach = intersect(range.at(y, x), {x - width + 1, x + 1});
    for (int d = reach.begin; d < reach.end; ++d) {
      const Interval grown = unite({begin[x - d], end[x - d]}, {-d, -d + 1});
      begin[x - d] = grown.begin;
      end[x - d] = grown.end;
    }
  }
}

}  // namespace

Interval intersect(Interval a, Interval b) {
  const Interval both{std::max(a.begin, b.begin), std::min(a.end, b.end)};
  return both.empty() ? Interval{} : both;
}

Interval unite(Interval a, Interval b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

DisparityRange DisparityRange::uniform(cv::Size size, Interval interval) {
  return DisparityRange(size, interval.empty() ? Interval{} : interval);
}

DisparityRange::DisparityRange(cv::Mat1i begin, cv::Mat1i end)
    : size_(begin.size()), begin_(std::move(begin)), end_(std::move(end)) {
  CV_Assert(begin_.size() == end_.size());
  for (int y = 0; y < size_.height; ++y) {
    for (int x = 0; x < size_.width; ++x) hull_ = unite(hull_, {begin_(y, x), end_(y, x)});
  }
}

DisparityRange DisparityRange::reversed() const {
  if (is_uniform()) return uniform(size_, {-hull_.end + 1, -hull_.begin + 1});
  cv::Mat1i begin(size_, 0), end(size_, 0);
  parallel_for(0, size_.height, [&](int y) { reverse_row(*this, y, begin[y], end[y]); });
  return {begin, end};
}

}  // namespace xgm
