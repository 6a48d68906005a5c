// SPDX-License-Identifier: Apache-2.0
// What a run has matched already of its windows.
#pragma once

#include <functional>

#include "xgm/data/match.hpp"
#include "xgm/stage/context.hpp"

namespace xgm::geo {

/// The map of the window that `context` stands for: as the run of the calling thread keeps it
/// (kept_results()), else as `match` makes it. It is known by a hash of the pixels and ranges that
/// are matched, so that one of other cameras, bounds or windows is never taken for it.
XGM_API DisparityMap kept_window(const MatchRequest& request, const Context& context,
                                 const std::function<DisparityMap()>& match);

}  // namespace xgm::geo
