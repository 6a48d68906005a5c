// SPDX-License-Identifier: Apache-2.0
// What an image shows: sights meet the surface, under the sun of its date.
#pragma once

#include "ground/height_grid.hpp"
#include "synthesis/landscape.hpp"
#include "synthesis/map_frame.hpp"

namespace xgm::geo {

struct Photograph {
  cv::Mat1w image;    ///< grey levels
  cv::Mat1f heights;  ///< of what the centres of pixels show
};

/// `number` of the view in the spec. Four sights per pixel.
Photograph photograph(const SatelliteSceneSpec& spec, int number, const Landscape& land,
                      const HeightGrid& grid, const Sights& sights, const MapFrame& frame);

/// 255 for the cells of the surface that the image shows, 128 for those that would be in it if
/// nothing stood before them, 0 for those beside it.
cv::Mat1b visible_cells(const PushbroomCamera& camera, const Landscape& land,
                        const HeightGrid& grid, const MapFrame& frame);

}  // namespace xgm::geo
