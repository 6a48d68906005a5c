// SPDX-License-Identifier: Apache-2.0
// What a recorded run of a scene keeps.
#pragma once

#include "xgm/evaluation/recorded_run.hpp"

namespace xgm {

/// Throws UsageError if results are to be kept of a run that cannot go on from them. Opens no
/// image.
void check_keeping(const RecordRequest& request, const SceneRequest& scene);

/// `inputs` were read from `scene`. Throws UsageError.
Keeping keep_scene(const Pipeline& pipeline, const SceneRequest& scene, const SceneInputs& inputs,
                   const RecordRequest& request, Observer* observer);

}  // namespace xgm
