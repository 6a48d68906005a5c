// SPDX-License-Identifier: Apache-2.0
// Generated stereo pairs for tests, first steps and plugin writers: plain ones of
// xgm/synthesis.hpp, seen without a lens, so that each pixel shows exactly what lies at its centre.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/synthesis.hpp"

namespace xgm::testing {

using synthesis::VerticalShift;
using SyntheticScene = synthesis::GeneratedScene;

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

/// A slanted textured background with objects before it. The same options give the same bytes on
/// every machine. Throws Error if the size or the disparities are empty, or shift.b <= -1.
XGM_API SyntheticScene make_scene(const SceneOptions& options);

/// The built-in sample pair: 640 x 480, colour, disparities [0, 64).
XGM_API SyntheticScene sample_scene();

}  // namespace xgm::testing
