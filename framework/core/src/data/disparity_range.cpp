// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/disparity_range.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "xgm/base/parallel.hpp"

namespace xgm {
namespace {

/// A row of pixels of which each is painted once: a union-find over runs of painted pixels leads
/// past them, so that painting n intervals costs hardly more than n plus the pixels.
class PaintedRow {
 public:
  explicit PaintedRow(int width) : next_(static_cast<std::size_t>(width) + 1), colour_(next_) {}

  void clear() { std::iota(next_.begin(), next_.end(), 0); }
  /// Paints what is not yet painted of `pixels`, which lie inside the row.
  void paint(Interval pixels, int colour) {
    for (int x = unpainted(pixels.begin); x < pixels.end; x = unpainted(x)) {
      colour_[at(x)] = colour;
      next_[at(x)] = x + 1;
    }
  }
  bool painted(int x) const { return next_[at(x)] != x; }
  int colour(int x) const { return colour_[at(x)]; }

 private:
  static std::size_t at(int x) { return static_cast<std::size_t>(x); }
  /// The first pixel from x on that is not painted, the width if all are.
  int unpainted(int x) {
    while (next_[at(x)] != x) {
      next_[at(x)] = next_[at(next_[at(x)])];
      x = next_[at(x)];
    }
    return x;
  }

  std::vector<int> next_, colour_;
};

/// Base pixel x with range [b, e) reaches the match pixels x' = x - d with d in [b, e), with the
/// reverse disparity -d = x' - x: of all that reach an x', the lowest x has the largest and the
/// highest x the smallest one.
void reverse_row(const DisparityRange& range, int y, PaintedRow& row, int* begin, int* end) {
  const int width = range.size().width;
  const auto reach = [&](int x) {
    const Interval d = range.at(y, x);
    // Cut to the row first: x - d could overflow.
    const Interval inside = intersect(d, {x - width + 1, x + 1});
    return inside.empty() ? Interval{} : Interval{x - inside.end + 1, x - inside.begin + 1};
  };
  row.clear();
  for (int x = 0; x < width; ++x) row.paint(reach(x), x);
  for (int x = 0; x < width; ++x) end[x] = row.painted(x) ? x - row.colour(x) + 1 : 0;
  row.clear();
  for (int x = width - 1; x >= 0; --x) row.paint(reach(x), x);
  for (int x = 0; x < width; ++x) begin[x] = row.painted(x) ? x - row.colour(x) : 0;
}

/// The hull of n intervals.
Interval hull_of(const int* begin, const int* end, int n) {
  constexpr int kLowest = std::numeric_limits<int>::min(), kHighest = -(kLowest + 1);
  Interval hull{kHighest, kLowest};
  for (int x = 0; x < n; ++x) {
    const bool some = begin[x] < end[x];
    hull.begin = std::min(hull.begin, some ? begin[x] : kHighest);
    hull.end = std::max(hull.end, some ? end[x] : kLowest);
  }
  return hull.empty() ? Interval{} : hull;
}

}  // namespace

DisparityRange DisparityRange::uniform(cv::Size size, Interval interval) {
  return DisparityRange(size, interval.empty() ? Interval{} : interval);
}

DisparityRange::DisparityRange(cv::Mat1i begin, cv::Mat1i end)
    : size_(begin.size()), begin_(std::move(begin)), end_(std::move(end)) {
  CV_Assert(begin_.size() == end_.size());
  std::vector<Interval> rows(static_cast<std::size_t>(size_.height));
  parallel_for(0, size_.height, [&](int y) {
    rows[static_cast<std::size_t>(y)] = hull_of(begin_[y], end_[y], size_.width);
  });
  for (const Interval row : rows) hull_ = unite(hull_, row);
}

DisparityRange DisparityRange::reversed() const {
  if (is_uniform()) return uniform(size_, {-hull_.end + 1, -hull_.begin + 1});
  cv::Mat1i begin(size_), end(size_);
  constexpr int kRows = 16;  // that share the memory of a PaintedRow
  parallel_for(0, (size_.height + kRows - 1) / kRows, [&](int i) {
    PaintedRow row(size_.width);
    for (int y = i * kRows; y < std::min(size_.height, (i + 1) * kRows); ++y) {
      reverse_row(*this, y, row, begin[y], end[y]);
    }
  });
  return {begin, end};
}

}  // namespace xgm
