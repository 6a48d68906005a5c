// SPDX-License-Identifier: Apache-2.0
#include "run/search_volume.hpp"

#include <algorithm>

#include "xgm/geo/stage/range_prior.hpp"

namespace xgm::geo {

void SearchVolume::stage_end(const StagePlace& place, const StageStatistics&,
                             const Artifact& result) {
  const auto* const held = std::get_if<const DisparityRange*>(&result);
  if (place.kind != RangePrior::kKind || held == nullptr || *held == nullptr) return;
  if (place.level.scale > 1) return;  // a coarser run that only bounds this one
  const DisparityRange& range = **held;
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) {
      const int size = range.at(y, x).size();
      disparities_ += size;
      widest_ = std::max(widest_, size);
    }
  }
  pixels_ += range.size().area();
}

}  // namespace xgm::geo
