// SPDX-License-Identifier: Apache-2.0
#include "choose_tiles.hpp"

#include <algorithm>

#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"

namespace xgm::tiles {
namespace {

constexpr int kSmallestTile = 256;  // below, most of what is matched is halo

/// Keeps the memory of volumes from tile to tile if it is hardly missed while maps are worked on.
TileOptions with_memory(const TilePlan& plan, TileOptions tiles, double limit) {
  constexpr double kHardly = 1.1;
  const double without = plan.tile(tiles).peak_bytes;
  tiles.keeps_memory = true;
  tiles.keeps_memory = plan.tile(tiles).peak_bytes <= std::min(limit, kHardly * without);
  return tiles;
}

}  // namespace

std::string size_text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height) + " px";
}

TileOptions tiles_of_size(cv::Size size) {
  TileOptions tiles;
  tiles.size = size;
  tiles.coarse_pixels = std::min(tiles.coarse_pixels, double{1} * size.width * size.height);
  return tiles;
}

TileOptions fitting(const TilePlan& plan, cv::Size whole, double limit) {
  for (int side = std::max(whole.width, whole.height);; side = side * 3 / 4) {
    const TileOptions tiles = tiles_of_size({side, side});
    const double bytes = plan.bytes(tiles);
    if (bytes <= limit) return with_memory(plan, tiles, limit);
    if (side > kSmallestTile) continue;
    throw UsageError("images of " + size_text(whole) + " take " + bytes_text(bytes) +
                     " even in tiles of " + size_text(tiles.size) + ", and --memory-limit allows " +
                     bytes_text(limit) +
                     "; raise --memory-limit, search fewer disparities, or match a part of the "
                     "images");
  }
}

TileOptions checked(const TilePlan& plan, cv::Size size, double limit) {
  const TileOptions tiles = tiles_of_size(size);
  const double bytes = plan.bytes(tiles);
  if (bytes <= limit) return with_memory(plan, tiles, limit);
  throw UsageError("tiles of " + size_text(size) + " take " + bytes_text(bytes) +
                   ", and --memory-limit allows " + bytes_text(limit) +
                   "; give smaller ones, or --tiles auto");
}

}  // namespace xgm::tiles
