// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "xgm/pipeline/pipeline.hpp"

namespace xgm::tiles {

/// Throws UsageError if the pipeline is of another family.
const StereoFamily& stereo_family(const Pipeline& pipeline);

}  // namespace xgm::tiles
