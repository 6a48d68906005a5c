// SPDX-License-Identifier: Apache-2.0
// Heights counted from another surface.
#pragma once

#include <string>

#include "xgm/geo/ground/raster.hpp"

namespace xgm::geo {

/// The heights of all cells after a transformation from the raster's CRS, m; NaN stays NaN. Throws
/// Error for cells that lie outside of what it can transform.
XGM_API cv::Mat1d transformed_heights(const Raster& raster, const CrsTransform& transform);

/// Heights above the ellipsoid as those above a geoid, "egm96" or another of with_heights(), which
/// the CRS of the result and its "vertical_datum" say. `heights` has a horizontal CRS. Throws Error
/// if PROJ lacks the geoid's grid.
XGM_API Raster above_geoid(const Raster& heights, const std::string& geoid);

/// Throws UsageError if above_geoid() cannot work here: an unknown name, or a missing grid.
XGM_API void require_geoid(const std::string& geoid);

}  // namespace xgm::geo
