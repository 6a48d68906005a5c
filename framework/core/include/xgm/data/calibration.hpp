// SPDX-License-Identifier: Apache-2.0
// The cameras of a rectified pair, as far as depth needs them.
#pragma once

namespace xgm {

/// A pixel (x, y) of the left image with disparity d lies at Z = baseline * focal / (d + doffs),
/// X = (x - cx) * Z / focal, Y = (y - cy) * Z / focal: right, down and forward of the left camera,
/// in the baseline's unit.
struct Calibration {
  double focal = 0;     ///< px
  double cx = 0;        ///< principal point of the left camera, px
  double cy = 0;        ///< px
  double doffs = 0;     ///< cx of the right camera minus cx of the left, px
  double baseline = 0;  ///< mm
};

}  // namespace xgm
