// SPDX-License-Identifier: Apache-2.0
// Simple generated stereo pairs for tests, first steps and plugin writers. They have no lens blur:
// each pixel shows exactly the point at its centre.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/synthesis/generate.hpp"

namespace xgm::synthesis {

struct PlainOptions {
  cv::Size size{160, 120};
  Interval disparities{0, 32};  ///< all surfaces lie in [begin, end - 1]; may be negative
  std::uint64_t seed = 1;       ///< each seed gives another scene
  int objects = 5;              ///< rectangles and ellipses in front of the background
  bool colour = false;          ///< three planes instead of one
  double gain = 1;              ///< exposure of the match image: gain * level + bias
  double bias = 0;              ///< grey levels
  double noise = 0;             ///< standard deviation in both views, grey levels
  VerticalShift shift;          ///< of the match image
  bool whole_levels = true;     ///< round to whole grey levels, as an 8-bit camera does
};

/// A slanted textured background with objects in front of it. The same options give the same bytes
/// on every machine. Throws Error if the size or the disparities are empty, or shift.b <= -1.
XGM_API GeneratedScene generate_plain(const PlainOptions& options);

/// The built-in sample pair: 640 x 480, colour, disparities [0, 64).
XGM_API GeneratedScene sample_pair();
/// The sample pair as a scene to match, with its ground truth.
XGM_API Scene sample_scene();

}  // namespace xgm::synthesis
