// SPDX-License-Identifier: Apache-2.0
// KITTI's calibration files: lines "NAME: numbers", of which the projection matrices are of use.
#pragma once

#include <opencv2/core/types.hpp>
#include <string>

#include "xgm/data/calibration.hpp"

namespace xgm::kitti {

struct Cameras {
  Calibration calibration;
  cv::Size size;  ///< of the left camera's images, px; 0 = not said (2012)
};

/// From the 3x4 projection matrices (m) of two rectified cameras, called "P_rect_02" (2015) or "P2"
/// (2012) for number 2, and the size of their images ("S_rect_02"). Throws Error with file and line
/// if a matrix is missing, or a line is faulty or there twice.
Cameras read_cameras(const std::string& file, int left, int right);

}  // namespace xgm::kitti
