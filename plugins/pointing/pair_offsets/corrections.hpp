// SPDX-License-Identifier: Apache-2.0
// What pairs are off in the match image, and the corrections of all images that take it out.
#pragma once

#include <vector>

#include "xgm/geo/stage/pointing.hpp"

namespace xgm::geo {

/// How far a pair is off in one direction, and how corrections of its cameras change that.
struct PairOffset {
  PairChoice pair;
  cv::Vec2d base, match;  ///< what moving the image by a pixel adds
  double offset = 0;      ///< px
};

/// The median of what matches lie beside where they should, `offsets`, in a direction of length 1
/// in the match image. `here` is a pixel of the base image and `height` that of its ground.
PairOffset pair_offset(const std::vector<SatelliteImage>& images, const PairChoice& pair,
                       const cv::Vec2d& direction, std::vector<double> offsets, cv::Point2d here,
                       double height);

/// The smallest moves of all images that take the offsets of all pairs out, least squares.
std::vector<SatelliteImage> without(const std::vector<PairOffset>& offsets,
                                    std::vector<SatelliteImage> images);

}  // namespace xgm::geo
