// SPDX-License-Identifier: Apache-2.0
#include "speed/stage_clock.hpp"

#include <algorithm>

namespace xgm::speed {

std::string stage_name(const StagePlace& place) { return place.kind + ' ' + place.plugin; }

void StageClock::stage_begin(const StagePlace& place) {
  const std::string name = stage_name(place);
  const auto found = std::find_if(totals_.begin(), totals_.end(),
                                  [&](const Total& total) { return total.stage == name; });
  open_.push_back({static_cast<std::size_t>(found - totals_.begin())});
  if (found == totals_.end()) totals_.push_back({name});
}

void StageClock::stage_end(const StagePlace&, const StageStatistics& statistics, const Artifact&) {
  const Open ended = open_.back();
  open_.pop_back();
  totals_[ended.total].seconds += statistics.seconds - ended.inside;
  if (!open_.empty()) open_.back().inside += statistics.seconds;
}

}  // namespace xgm::speed
