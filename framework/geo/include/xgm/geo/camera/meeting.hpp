// SPDX-License-Identifier: Apache-2.0
// Where two lines of sight meet.
#pragma once

#include "xgm/geo/camera/rpc_camera.hpp"

namespace xgm::geo {

/// The point nearest to both, least squares, and their shortest distance. NaN if they are parallel.
struct Meeting {
  cv::Vec3d point;  ///< ECEF, m
  double gap = 0;   ///< m
};
XGM_API Meeting meet(const Ray& a, const Ray& b);

}  // namespace xgm::geo
