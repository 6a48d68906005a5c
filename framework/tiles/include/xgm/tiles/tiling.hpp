// SPDX-License-Identifier: Apache-2.0
// What a tile has to look at.
#pragma once

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"

namespace xgm::tiles {

/// What is read and searched for a part of the map, its core.
struct Surroundings {
  cv::Rect searched;  ///< pixels of the base image that get a disparity
  cv::Rect
      reverse_searched;  ///< pixels of the match image that get one, for the check of both views
  cv::Rect window;       ///< pixels that are read of both images
};

/// `halo`: pixels around what is wanted that take part. `disparities`: the hull of what is
/// searched in the core and its halo. Sides of the window are multiples of `alignment`, or the
/// image's.
XGM_API Surroundings surroundings(const cv::Rect& core, int halo, Interval disparities,
                                  cv::Size image, int alignment = 1);

}  // namespace xgm::tiles
