// SPDX-License-Identifier: Apache-2.0
// Layout of a few pixels of a line: where their cells lie, found before path costs are computed.
#pragma once

#include <cstdint>

#include "plugins/aggregation/path_engine/pixel_step.hpp"

namespace xgm::aggregation {

/// Where the cells of each pixel lie, and the cells of previous pixels that its steps read. The
/// layout is computed for many pixels at a time, array by array, in loops that compilers vectorise:
/// pixel by pixel it would take longer than all arithmetic of a slice of 32 disparities.
struct LineLayout {
  static constexpr int kPixels = 32;
  static constexpr int kAhead = 4;  ///< pixels by which costs and sums are prefetched

  static constexpr int kUnknown = -2;  ///< the base classes do not fit one byte: look them up

  int first;  ///< element k describes pixel first + k of the line

  int begin[kPixels] = {}, count[kPixels];  ///< first disparity and length of the slice
  /// Cells of the slice that may be read and written, a multiple of VolumeShape::kGranule. 0 if the
  /// pixel has no disparities to search or does not exist.
  int room[kPixels];
  std::int64_t offset[kPixels + kAhead];  ///< of the slice in the volumes
  int base_classes[kPixels];              ///< of all steps, packed into a byte
  int own[kPixels];                       ///< first cell of the pixel in the line's path costs
  /// Cell of disparity `begin` in the path costs of each step's previous pixel.
  int back[kMaxSteps][kPixels];
  /// Negative if, for some step, the previous pixel does not exist or its path costs in memory do
  /// not cover all disparities that the step reads.
  int odd[kPixels];
};

}  // namespace xgm::aggregation
