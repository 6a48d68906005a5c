// SPDX-License-Identifier: Apache-2.0
// Points that two images show alike.
#pragma once

#include <vector>

#include "xgm/geo/image/satellite_image.hpp"

namespace xgm::geo {

struct KeypointMatch {
  cv::Point2d base;   ///< pixel
  cv::Point2d match;  ///< pixel
  double across = 0;  ///< px that `match` lies beside the epipolar line of `base`
  cv::Vec2d normal;   ///< unit vector in the match image, to which `across` belongs
};

/// SIFT key points of a window of the base image (Lowe: Distinctive image features from
/// scale-invariant keypoints, IJCV 2004) that match one of the part of the other image where ground
/// of these heights is seen, no farther than `max_offset` px from their epipolar line. The same
/// result for any number of threads.
XGM_API std::vector<KeypointMatch> match_keypoints(const SatelliteImage& base,
                                                   const SatelliteImage& match,
                                                   const cv::Rect& window,
                                                   const HeightInterval& heights,
                                                   double max_offset);

}  // namespace xgm::geo
