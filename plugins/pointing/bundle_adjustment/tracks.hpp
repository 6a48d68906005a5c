// SPDX-License-Identifier: Apache-2.0
// Points of the ground that two images or more show.
#pragma once

#include <vector>

#include "xgm/geo/image/keypoints.hpp"
#include "xgm/geo/stage/pairs.hpp"

namespace xgm::geo {

struct Observation {
  std::size_t image = 0;
  cv::Point2d pixel;
};

/// Observations of one point, at most one of an image, by ascending image.
using Track = std::vector<Observation>;

/// Joins the matches of all pairs: those that share a key point of an image show one point. Points
/// that would be two in one image are left out. `matches[i]` are those of `pairs[i]`.
XGM_API std::vector<Track> join_tracks(const std::vector<PairChoice>& pairs,
                                       const std::vector<std::vector<KeypointMatch>>& matches);

}  // namespace xgm::geo
