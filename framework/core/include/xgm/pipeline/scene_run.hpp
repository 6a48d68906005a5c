// SPDX-License-Identifier: Apache-2.0
// Runs a pipeline on a scene: from files or images in memory to maps.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/match.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/pipeline/scene_inputs.hpp"

namespace xgm {

/// A scene that has been matched.
struct SceneRun {
  Scene scene;                   ///< the pair, its truth, the files that were read, notes
  Interval disparities;          ///< hull of what was searched
  std::string disparities_from;  ///< where that comes from, for people
  MatchResult maps;
  std::vector<std::string> warnings;  ///< of the files, the memory and the stages
  double reading_seconds = 0;
  double matching_seconds = 0;
};

/// Is given each part of the map of the base view once.
using TakePart = std::function<void(const cv::Rect& place, const DisparityMap& part)>;

/// Matches a scene part by part.
using MatchParts = std::function<void(const TakePart& take, const RunOptions& options)>;

/// Says how a scene is matched in parts, within the memory limit of the inputs if there is one
/// (bytes of the process). Empty if it is matched as a whole, which then keeps the limit.
using ChooseParts = std::function<MatchParts(const SceneInputs& inputs, const RunOptions& options)>;

/// Matches a scene, in place of guarding the memory and Pipeline::run().
using MatchScene = std::function<MatchResult(const SceneInputs& inputs, const RunOptions& options)>;

/// Reads the scene and matches it. The observer, if there is one, is also told of notes and
/// warnings that belong to no stage, with an empty path. Throws UsageError for what is wrong before
/// any image is opened, or if the run would take more memory than the request allows; Error if the
/// run fails.
XGM_API SceneRun run_scene(const Pipeline& pipeline, const SceneRequest& request,
                           const RunOptions& options = {});

/// The second half of it, for callers that look at the images before. A scene that is read by
/// windows needs `match`.
XGM_API SceneRun match_scene(const Pipeline& pipeline, SceneInputs inputs,
                             const RunOptions& options = {}, const MatchScene& match = {});

}  // namespace xgm
