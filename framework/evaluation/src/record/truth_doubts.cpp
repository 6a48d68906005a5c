// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/truth_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "xgm/base/text.hpp"

namespace xgm {
namespace {

constexpr float kNear = 1;                       // px: within it a map agrees with its truth
constexpr double kManyOutside = 0.01;            // truth has a few wrong pixels of its own
constexpr double kMost = 0.9;                    // where range and truth are of opposite signs
constexpr double kAgree = 0.5, kDisagree = 0.1;  // of a map and its truth, of another one's truth

/// How the true disparities lie to the map's and to the range. Mirrored: their negatives.
struct Tally {
  double known = 0, outside = 0, mirrored_inside = 0;
  double compared = 0, near = 0, mirrored_near = 0;
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
};

/// What refinement adds to a disparity that was searched is less than a pixel.
bool is_inside(float disparity, Interval searched) {
  return disparity > static_cast<float>(searched.begin - 1) &&
         disparity < static_cast<float>(searched.end);
}

Tally tally(const DisparityMap& map, const cv::Mat1f& truth, Interval searched) {
  Tally tally;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      const float t = truth(y, x);
      if (!std::isfinite(t)) continue;
      ++tally.known;
      tally.low = std::min(tally.low, t);
      tally.high = std::max(tally.high, t);
      if (!is_inside(t, searched)) ++tally.outside;
      if (is_inside(-t, searched)) ++tally.mirrored_inside;
      if (!map.has_disparity(y, x)) continue;
      const float d = map.disparity(y, x);
      ++tally.compared;
      if (std::abs(d - t) <= kNear) ++tally.near;
      if (std::abs(d + t) <= kNear) ++tally.mirrored_near;
    }
  }
  return tally;
}

bool has_other_sign(const Tally& t, Interval searched) {
  const bool mirrors_map =
      t.compared > 0 && t.mirrored_near >= kAgree * t.compared && t.near <= kDisagree * t.compared;
  const bool mirrors_range =
      !searched.empty() && t.outside >= kMost * t.known && t.mirrored_inside >= kMost * t.known;
  return mirrors_map || mirrors_range;
}

}  // namespace

std::vector<std::string> truth_doubts(const DisparityMap& map, const cv::Mat1f& truth,
                                      Interval searched) {
  const Tally t = tally(map, truth, searched);
  if (t.known == 0) return {};
  const std::string what =
      "the true disparities (" + fixed_number(t.low, 1) + " to " + fixed_number(t.high, 1) + ")";
  if (has_other_sign(t, searched)) {
    return {what +
            " have the other sign: pixel x of the left image lies at x - d of the right one; give "
            "them a negative divisor (--truth-divisor -1, or truth_divisor of a dataset.yaml)"};
  }
  if (searched.empty() || t.outside < kManyOutside * t.known) return {};
  return {fixed_number(100 * t.outside / t.known, 2) + " % of " + what +
          " lie outside of the search range " + std::to_string(searched.begin) + " to " +
          std::to_string(searched.end - 1) +
          "; widen it with --disparities, or check the truth's file and divisor"};
}

}  // namespace xgm
