// SPDX-License-Identifier: Apache-2.0
// Cameras, images and stages that several tests need.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "xgm/geo/image/satellite_image.hpp"
#include "xgm/geo/registry.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/plugin.hpp"

namespace xgm::testing {

/// A stage of geo from YAML. Throws Error if it is faulty.
template <class Kind>
std::shared_ptr<const Kind> geo_stage(const std::string& yaml) {
  Registry registry = Registry::with_builtins();
  geo::add_geo(registry);
  return make_stage<Kind>(yaml, registry);
}

/// An image without pixels: its name is its file.
geo::SatelliteImage image_with(const std::string& name, const geo::RpcCamera& camera,
                               cv::Size size);

/// Two images of 10,000 px whose epipolar lines are curved by some pixels, 15 degrees apart, of
/// ground at longitude 55.7, latitude -21.2 and heights 0 to 2400 m. Both are called "curved".
std::pair<geo::SatelliteImage, geo::SatelliteImage> curved_pair();

}  // namespace xgm::testing
