// SPDX-License-Identifier: Apache-2.0
// A run's surface, and how it was made, as one page for people.
#pragma once

#include <string>

#include "xgm/geo/run/recorded_surface.hpp"

namespace xgm::geo {

/// HTML. The run has its record.
std::string surface_report(const std::string& title, const RecordedSurface& run);

}  // namespace xgm::geo
