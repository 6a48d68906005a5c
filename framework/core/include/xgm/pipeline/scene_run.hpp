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

/// Matches a pair otherwise than as a whole, within the memory limit of the inputs if there is one
/// (bytes of the process).
using MatchPair = std::function<MatchResult(const MatchRequest& request, const SceneInputs& inputs,
                                            const RunOptions& options)>;

/// Reads the scene and matches it. The observer, if there is one, is also told of notes and
/// warnings that belong to no stage, with an empty path. Throws UsageError for what is wrong before
/// any image is opened, or if the run would take more memory than the request allows; Error if the
/// run fails.
XGM_API SceneRun run_scene(const Pipeline& pipeline, const SceneRequest& request,
                           const RunOptions& options = {});

/// The second half of it, for callers that look at the images before. With `match`, that is called
/// in place of pipeline.run().
XGM_API SceneRun match_scene(const Pipeline& pipeline, SceneInputs inputs,
                             const RunOptions& options = {}, const MatchPair& match = {});

}  // namespace xgm
