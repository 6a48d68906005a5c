// SPDX-License-Identifier: Apache-2.0
// What a stage is going to be given, and what it will take: told before any pixel is read.
#pragma once

#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"

namespace xgm {

/// The inputs of a stage in numbers. Bytes and counts are doubles: most are products of large ones,
/// and some are estimates.
struct XGM_API Workload {
  cv::Size size;               ///< of the images, px
  int planes = 1;              ///< of each image
  bool masked = false;         ///< whether the images have masks
  double used = 1;             ///< share of the base pixels that have data, 0 to 1
  Interval range;              ///< every disparity that is searched lies in it
  double cells_per_pixel = 0;  ///< mean VolumeShape::room() of the pixels that have data
  bool ragged = false;         ///< whether pixels search disparities of their own
  bool estimated = false;      ///< whether cells_per_pixel is a guess: it depends on the scene
  int threads = 1;

  /// All pixels search all of `range`.
  static Workload dense(cv::Size size, int planes, Interval range);
  /// Cells of a pixel that searches so many disparities: a multiple of VolumeShape::kGranule.
  static double room(int disparities);

  double pixels() const { return static_cast<double>(size.width) * size.height; }
  double cells() const { return pixels() * used * cells_per_pixel; }
  double map_bytes() const;    ///< of a DisparityMap
  double image_bytes() const;  ///< of one Image
  double range_bytes() const;  ///< of a DisparityRange
  double shape_bytes() const;  ///< of a VolumeShape
};

/// What run() of a stage takes.
struct Needs {
  double volumes = 0;  ///< bytes of the volumes that it returns
  double others = 0;   ///< bytes of all else that it returns
  double working = 0;  ///< bytes beside these and its inputs, the most at one time
  double updates = 0;  ///< rounds of its innermost loop: its seconds grow with them
  double moved = 0;    ///< bytes of volumes that it reads and writes
};

/// What a finer level of a pyramid searches: `spread + lost * D` cells per pixel, of the D
/// disparities of its limits. Most pixels search around what the coarser level found, whatever the
/// scale; a share of them has lost its disparity and searches everything.
struct Narrowing {
  double spread = 24;
  double lost = 0.15;
};

}  // namespace xgm
