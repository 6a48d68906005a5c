// SPDX-License-Identifier: Apache-2.0
// From the command line to what the library is asked to match.
#pragma once

#include "options/scene_options.hpp"
#include "xgm/pipeline/scene_inputs.hpp"

namespace xgm::cli {

/// The scene that is named, the images that are given, else the built-in sample pair. Opens no
/// image. Throws UsageError.
SceneRequest scene_request(const SceneOptions& options, const Registry& registry);

/// What is read beside a scene's own files: those of plugins, and the one that describes the data
/// set of the folder `scene`, if there is one.
std::vector<NamedFile> files_beside_scene(const Registry& registry, const std::string& scene,
                                          const std::string& dataset);
/// All that is read when these pipelines match the request.
std::vector<NamedFile> files_read(const SceneOptions& options, const SceneRequest& request,
                                  const std::vector<Pipeline>& pipelines, const Registry& registry);

}  // namespace xgm::cli
