// SPDX-License-Identifier: Apache-2.0
// The cameras of a rectified pair, as calibration files of several formats have them.
#pragma once

#include <string>

namespace xgm::dataset {

struct Camera {
  std::string place;  ///< "folder/calib.txt:3", for messages
  std::string name;   ///< "cam0"
  double focal, cx, cy;
};

/// Throws Error that begins with the place of the right camera unless both have one focal length
/// (within 0.1 %) and one row of the principal point (within 1 px).
void require_rectified(const Camera& left, const Camera& right);

}  // namespace xgm::dataset
