// SPDX-License-Identifier: Apache-2.0
// What the runs of many tiles look like to the observer of one run.
#pragma once

#include <map>
#include <vector>

#include "xgm/stage/observer.hpp"

namespace xgm::tiles {

/// Each stage is told of once, with the seconds of all tiles; what it was given and returned, and
/// figures about single tiles, are not told.
class TilesAsOne final : public Observer {
 public:
  /// `whole` may be null.
  explicit TilesAsOne(Observer* whole) : whole_(whole) {}

  /// The run that begins is the share [begin, end) of all.
  void next(double begin, double end, bool is_tile);
  /// All tiles are done.
  void finish();

  void log(LogLevel level, const StagePlace& place, const std::string& text) override;
  void stage_begin(const StagePlace& place) override;
  void stage_same_as(const StagePlace& place, const std::string& earlier) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;
  void figure(const StagePlace& place, const std::string& name, double value) override;
  void progress(double share) override;

 private:
  struct Stage {
    StagePlace place;
    StageStatistics sum{};
  };
  Observer* whole_;
  double begin_ = 0, end_ = 1;
  bool is_tile_ = false;
  std::vector<Stage> stages_;                   // in the order in which they have begun
  std::map<std::string, std::size_t> by_path_;  // their places in it
};

}  // namespace xgm::tiles
