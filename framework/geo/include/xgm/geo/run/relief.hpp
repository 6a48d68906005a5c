// SPDX-License-Identifier: Apache-2.0
// A surface for the eye.
#pragma once

#include <opencv2/core.hpp>

#include "xgm/geo/ground/raster.hpp"

namespace xgm::geo {

/// Heights in colours, shaded as by a sun in the north-west, 45 degrees high (Horn: Hill shading
/// and the reflectance map, Proc. IEEE 69, 1981), with a legend in metres. Cells of the raster are
/// in metres.
XGM_API cv::Mat3b relief_picture(const Raster& surface);

}  // namespace xgm::geo
