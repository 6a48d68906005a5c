// SPDX-License-Identifier: Apache-2.0
// Segments by union-find over runs: surfaces are smooth, so there are far fewer runs than pixels.
// Bands of rows are joined in parallel, each within itself, and then with each other.
#include "plugins/filter/peak_removal/segments.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "xgm/base/parallel.hpp"

namespace xgm::peak_removal {
namespace {

constexpr int kBand = 64;  // rows

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t root(std::size_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];  // path halving keeps the trees flat
      i = parent_[i];
    }
    return i;
  }
  /// The smaller index becomes the root, so that joins within a band stay within it.
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  std::vector<std::size_t> parent_;
};

class Finder {
 public:
  Finder(const cv::Mat1f& disparity, double max_difference)
      : disparity_(disparity), max_difference_(max_difference) {}

  Segments run() {
    find_runs();
    join_runs();
    return std::move(segments_);
  }

 private:
  /// In double the difference of two floats is not rounded up to the limit; false for NaN.
  bool alike(float a, float b) const {
    return std::abs(static_cast<double>(a) - static_cast<double>(b)) <= max_difference_;
  }
  bool starts(const float* row, int x) const {
    return !std::isnan(row[x]) && (x == 0 || !alike(row[x - 1], row[x]));
  }
  bool ends(const float* row, int x) const {
    return !std::isnan(row[x]) && (x + 1 == disparity_.cols || !alike(row[x], row[x + 1]));
  }

  void find_runs() {
    std::vector<std::size_t>& row_begin = segments_.row_begin;
    row_begin.assign(static_cast<std::size_t>(disparity_.rows) + 1, 0);
    parallel_for(0, disparity_.rows, [&](int y) {
      std::size_t count = 0;
      for (int x = 0; x < disparity_.cols; ++x) count += starts(disparity_[y], x);
      row_begin[static_cast<std::size_t>(y) + 1] = count;
    });
    std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
    segments_.runs.resize(row_begin.back());
    parallel_for(0, disparity_.rows, [&](int y) {
      Run* run = segments_.runs.data() + row_begin[static_cast<std::size_t>(y)];
      for (int x = 0; x < disparity_.cols; ++x) {
        if (starts(disparity_[y], x)) run->begin = x;
        if (ends(disparity_[y], x)) (run++)->end = x + 1;
      }
    });
  }

  void join_runs() {
    std::vector<Run>& runs = segments_.runs;
    DisjointSets sets(runs.size());
    parallel_for(0, (disparity_.rows + kBand - 1) / kBand, [&](int band) {
      const int end = std::min(disparity_.rows, (band + 1) * kBand);
      for (int y = band * kBand + 1; y < end; ++y) join_with_above(y, sets);
    });
    for (int y = kBand; y < disparity_.rows; y += kBand) join_with_above(y, sets);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs[sets.root(i)].size += runs[i].end - runs[i].begin;
    }
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].size = runs[sets.root(i)].size;
  }

  void join_with_above(int y, DisjointSets& sets) const {
    const std::vector<Run>& runs = segments_.runs;
    const auto row = static_cast<std::size_t>(y);
    std::size_t above = segments_.row_begin[row - 1], here = segments_.row_begin[row];
    const std::size_t above_end = here, here_end = segments_.row_begin[row + 1];
    while (above < above_end && here < here_end) {
      const int begin = std::max(runs[above].begin, runs[here].begin);
      const int end = std::min(runs[above].end, runs[here].end);
      if (touch(y, begin, end)) sets.join(above, here);
      // The one that ends first meets nothing more.
      runs[above].end < runs[here].end ? ++above : ++here;
    }
  }
  /// Whether any pixel of row y from `begin` on is like the one above it.
  bool touch(int y, int begin, int end) const {
    const float *above = disparity_[y - 1], *here = disparity_[y];
    for (int x = begin; x < end; ++x) {
      if (alike(above[x], here[x])) return true;
    }
    return false;
  }

  const cv::Mat1f& disparity_;
  double max_difference_;
  Segments segments_;
};

}  // namespace

Segments find_segments(const cv::Mat1f& disparity, double max_difference) {
  return Finder(disparity, max_difference).run();
}

}  // namespace xgm::peak_removal
