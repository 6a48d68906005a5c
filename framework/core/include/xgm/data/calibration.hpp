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

/// The same of images that are so many times smaller, as halve() makes them.
inline Calibration reduced(const Calibration& full, double scale) {
  return {full.focal / scale, (full.cx + 0.5) / scale - 0.5, (full.cy + 0.5) / scale - 0.5,
          full.doffs / scale, full.baseline};
}

/// The same of windows of both images that begin at pixel (x, y).
inline Calibration moved(const Calibration& whole, int x, int y) {
  return {whole.focal, whole.cx - x, whole.cy - y, whole.doffs, whole.baseline};
}

}  // namespace xgm
