// SPDX-License-Identifier: Apache-2.0
// One candidate for each hole, so that neighbours agree unless an image edge parts them.
#pragma once

#include <vector>

#include "plugins/filter/plane_filling/candidates.hpp"

namespace xgm::plane_filling {

struct Smoothness {
  float slope = 0.3F;  ///< cost of a difference between neighbours, per px
  float jump = 1;      ///< the most that a difference costs
  float sigma = 10;    ///< grey levels by which costs fall to 1 / e
};

/// The number of the chosen candidate of each hole; 0 where there is none to choose from. `costs`
/// has one entry for each candidate. Minimises the costs plus the smoothness of neighbours along 8
/// paths through the holes, as semi-global matching does; pixels that have a disparity keep it.
XGM_API std::vector<std::size_t> choose(const Holes& holes, const CandidateLists& candidates,
                                        const std::vector<float>& costs, const DisparityMap& map,
                                        const Smoothness& smoothness);

}  // namespace xgm::plane_filling
