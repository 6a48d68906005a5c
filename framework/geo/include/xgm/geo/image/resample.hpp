// SPDX-License-Identifier: Apache-2.0
// Rectified images, made of the original ones.
#pragma once

#include "xgm/data/image.hpp"
#include "xgm/geo/image/rectified_pair.hpp"

namespace xgm::geo {

/// How the grey levels of an image become 0 to 255: values up to `black` are 0, from `white` on
/// 255.
struct GreyScale {
  double black = 0;
  double white = 255;
};

/// From the darkest to the lightest pixels of the whole image but for `tail` of them at both ends.
XGM_API GreyScale find_grey_scale(const SatelliteImage& image, double tail = 0.005);

/// Both images as the rectification sees them, bicubic (Keys: Cubic convolution interpolation for
/// digital image processing, IEEE TASSP 1981, a = -1/2). A pixel is valid where all samples that it
/// is made of are.
XGM_API ImagePair resample(const RectifiedPair& pair, const GreyScale& base,
                           const GreyScale& match);

}  // namespace xgm::geo
