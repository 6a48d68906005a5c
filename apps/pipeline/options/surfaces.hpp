// SPDX-License-Identifier: Apache-2.0
// Pipelines that make surfaces of satellite images.
#pragma once

#include "xgm/pipeline/pipeline.hpp"

namespace xgm::cli {

/// Always false in a program without the room geo.
bool makes_surfaces(const Pipeline& pipeline);

}  // namespace xgm::cli
