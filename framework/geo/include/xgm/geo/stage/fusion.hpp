// SPDX-License-Identifier: Apache-2.0
// Kind "fusion": one surface of those of several pairs.
#pragma once

#include <string_view>
#include <vector>

#include "xgm/geo/ground/raster.hpp"
#include "xgm/plugin.hpp"

namespace xgm::geo {

struct FusedSurface {
  Raster heights;
  cv::Mat1f count;  ///< pairs that have a height in the cell
  cv::Mat1f
      spread;  ///< of their heights, m: median distance from the fused one; NaN: fewer than two
  std::vector<double> offsets;  ///< found and taken out, m, of each surface
};

class XGM_API Fusion : public Stage {
 public:
  static constexpr std::string_view kKind = "fusion";
  static constexpr std::string_view kMeaning = "makes one surface of those of several pairs";

  /// At least one surface; all on one grid.
  virtual FusedSurface run(const std::vector<Raster>& surfaces, const Context& context) const = 0;
};

}  // namespace xgm::geo
