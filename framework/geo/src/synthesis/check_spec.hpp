// SPDX-License-Identifier: Apache-2.0
// Whether what a scene is asked to be makes sense.
#pragma once

#include "xgm/geo/synthesis/satellite_scene.hpp"

namespace xgm::geo {

/// Throws UsageError, which names the value and its range.
void require_within(const std::string& name, double value, double low, double high);
void check(const SatelliteSceneSpec& spec);

}  // namespace xgm::geo
