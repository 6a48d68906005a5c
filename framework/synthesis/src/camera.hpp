// SPDX-License-Identifier: Apache-2.0
// From the light at each pixel to its grey level, with all that goes wrong on the way.
#pragma once

#include "xgm/synthesis/generate.hpp"

namespace xgm::synthesis {

/// Replaces light by what the camera of the base or of the match view makes of it.
void expose(Image& image, const Options& options, bool match);

}  // namespace xgm::synthesis
