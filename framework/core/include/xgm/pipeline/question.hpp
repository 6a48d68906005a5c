// SPDX-License-Identifier: Apache-2.0
// Whether two runs give the same maps, told before they are made.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/base/json.hpp"
#include "xgm/pipeline/scene_inputs.hpp"

namespace xgm {

/// What decides of any run of a pipeline: the program ("program", by the hash of the libraries),
/// `plugin_files`, the pipeline with all parameters. Throws Error.
XGM_API Json question_of(const Pipeline& pipeline, const std::vector<std::string>& plugin_files);

/// All that decides of the maps of a scene, by names that people know: what decides of any run,
/// the content of the images, masks and range maps that `inputs` were read from, what means no
/// data, the disparities. Runs with equal questions give the same bytes. Throws Error.
XGM_API Json question_of(const Pipeline& pipeline, const SceneRequest& request,
                         const SceneInputs& inputs, const std::vector<std::string>& plugin_files);

/// The part of it that decides of what the matcher finds: without what comes after.
XGM_API Json question_of_matcher(Json question);

/// Of the pixels and ranges that are matched, for a request that is no part of a scene.
XGM_API std::string hash_of(const MatchRequest& request);

/// What they differ in: "pipeline.matcher.scale, left image"; empty if they are equal.
XGM_API std::string difference(const Json& a, const Json& b);

}  // namespace xgm
