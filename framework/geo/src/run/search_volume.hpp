// SPDX-License-Identifier: Apache-2.0
// How many disparities a run searched.
#pragma once

#include "xgm/stage/observer.hpp"

namespace xgm::geo {

/// Counts the ranges that stages of kind "range_prior" give.
class SearchVolume final : public Observer {
 public:
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;

  double per_pixel() const { return pixels_ > 0 ? disparities_ / pixels_ : 0; }
  /// The most disparities of any pixel.
  int widest() const { return widest_; }

 private:
  double disparities_ = 0, pixels_ = 0;
  int widest_ = 0;
};

}  // namespace xgm::geo
