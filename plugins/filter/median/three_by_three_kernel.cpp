// SPDX-License-Identifier: Apache-2.0
// Branches on missing disparities would be slow, and keep compilers from making vectors of the
// loop. So what is missing becomes -infinity and +infinity in turn: that way the middle one of the
// nine is the middle one of those that are there, or the lower of two. The loop is compiled for
// each SIMD target; what it says does not depend on that.
#include "plugins/filter/median/three_by_three.hpp"
#include "xgm/base/simd_dispatch.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/filter/median/three_by_three_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::median::HWY_NAMESPACE {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

struct Three {
  float low, middle, high;
};

inline float middle_of(float a, float b, float c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

inline Three sorted(float a, float b, float c) {
  return {std::min(std::min(a, b), c), middle_of(a, b, c), std::max(std::max(a, b), c)};
}

/// The median of nine, by sorted columns: the middle one of the largest low, the middle middle and
/// the smallest high value.
inline float middle_of(const Three& a, const Three& b, const Three& c) {
  return middle_of(std::max(std::max(a.low, b.low), c.low), middle_of(a.middle, b.middle, c.middle),
                   std::min(std::min(a.high, b.high), c.high));
}

inline float present(float disparity, float& stand_in) {
  const bool missing = disparity != disparity;
  const float value = missing ? stand_in : disparity;
  stand_in = missing ? -stand_in : stand_in;
  return value;
}

inline Three column(float above, float here, float below, float& stand_in) {
  const float a = present(above, stand_in);
  const float b = present(here, stand_in);
  const float c = present(below, stand_in);
  return sorted(a, b, c);
}

void filter_row(const cv::Mat1f& disparity, int y, float* __restrict result) {
  const int width = disparity.cols;
  const auto stride = static_cast<std::size_t>(width) + 2;
  std::vector<float> rows(3 * stride, kNone);
  for (int row = std::max(0, y - 1); row <= std::min(y + 1, disparity.rows - 1); ++row) {
    std::copy_n(disparity[row], width,
                rows.data() + static_cast<std::size_t>(row - y + 1) * stride + 1);
  }
  const float* const above = rows.data();
  const float* const here = above + stride;
  const float* const below = here + stride;
  for (int x = 0; x < width; ++x) {
    float stand_in = -kInfinity;
    const Three left = column(above[x], here[x], below[x], stand_in);
    const Three middle = column(above[x + 1], here[x + 1], below[x + 1], stand_in);
    const Three right = column(above[x + 2], here[x + 2], below[x + 2], stand_in);
    const float centre = here[x + 1];
    result[x] = centre != centre ? centre : middle_of(left, middle, right);
  }
}

}  // namespace xgm::median::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::median {

HWY_EXPORT(filter_row);

void three_by_three(const cv::Mat1f& disparity, int y, float* result) {
  XGM_SIMD_DISPATCH(filter_row)(disparity, y, result);
}

}  // namespace xgm::median
#endif
