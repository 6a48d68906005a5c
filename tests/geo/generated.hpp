// SPDX-License-Identifier: Apache-2.0
// Generated scenes as the pipeline takes them.
#pragma once

#include <string>
#include <vector>

#include "xgm/geo/image/satellite_image.hpp"
#include "xgm/geo/synthesis/satellite_scene.hpp"

namespace xgm::testing {

/// A camera alone, without pixels.
inline geo::SatelliteImage image_of(const geo::RpcModel& camera, int size) {
  return {.name = "generated",
          .file = "generated",
          .band = 1,
          .mask = {},
          .size = {size, size},
          .camera = geo::RpcCamera(camera),
          .acquisition = {}};
}

/// Writes the scene and opens its images.
inline std::vector<geo::SatelliteImage> written_images(const std::string& folder,
                                                       const geo::SatelliteScene& scene) {
  geo::write_satellite_scene(folder, scene);
  std::vector<geo::SatelliteImage> images;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    images.push_back(geo::open_image(folder + "/image_" + std::to_string(i + 1) + ".tif"));
  }
  return images;
}

}  // namespace xgm::testing
