// SPDX-License-Identifier: Apache-2.0
// What a coarse map proposes to search at the next finer level, and how limits bound it.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

#include "xgm/data/disparity_range.hpp"

namespace xgm::search_range {

/// One interval [begin, end) per coarse pixel, in disparities of the finer level (twice the coarse
/// ones). Empty: this pixel proposes nothing, so everything must be searched.
struct Proposal {
  /// Proposes nothing anywhere.
  explicit Proposal(cv::Size size) : begin(cv::Mat1i::zeros(size)), end(cv::Mat1i::zeros(size)) {}

  Interval at(int y, int x) const { return {begin(y, x), end(y, x)}; }
  void set(int y, int x, Interval interval) {
    begin(y, x) = interval.begin;
    end(y, x) = interval.end;
  }

  cv::Mat1i begin, end;
};

/// Disparities beyond this are cut to it: far outside any image, and small enough that relaxations
/// can be added without overflow.
inline constexpr double kFarAway = 1e9;

/// Largest whole fine disparity not above, smallest not below the coarse disparity `d`.
inline int fine_floor(double d) {
  const double fine = std::clamp(2 * d, -kFarAway, kFarAway);
  const int whole = static_cast<int>(fine);
  return whole - (fine < whole ? 1 : 0);
}
inline int fine_ceil(double d) {
  const double fine = std::clamp(2 * d, -kFarAway, kFarAway);
  const int whole = static_cast<int>(fine);
  return whole + (fine > whole ? 1 : 0);
}

/// The closed interval from `low` to `high`, which are coarse disparities, at the finer level and
/// widened by `relaxation` fine pixels: [floor(2 low) - relaxation, ceil(2 high) + relaxation].
Interval relaxed(double low, double high, int relaxation);

/// The range of the finer level (the size of `limits`): the proposal cut to the limits relaxed by
/// `relaxation` on both sides (the paper's Eq. 7). A pixel whose coarse pixel proposes nothing, or
/// nothing within its relaxed limits, searches all of them; empty limits stay empty.
DisparityRange cut(const Proposal& proposal, const DisparityRange& limits, int relaxation);

}  // namespace xgm::search_range
