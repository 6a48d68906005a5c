// SPDX-License-Identifier: Apache-2.0
// What cannot go well is found before anything is matched.
#pragma once

#include <string>
#include <vector>

#include "xgm/geo/stage/surface_family.hpp"

namespace xgm::geo {

/// Why nothing can come of a pair, and what to do; empty if something can.
std::string why_impossible(const SurfaceRequest& request, const SatelliteImage& base,
                           const SatelliteImage& match);

/// Leaves out pairs of which nothing can come, each with a warning. Throws UsageError if none is
/// left.
void keep_possible(const SurfaceRequest& request, std::vector<PairChoice>& pairs,
                   const Context& context);

}  // namespace xgm::geo
