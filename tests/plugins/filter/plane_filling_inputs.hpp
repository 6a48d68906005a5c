// SPDX-License-Identifier: Apache-2.0
// What tests of the parts of plane_filling share.
#pragma once

#include "plugins/filter/plane_filling/planes.hpp"
#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"

namespace xgm::testing {

inline bool inside(cv::Size size, cv::Point p) { return cv::Rect({}, size).contains(p); }

/// A guide with a mask whose masked pixels have wild levels. Levels have fractions: else floats and
/// doubles round to different sides.
inline Image masked_guide(cv::Size size, int planes, std::uint64_t seed) {
  Image image = random_guide(size, planes, seed).base;
  image.valid = random_mask(size, 0.1, seed + 1);
  Random random(seed);
  for (cv::Mat1f& plane : image.planes) {
    for (float& level : plane) level += static_cast<float>(random.real(0, 1));
    plane.setTo(1000.0F * static_cast<float>(seed), image.valid == 0);
  }
  return image;
}

inline plane_filling::Plane random_plane(Random& random) {
  return {static_cast<float>(random.real(-0.2, 0.2)), static_cast<float>(random.real(-0.2, 0.2)),
          static_cast<float>(random.real(0, 20))};
}

}  // namespace xgm::testing
