// SPDX-License-Identifier: Apache-2.0
// Matches the scene of a run, as a whole or in parts, and keeps its map: in memory or, if the
// images are not held either, in files.
#pragma once

#include <memory>
#include <string>

#include "xgm/io/map_in_parts.hpp"
#include "xgm/pipeline/scene_run.hpp"

namespace xgm {

class KeptMap {
 public:
  explicit KeptMap(std::string folder) : folder_(std::move(folder)) {}

  /// What is taken beside the run to keep the map of the inputs: in files if they are windows.
  void add_bytes(SceneInputs& inputs) const;

  /// In parts, if `choose` is set and says so. Throws what match_scene() throws.
  SceneRun match(const Pipeline& pipeline, SceneInputs inputs, const RunOptions& options,
                 const ChooseParts& choose);

  const MapSummary& summary() const { return files_ ? files_->summary() : summary_; }

  /// Of the map, which is that of the run unless it is not held.
  bool has_confidence(const DisparityMap& map) const {
    return files_ ? files_->has_confidence() : !map.confidence.empty();
  }

  /// Writes the files of the map, which is that of the run unless it is not held.
  void write(const DisparityMap& map);

 private:
  std::string folder_;
  std::unique_ptr<MapInParts> files_;
  MapSummary summary_;  ///< of a map that is held
};

}  // namespace xgm
