// SPDX-License-Identifier: Apache-2.0
// Key points all over a pair of images.
#pragma once

#include <vector>

#include "xgm/geo/image/keypoints.hpp"
#include "xgm/geo/stage/pointing.hpp"

namespace xgm::geo {

/// How key points are looked for.
struct TieSearch {
  double max_offset = 20;
  int window = 1000;
  int windows = 4;
};
void describe(TieSearch& search, ParameterSet& set);

/// Of windows evenly spread over the base image, the outermost at its borders; of a side that is
/// shorter than one and a half windows, one in the middle.
std::vector<KeypointMatch> find_ties(const SatelliteImage& base, const SatelliteImage& match,
                                     const HeightInterval& heights, const TieSearch& search);

}  // namespace xgm::geo
