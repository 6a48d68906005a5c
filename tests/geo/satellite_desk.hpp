// SPDX-License-Identifier: Apache-2.0
// A folder with a small satellite scene, in which the program is called.
#pragma once

#include <string>

#include "apps/program.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/image/satellite_image.hpp"
#include "xgm/geo/synthesis/satellite_scene.hpp"

namespace xgm::testing {

/// scene/image_1.tif, image_2.tif, dem.tif, dsm.tif, ...; the images have 128 x 128 px.
struct SatelliteDesk : TemporaryFolder {
  SatelliteDesk();
  Outcome call(const std::string& arguments, const std::string& before = {}) const {
    return pipeline(path(), arguments, before);
  }
  /// The second image's pixels as one more image of so many bands.
  void write_image(const std::string& name, int bands, bool with_camera = true) const;
  /// A raster that consists of another one.
  void write_vrt(const std::string& name, const std::string& of) const;
  /// Bounds of what both images show, degrees.
  cv::Vec4d ground() const;

  geo::SatelliteScene scene;
};

/// "WEST,SOUTH,EAST,NORTH"
std::string text_of(const cv::Vec4d& box);

}  // namespace xgm::testing
