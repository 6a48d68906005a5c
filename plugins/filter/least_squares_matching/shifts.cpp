// SPDX-License-Identifier: Apache-2.0
// The sums of all windows of a row grow together, one offset of the window after the other: loops
// without branches, which compilers make vectors of.
#include "plugins/filter/least_squares_matching/shifts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace xgm::least_squares_matching {
namespace {

constexpr int kUnknowns = 3;  // gain, offset, shift

/// Sums of a row's windows: of 1, and of products of base (b), match (m) and slope (s), where
/// base and match are counted from the pixel in the middle, so that floats suffice.
struct Sums {
  explicit Sums(int width) {
    for (auto* sum : {&n, &b, &m, &s, &bb, &bm, &bs, &mm, &ms, &ss}) {
      sum->assign(static_cast<std::size_t>(width), 0.0F);
    }
  }
  std::vector<float> n, b, m, s, bb, bm, bs, mm, ms, ss;
};

struct Row {
  const float *disparity, *base, *match, *slope, *seen;
};

Row row_of(const cv::Mat1f& disparity, const Warped& warped, int y) {
  return {disparity[y], warped.base[y], warped.match[y], warped.slope[y], warped.seen[y]};
}

void add(const Row& here, const Row& there, int dx, int width, float jump, Sums& sums) {
  const int begin = std::max(0, -dx), end = std::min(width, width - dx);
  for (int x = begin; x < end; ++x) {
    const int u = x + dx;
    // Comparisons with NaN are false.
    const bool same = std::abs(there.disparity[u] - here.disparity[x]) <= jump;
    const float w = same ? there.seen[u] : 0.0F;
    const float b = w * (there.base[u] - here.base[x]);
    const float m = w * (there.match[u] - here.match[x]);
    const float s = w * there.slope[u];
    const auto i = static_cast<std::size_t>(x);
    sums.n[i] += w;
    sums.b[i] += b;
    sums.m[i] += m;
    sums.s[i] += s;
    sums.bb[i] += b * b;
    sums.bm[i] += b * m;
    sums.bs[i] += b * s;
    sums.mm[i] += m * m;
    sums.ms[i] += m * s;
    sums.ss[i] += s * s;
  }
}

Shift solve(const Sums& sums, std::size_t i) {
  constexpr Shift kUnknown{0, std::numeric_limits<float>::infinity()};
  const double n{sums.n[i]};
  if (n <= 2 * kUnknowns) return kUnknown;
  const auto covariance = [n](float product, float a, float b) {
    return double{product} - double{a} * double{b} / n;
  };
  const double bb = covariance(sums.bb[i], sums.b[i], sums.b[i]);
  const double bm = covariance(sums.bm[i], sums.b[i], sums.m[i]);
  const double bs = covariance(sums.bs[i], sums.b[i], sums.s[i]);
  const double mm = covariance(sums.mm[i], sums.m[i], sums.m[i]);
  const double ms = covariance(sums.ms[i], sums.m[i], sums.s[i]);
  const double ss = covariance(sums.ss[i], sums.s[i], sums.s[i]);
  const double determinant = mm * ss - ms * ms;
  if (!(determinant > 1e-6 * mm * ss)) return kUnknown;  // no texture
  const double gain = (bm * ss - bs * ms) / determinant;
  const double along = (bs * mm - bm * ms) / determinant;
  constexpr double kLeastGain = 0.1;
  if (gain < kLeastGain) return kUnknown;  // the windows do not look alike
  // Grey levels are rounded: no residual is smaller than that.
  const double rounding = n / 12;
  const double residual = std::max(bb - gain * bm - along * bs, rounding) / (n - kUnknowns);
  return {static_cast<float>(-along / gain),
          static_cast<float>(residual * mm / determinant / (gain * gain))};
}

}  // namespace

void find_shifts(const cv::Mat1f& disparity, const Warped& warped, const Window& window, int y,
                 std::vector<Shift>& shifts) {
  const int width = disparity.cols;
  Sums sums(width);
  const Row here = row_of(disparity, warped, y);
  const int last = std::min(disparity.rows - 1, y + window.radius);
  for (int v = std::max(0, y - window.radius); v <= last; ++v) {
    const Row there = row_of(disparity, warped, v);
    for (int dx = -window.radius; dx <= window.radius; ++dx) {
      add(here, there, dx, width, window.jump, sums);
    }
  }
  shifts.resize(static_cast<std::size_t>(width));
  for (std::size_t i = 0; i < shifts.size(); ++i) shifts[i] = solve(sums, i);
}

}  // namespace xgm::least_squares_matching
