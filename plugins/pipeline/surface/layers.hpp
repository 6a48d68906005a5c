// SPDX-License-Identifier: Apache-2.0
// What the points of all pairs in a cell say beside its height.
#pragma once

#include "xgm/geo/stage/surface_family.hpp"

namespace xgm::geo {

/// Fills the gaps and the sources of a result that has grid, fused heights and clouds.
void add_layers(SurfaceResult& result);

}  // namespace xgm::geo
