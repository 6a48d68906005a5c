// SPDX-License-Identifier: Apache-2.0
// Maps of disparities that come from outside, as results of stages.
#pragma once

#include "xgm/base/export.hpp"
#include "xgm/data/match.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::exchange {

/// Disparities of the pixel's range are matched; all others, and NaN, are out of range; masked
/// pixels are masked. Throws Error if there is no finite number although there is something to
/// match; `name` is what messages call it.
XGM_API DisparityMap to_matched(const cv::Mat1f& disparities, const MatchRequest& request,
                                const std::string& name);

/// Whether any candidate of any pixel lies in the match image.
XGM_API bool can_match(const MatchRequest& request);

/// Answers of rehearsals, see RunFacts, and where there is nothing to ask: the first candidate in
/// the match image; costs of 0.
XGM_API DisparityMap rehearsed_map(const MatchRequest& request);
XGM_API CostVolume rehearsed_costs(const ImagePair& pair, const VolumeShapePtr& shape,
                                   int max_cost);

}  // namespace xgm::exchange
