// SPDX-License-Identifier: Apache-2.0
// The planes on which the disparities of segments lie.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plugins/filter/plane_filling/segments.hpp"

namespace xgm::plane_filling {

/// disparity = along_x * x + along_y * y + offset
struct Plane {
  float along_x = 0, along_y = 0, offset = 0;

  float at(int y, int x) const {
    return along_x * static_cast<float>(x) + along_y * static_cast<float>(y) + offset;
  }
};

struct Sample {
  cv::Point at;
  float disparity;
};

/// A sample farther from its plane is an outlier, px.
inline constexpr float kInlier = 1;

/// The plane with the least sum of min(|residual|, kInlier) that is found among a fixed number of
/// planes through three samples (random, but the same for the same samples), then by least squares
/// of its inliers. None if there are too few samples, or if less than half of them are inliers.
XGM_API std::optional<Plane> fit_plane(std::span<const Sample> samples);

/// The plane of each segment, from its pixels that have a disparity.
std::vector<std::optional<Plane>> fit_planes(const DisparityMap& map, const Segments& segments);

}  // namespace xgm::plane_filling
