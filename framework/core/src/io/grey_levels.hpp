// SPDX-License-Identifier: Apache-2.0
// From the values of two files to the grey levels of a pair: the same for whole images and windows.
#pragma once

#include <limits>
#include <string>

#include "io/unscaled_image.hpp"
#include "xgm/data/image.hpp"

namespace xgm {

/// level = (value - offset) * gain
struct Scaling {
  double offset = 0;
  double gain = 1;
  std::string note{};
};

/// Of the values of pixels with data.
struct Extremes {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(const UnscaledImage& raster);
};

/// `values`: of both images.
Scaling choose_scaling(int depth, const Extremes& values);

/// What two images of a pair have to share.
struct Stored {
  std::string file;
  cv::Size size;
  int depth = CV_8U;
};

/// Throw Error.
void require_same(const Stored& left, const Stored& right);
void require_mask_of(const Stored& image, const std::string& mask, cv::Size size);

/// Uses the raster up: planes that nobody shares are scaled in place, no second copy is held.
Image to_image(UnscaledImage raster, const Scaling& scaling);

inline constexpr const char* kMatchedAsGrey =
    "one image is grey and the other colour: both are matched as grey";

}  // namespace xgm
