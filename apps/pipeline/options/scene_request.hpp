// SPDX-License-Identifier: Apache-2.0
// From the command line to what the library is asked to match.
#pragma once

#include "options/scene_options.hpp"
#include "xgm/pipeline/scene_inputs.hpp"

namespace xgm::cli {

/// The scene that is named, the images that are given, else the built-in sample pair. Opens no
/// image. Throws UsageError.
SceneRequest scene_request(const SceneOptions& options, const Registry& registry);

}  // namespace xgm::cli
