// SPDX-License-Identifier: Apache-2.0
// Paths as recurrences: what a pixel sees along a step is its own disparity, or else what the pixel
// one step ahead sees. Swept from the far end, each direction takes one pass over the map.
#include "plugins/filter/discontinuity_preserving_interpolation/paths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "xgm/base/parallel.hpp"

namespace xgm::discontinuity_preserving_interpolation {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr int kFarthest = 2;  // rows or columns that a knight's move reaches ahead

bool is_hole(std::uint8_t status) {
  return !has_disparity(static_cast<Status>(status)) &&
         status != static_cast<std::uint8_t>(Status::masked);
}

/// What is seen from a row, with nothing beyond both of its ends.
class Seen {
 public:
  explicit Seen(int cols) : values_(static_cast<std::size_t>(cols + 2 * kFarthest), kNothing) {}
  float* row() { return values_.data() + kFarthest; }

 private:
  std::vector<float> values_;
};

/// One row of the recurrence, along the row itself.
void look_along(const float* disparity, int cols, int step_x, float* here) {
  float last = kNothing;
  for (int i = 0; i < cols; ++i) {
    const int x = step_x > 0 ? cols - 1 - i : i;
    last = std::isnan(disparity[x]) ? last : disparity[x];
    here[x] = last;
  }
}

/// One row of the recurrence; `ahead` is what another row sees. Both are read in any case, so that
/// the compiler can choose without branches.
void look_across(const float* disparity, int cols, const float* ahead, float* here) {
  for (int x = 0; x < cols; ++x) {
    const float own = disparity[x], next = ahead[x];
    here[x] = std::isnan(own) ? next : own;
  }
}

}  // namespace

Holes::Holes(const DisparityMap& map)
    : row_begin(static_cast<std::size_t>(map.size().height) + 1, 0) {
  const cv::Size size = map.size();
  parallel_for(0, size.height, [&](int y) {
    const std::uint8_t* status = map.status[y];
    row_begin[static_cast<std::size_t>(y) + 1] =
        static_cast<std::size_t>(std::count_if(status, status + size.width, is_hole));
  });
  std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
  column.resize(row_begin.back());
  parallel_for(0, size.height, [&](int y) {
    int* next = column.data() + row_begin[static_cast<std::size_t>(y)];
    for (int x = 0; x < size.width; ++x) {
      if (is_hole(map.status(y, x))) *next++ = x;
    }
  });
}

std::vector<cv::Point> path_steps(int directions) {
  std::vector<cv::Point> steps{{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                               {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
  if (directions == 16) {
    steps.insert(steps.end(),
                 {{2, 1}, {-2, 1}, {2, -1}, {-2, -1}, {1, 2}, {-1, 2}, {1, -2}, {-1, -2}});
  }
  return steps;
}

std::vector<float> first_along(const cv::Mat1f& disparity, const Holes& holes, cv::Point step) {
  const int rows = disparity.rows, cols = disparity.cols;
  std::array<Seen, kFarthest + 1> ring{Seen(cols), Seen(cols), Seen(cols)};
  Seen outside(cols);
  std::vector<float> first(holes.column.size());
  for (int i = 0; i < rows; ++i) {
    const int y = step.y > 0 ? rows - 1 - i : i;
    const int next = y + step.y;
    float* here = ring[static_cast<std::size_t>(y % 3)].row();
    if (step.y == 0) {
      look_along(disparity[y], cols, step.x, here);
    } else {
      const bool inside = next >= 0 && next < rows;
      float* ahead = inside ? ring[static_cast<std::size_t>(next % 3)].row() : outside.row();
      look_across(disparity[y], cols, ahead + step.x, here);
    }
    const auto row = static_cast<std::size_t>(y);
    for (std::size_t hole = holes.row_begin[row]; hole < holes.row_begin[row + 1]; ++hole) {
      first[hole] = here[holes.column[hole]];
    }
  }
  return first;
}

}  // namespace xgm::discontinuity_preserving_interpolation
