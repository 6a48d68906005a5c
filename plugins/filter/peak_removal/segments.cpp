// SPDX-License-Identifier: Apache-2.0
// Segments by union-find: one pass joins, one counts; no recursion, four bytes a pixel twice.
#include "plugins/filter/peak_removal/segments.hpp"

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace xgm::peak_removal {
namespace {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int i) {
    while (parent(i) != i) {
      parent(i) = parent(parent(i));  // path halving keeps the trees flat
      i = parent(i);
    }
    return i;
  }
  /// The smaller index becomes the root: in scan order, the first pixel of a segment.
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    if (a > b) std::swap(a, b);
    parent(b) = a;
  }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

}  // namespace

cv::Mat1i segment_sizes(const cv::Mat1f& disparity, double max_difference) {
  const int rows = disparity.rows, cols = disparity.cols;
  // In double the difference of two floats is not rounded up to the limit; false for NaN.
  const auto alike = [&](float a, float b) {
    return std::abs(static_cast<double>(a) - static_cast<double>(b)) <= max_difference;
  };
  DisjointSets sets(disparity.total());
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < cols; ++x) {
      const int i = y * cols + x;
      const float d = disparity(y, x);
      if (x > 0 && alike(d, disparity(y, x - 1))) sets.join(i - 1, i);
      if (y > 0 && alike(d, disparity(y - 1, x))) sets.join(i - cols, i);
    }
  }
  cv::Mat1i sizes(disparity.size(), 0);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < cols; ++x) {
      const int root = sets.root(y * cols + x);
      if (!std::isnan(disparity(y, x))) ++sizes(root / cols, root % cols);
    }
  }
  // Backwards: a root comes before all others of its segment and still holds the count.
  for (int i = rows * cols - 1; i >= 0; --i) {
    const int root = sets.root(i);
    if (root != i) sizes(i / cols, i % cols) = sizes(root / cols, root % cols);
  }
  return sizes;
}

}  // namespace xgm::peak_removal
