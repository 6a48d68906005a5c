// SPDX-License-Identifier: Apache-2.0
// Of which size tiles are.
#pragma once

#include <string>

#include "tile_plan.hpp"

namespace xgm::tiles {

/// "2000 x 2000 px"
std::string size_text(cv::Size size);

/// No more is matched at once in the coarse levels than in a tile.
TileOptions tiles_of_size(cv::Size size);

/// The largest square ones that stay within `limit` bytes. Throws UsageError if not even small ones
/// do.
TileOptions fitting(const TilePlan& plan, cv::Size whole, double limit);

/// Those of the given size. Throws UsageError if they do not fit the limit.
TileOptions checked(const TilePlan& plan, cv::Size size, double limit);

}  // namespace xgm::tiles
