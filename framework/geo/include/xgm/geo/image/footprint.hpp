// SPDX-License-Identifier: Apache-2.0
// Where the ground lies that an image shows.
#pragma once

#include <optional>

#include "xgm/geo/ground/area.hpp"
#include "xgm/geo/image/satellite_image.hpp"

namespace xgm::geo {

/// Bounds of the ground of these heights that a window of the image shows. Empty if the camera
/// reaches none of it.
XGM_API std::optional<DegreeBox> footprint(const SatelliteImage& image, const cv::Rect& window,
                                           const HeightInterval& heights);

}  // namespace xgm::geo
