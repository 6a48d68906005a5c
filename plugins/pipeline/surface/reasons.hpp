// SPDX-License-Identifier: Apache-2.0
// No silent hole: what became of every pixel of a pair, and so of every cell of the surface.
#pragma once

#include <memory>
#include <vector>

#include "xgm/data/match.hpp"
#include "xgm/geo/ground/area.hpp"
#include "xgm/geo/image/point_grid.hpp"
#include "xgm/geo/image/rectified_pair.hpp"
#include "xgm/geo/stage/cell_reason.hpp"
#include "xgm/geo/stage/surface.hpp"

namespace xgm::geo {

/// What is kept of a window that was matched until the grid is known.
struct SeenWindow {
  cv::Rect window;  ///< of the base image
  std::shared_ptr<const Rectification> geometry;
  cv::Mat1b reasons;      ///< a CellReason for each pixel of the rectified base image
  cv::Mat1f heights;      ///< of their points, m; NaN where there is none
  cv::Mat1b match_valid;  ///< 0 where the rectified match image has no data
};

struct SeenPair {
  SatelliteImage base;
  SatelliteImage match;
  std::vector<SeenWindow> windows;
};

SeenWindow remember(const cv::Rect& window, const RectifiedPair& pair, const MatchRequest& matching,
                    const DisparityMap& map, const PointGrid& points);

/// A CellReason for each cell. An empty cell is looked for in both images of each pair where it
/// would be seen if it were as high as the lowest of the nearest cells that have a height, to the
/// left, right, above and below. The pixel of the rectified base image there tells what became of
/// it. If it has a point, that one is in another cell: far above (more than three cells' sizes) it
/// hides this one, else this one lies between points.
cv::Mat1b explain_cells(const GridSpec& grid, const cv::Mat1f& fused,
                        const std::vector<Raster>& surfaces, const std::vector<SeenPair>& pairs);

/// Cells outside of the outline are wanted by nobody: not seen.
void mark_outside(const Outline& outline, const GridSpec& grid, cv::Mat1b& reasons);

}  // namespace xgm::geo
