// SPDX-License-Identifier: Apache-2.0
// Pipelines from satellite images to a surface: `type: surface` at the top of a file.
#pragma once

#include <functional>
#include <vector>

#include "xgm/geo/ground/area.hpp"
#include "xgm/geo/image/point_cloud.hpp"
#include "xgm/geo/image/rectified_pair.hpp"
#include "xgm/geo/stage/cell_reason.hpp"
#include "xgm/geo/stage/fusion.hpp"
#include "xgm/geo/stage/pairs.hpp"
#include "xgm/geo/stage/surface.hpp"
#include "xgm/stage/pipeline.hpp"

namespace xgm::geo {

struct SurfaceRequest {
  std::vector<SatelliteImage> images;        ///< at least two
  std::shared_ptr<const HeightField> dem{};  ///< may be null
  /// West, south, east, north, degrees; empty: what the first image shows.
  std::optional<DegreeBox> area{};
  Outline outline{};  ///< within the area, outside of which there are no heights; none: all of it
  cv::Rect window{};  ///< of the first image, px, in place of an area; empty: none
  /// Told of every window when it has been matched.
  std::function<void(const RectifiedPair&, const DisparityMap&)> matched{};
};

/// Clouds of an earlier run, to be made a surface of again.
struct CloudRequest {
  CloudSet clouds;                  ///< at least one pair
  std::optional<DegreeBox> area{};  ///< as in SurfaceRequest; empty: what the points cover
  Outline outline{};
};

/// What the height of a cell was made of; the numbers are those of source.tif.
enum class HeightSource : std::uint8_t {
  none,      ///< has no height
  measured,  ///< at least one of the points in it was measured, or its points lie around it
  filled,    ///< all points in it have disparities that a filter has filled
};

struct SurfaceResult {
  GridSpec grid;
  FusedSurface fused;
  Raster orthoimage;                   ///< grey levels on the same grid
  cv::Mat1f gaps;                      ///< median of the points' gaps in each cell, m; NaN: unknown
  cv::Mat1b sources;                   ///< a HeightSource for each cell
  cv::Mat1b reasons;                   ///< a CellReason for each cell; empty if made of clouds
  std::vector<PointCloud> clouds;      ///< of each pair, x and y in the grid's CRS
  std::vector<Raster> surfaces;        ///< of each pair
  std::vector<SatelliteImage> images;  ///< with the cameras that were used; none if made of clouds
  std::vector<PairChoice> pairs;       ///< of these images
};

/// What a run is going to do, told before anything is matched.
struct WorkAhead {
  struct Window {
    cv::Size size;     ///< of the rectified images, px
    cv::Size shown;    ///< of the part of the base image whose points are kept
    double cells = 0;  ///< of the volumes
  };
  std::vector<Window> windows;            ///< of all pairs, in order
  std::optional<MatchRequest> largest{};  ///< the one with the most cells; set
  std::size_t pairs = 0;
  double surface_cells = 0;  ///< of the grid, about
};

class XGM_API SurfaceFamily : public PipelineFamily {
 public:
  virtual SurfaceResult run(const SurfaceRequest& request, const Context& context) const = 0;
  /// Points, rectifies and bounds the search as run() does. Throws what it throws.
  virtual WorkAhead look_ahead(const SurfaceRequest& request, const Context& context) const = 0;
  /// Makes the surface of clouds again, without matching: the stages surface and fusion alone.
  virtual SurfaceResult rasterise(CloudRequest request, const Context& context) const = 0;
};

}  // namespace xgm::geo
