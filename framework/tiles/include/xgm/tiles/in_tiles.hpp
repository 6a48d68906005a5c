// SPDX-License-Identifier: Apache-2.0
// Scenes matched in tiles: what `pipeline run --tiles` and --memory-limit do.
#pragma once

#include <optional>

#include "xgm/pipeline/scene_run.hpp"
#include "xgm/tiles/tiled_run.hpp"

namespace xgm::tiles {

/// The largest square tiles whose run stays within `limit` bytes of the process. Throws UsageError
/// if not even small ones do.
XGM_API TileOptions fitting_tiles(const Pipeline& pipeline, const TiledRequest& request,
                                  const Besides& besides, double limit, const RunOptions& options);

/// In tiles of the given size, or without one of a size that fits the scene's memory limit, else
/// what is free. `pipeline` outlives the result.
XGM_API ChooseParts in_tiles(const Pipeline& pipeline, std::optional<cv::Size> size);

/// In tiles only if the scene as a whole does not fit its memory limit.
XGM_API ChooseParts in_tiles_if_needed(const Pipeline& pipeline);

}  // namespace xgm::tiles
