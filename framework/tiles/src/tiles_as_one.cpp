// SPDX-License-Identifier: Apache-2.0
#include "tiles_as_one.hpp"

#include <algorithm>

namespace xgm::tiles {

void TilesAsOne::next(double begin, double end, bool is_tile) {
  begin_ = begin;
  end_ = end;
  is_tile_ = is_tile;
}

void TilesAsOne::finish() {
  if (whole_ == nullptr) return;
  for (auto stage = stages_.rbegin(); stage != stages_.rend(); ++stage) {
    whole_->stage_end(stage->place, stage->sum, {});
  }
}

void TilesAsOne::log(LogLevel level, const StagePlace& place, const std::string& text) {
  if (whole_ != nullptr) whole_->log(level, place, text);
}

void TilesAsOne::stage_begin(const StagePlace& place) {
  if (!by_path_.emplace(place.path, stages_.size()).second) return;
  stages_.push_back({place});
  if (whole_ != nullptr) whole_->stage_begin(place);
}

void TilesAsOne::stage_same_as(const StagePlace& place, const std::string& earlier) {
  if (whole_ != nullptr) whole_->stage_same_as(place, earlier);
}

void TilesAsOne::stage_end(const StagePlace& place, const StageStatistics& statistics,
                           const Artifact&) {
  StageStatistics& sum = stages_[by_path_.at(place.path)].sum;
  sum.seconds += statistics.seconds;
  sum.bytes = std::max(sum.bytes, statistics.bytes);
}

void TilesAsOne::figure(const StagePlace& place, const std::string& name, double value) {
  if (whole_ != nullptr && !is_tile_) whole_->figure(place, name, value);
}

void TilesAsOne::progress(double share) {
  if (whole_ != nullptr) whole_->progress(begin_ + share * (end_ - begin_));
}

}  // namespace xgm::tiles
