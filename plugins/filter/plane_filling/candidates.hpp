// SPDX-License-Identifier: Apache-2.0
// The planes that each hole may belong to: that of its own segment, and those of the segments
// around it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plugins/filter/plane_filling/holes.hpp"
#include "plugins/filter/plane_filling/planes.hpp"

namespace xgm::plane_filling {

struct Candidate {
  Plane plane;
  float disparity;  ///< of the plane at the hole, px
  float
      path;  ///< sum of the colour differences on the way to where the plane was found, grey levels
};

/// Of one hole: from each direction, of its own segment, and what it had.
inline constexpr std::size_t kMostCandidates = kDirections + 2;

/// Those of hole i have the numbers from begin[i] to begin[i + 1].
struct CandidateLists {
  std::vector<std::size_t> begin;
  std::vector<Candidate> all;

  std::span<const Candidate> of(std::size_t hole) const {
    return {all.data() + begin[hole], begin[hole + 1] - begin[hole]};
  }
};

/// Of the holes that shall be filled. Along 8 straight paths the first pixel with a disparity is
/// looked for; it offers the plane of its segment if it lies on it, else the plane that faces the
/// camera. No plane is offered twice, nor one that leaves the disparities of the map.
/// `doubted` is what holes had that lost their disparity because it is doubtful: they may get it
/// back.
XGM_API CandidateLists find_candidates(const Holes& holes, const DisparityMap& map,
                                       const cv::Mat1f& doubted, const Segments& segments,
                                       const std::vector<std::optional<Plane>>& planes);

}  // namespace xgm::plane_filling
