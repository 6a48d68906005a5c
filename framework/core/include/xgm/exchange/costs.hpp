// SPDX-License-Identifier: Apache-2.0
// Cost volumes in files of NumPy.
#pragma once

#include <string>

#include "xgm/base/export.hpp"
#include "xgm/config/parameters.hpp"
#include "xgm/data/image.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::exchange {

/// How numbers of a file become costs: min(max_cost, round(scale * number)). A number that is not
/// finite, or 255 of bytes, is not known: max_cost.
struct CostScale {
  double scale = 1;
  int max_cost = 254;
};

XGM_API void declare(CostScale& scale, ParameterSet& set);

/// Where the numbers of a file lie.
struct CostFile {
  std::string name;
  int first = 0;             ///< disparity of the first number of a pixel
  bool is_mirrored = false;  ///< columns run from right to left, disparities have the other sign
};

/// Shape (height, width, disparities), uint8, float32 or float64. Throws Error unless the file has
/// the size of the shape and all disparities of its hull, and none of its numbers is negative.
/// Candidates outside of the match image, or without data there, are kNoMatch.
XGM_API CostVolume read_costs(const CostFile& file, const ImagePair& pair,
                              const VolumeShapePtr& shape, const CostScale& scale);

}  // namespace xgm::exchange
