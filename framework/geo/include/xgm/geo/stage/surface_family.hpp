// SPDX-License-Identifier: Apache-2.0
// Pipelines from satellite images to a surface: `type: surface` at the top of a file.
#pragma once

#include <vector>

#include "xgm/geo/stage/fusion.hpp"
#include "xgm/geo/stage/pairs.hpp"
#include "xgm/geo/stage/surface.hpp"
#include "xgm/stage/pipeline.hpp"

namespace xgm::geo {

struct SurfaceRequest {
  std::vector<SatelliteImage> images;        ///< at least two
  std::shared_ptr<const HeightField> dem{};  ///< may be null
  /// West, south, east, north, degrees; empty: what the first image shows.
  std::optional<cv::Vec4d> area{};
};

struct SurfaceResult {
  GridSpec grid;
  FusedSurface fused;
  Raster orthoimage;                   ///< grey levels on the same grid
  std::vector<SatelliteImage> images;  ///< with the cameras that were used
  std::vector<PairChoice> pairs;
  std::vector<Raster> surfaces;  ///< of each pair
};

class XGM_API SurfaceFamily : public PipelineFamily {
 public:
  virtual SurfaceResult run(const SurfaceRequest& request, const Context& context) const = 0;
};

}  // namespace xgm::geo
