// SPDX-License-Identifier: Apache-2.0
// KITTI's calibration files: lines "NAME: numbers", of which the projection matrices are of use.
#pragma once

#include <string>

#include "xgm/data/calibration.hpp"

namespace xgm::kitti {

/// From the 3x4 projection matrices (m) of two rectified cameras, called "P_rect_02" (2015) or "P2"
/// (2012) for number 2. Throws Error with file and line if one is missing or faulty.
Calibration read_calibration(const std::string& file, int left, int right);

}  // namespace xgm::kitti
