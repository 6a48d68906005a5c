// SPDX-License-Identifier: Apache-2.0
// Scenes in memory matched in tiles: what `pipeline run --tiles` does.
#pragma once

#include <optional>

#include "xgm/pipeline/scene_run.hpp"
#include "xgm/tiles/tiled_run.hpp"

namespace xgm::tiles {

/// The largest square tiles whose run stays within `limit` bytes of the process, of which `held`
/// are taken by what is kept of the whole scene. Throws UsageError if not even small ones do.
XGM_API TileOptions fitting_tiles(const Pipeline& pipeline, const MatchRequest& request,
                                  double held, double limit, const RunOptions& options);

/// For RecordRequest::match and match_scene(): in tiles of the given size, or without one of a size
/// that fits the scene's memory limit, else what is free. `pipeline` outlives the result.
XGM_API MatchPair in_tiles(const Pipeline& pipeline, std::optional<cv::Size> size);

}  // namespace xgm::tiles
