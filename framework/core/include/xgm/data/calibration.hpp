// SPDX-License-Identifier: Apache-2.0
// The parameters of a rectified camera pair that are needed to compute depths.
#pragma once

namespace xgm {

/// The point of pixel (x, y) of the left image with disparity d is Z = baseline * focal / (d +
/// doffs), X = (x - cx) * Z / focal, Y = (y - cy) * Z / focal, in the unit of the baseline, from
/// the left camera: X to the right, Y down, Z forward.
struct Calibration {
  double focal = 0;     ///< px
  double cx = 0;        ///< principal point of the left camera, px
  double cy = 0;        ///< px
  double doffs = 0;     ///< cx of the right camera minus cx of the left, px
  double baseline = 0;  ///< mm
};

}  // namespace xgm
