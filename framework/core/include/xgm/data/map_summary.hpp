// SPDX-License-Identifier: Apache-2.0
// How many pixels of a map are what, counted part by part.
#pragma once

#include <array>
#include <cstdint>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"

namespace xgm {

class XGM_API MapSummary {
 public:
  /// `searched`: every disparity of the map was looked for in it.
  explicit MapSummary(Interval searched = {}) : searched_(searched) {}

  void add(const DisparityMap& part);

  /// Share of pixels of each status, 0 to 1, indexed by Status.
  std::array<double, kStatusCount> status_shares() const;
  /// Share of pixels that have a disparity, 0 to 1.
  double density() const;
  /// Of the matched pixels, the share within 1 px of the first, or the last, disparity searched.
  double share_at_first() const { return share_at(0); }
  double share_at_last() const { return share_at(1); }

 private:
  double share_at(std::size_t end) const;

  Interval searched_;
  std::int64_t pixels_ = 0;
  std::array<std::int64_t, kStatusCount> of_status_{};
  std::array<std::int64_t, 2> near_end_{};
};

}  // namespace xgm
