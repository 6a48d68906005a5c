// SPDX-License-Identifier: Apache-2.0
// Some pixels of a line, and all that is known of them before their path costs are.
#pragma once

#include <cstdint>

#include "plugins/aggregation/path_engine/pixel_step.hpp"

namespace xgm::aggregation {

/// Where pixels have their cells, and where those are that their paths look back at. Found for many
/// pixels at a time, array by array in loops that vectors can do: pixel by pixel it would take
/// longer than all arithmetic of a slice of 32 disparities.
struct LineLayout {
  static constexpr int kPixels = 32;
  static constexpr int kAhead = 4;  ///< pixels, for what is fetched ahead

  static constexpr int kNone = -1;     ///< base classes of no pixel
  static constexpr int kUnknown = -2;  ///< those of a pixel whose classes have to be looked up

  int first;  ///< pixel of the line that the elements 0 are of

  int begin[kPixels] = {}, count[kPixels];  ///< the slice
  /// Its cells, a multiple of VolumeShape::kGranule, all of which may be read and written. None if
  /// there is nothing to do about this pixel, or no such pixel.
  int room[kPixels];
  std::int64_t offset[kPixels + kAhead];  ///< of the slice in volumes
  int base_classes[kPixels];              ///< of all steps, if they are in one byte
  int own[kPixels];                       ///< cell of the line's path costs that it begins with
  /// The same of what a step looks back at: cell that disparity `begin` has there.
  int back[kMaxSteps][kPixels];
  /// Negative if that is not there for all steps, or does not hold all disparities.
  int odd[kPixels];
};

}  // namespace xgm::aggregation
