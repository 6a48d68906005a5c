// SPDX-License-Identifier: Apache-2.0
// Generated stereo pairs whose truth is known exactly: for tests, first steps and plugin writers.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/image.hpp"

namespace xgm::testing {

/// Rows that do not align: what a rectified pair would show at (x, y) of the match image is found
/// at (x, y + a * x + b * y + c) of the one delivered. Pixels; b > -1.
struct VerticalShift {
  double a = 0;
  double b = 0;
  double c = 0;

  double at(double x, double y) const { return a * x + b * y + c; }
};

struct SceneOptions {
  cv::Size size{160, 120};
  Interval disparities{0, 32};  ///< all surfaces lie in [begin, end - 1]; may be negative
  std::uint64_t seed = 1;       ///< another seed, another scene
  int objects = 5;              ///< rectangles and ellipses before the background
  bool colour = false;          ///< three planes instead of one
  double gain = 1;              ///< exposure of the match image: gain * level + bias
  double bias = 0;              ///< grey levels
  double noise = 0;             ///< standard deviation in both views, grey levels
  VerticalShift shift;          ///< of the match image
  bool whole_levels = true;     ///< round to whole grey levels, as an 8-bit camera does
};

/// A pair and all that is true of it. The sight is that of a pinhole: a pixel belongs to the
/// surface seen through its centre, and shows that surface's continuous texture at this very point.
struct SyntheticScene {
  ImagePair pair;
  cv::Mat1f truth;          ///< exact disparity of every base pixel
  cv::Mat1f reverse_truth;  ///< the same of every match pixel (x_base = x_match - d)
  cv::Mat1b non_occluded;   ///< 255 where a base pixel is seen in the match image, else 0
  Interval disparities;     ///< what a matcher has to search: as asked for
};

/// A slanted textured background with objects before it. The same options give the same bytes on
/// every machine. Throws Error if the size or the disparities are empty, or shift.b <= -1.
XGM_API SyntheticScene make_scene(const SceneOptions& options);

/// The built-in sample pair: 640 x 480, colour, disparities [0, 64).
XGM_API SyntheticScene sample_scene();

}  // namespace xgm::testing
