// SPDX-License-Identifier: Apache-2.0
// The paper's section "DEM-Sculpting for Satellite Stereo Matching": two copies of a surface, moved
// up and down, bound the disparities of every pixel. The steps are those of the paper.
#pragma once

#include <string>

#include "xgm/geo/stage/range_prior.hpp"

namespace xgm::geo {

struct SculptingParameters {
  double upper = 0.5;
  double lower = 0.15;
  double margin = 15;
  int step = 8;
};

/// `surface` is what texts call the surface: "the DEM".
void describe_sculpting(SculptingParameters& p, ParameterSet& set, const std::string& surface);

/// Step 1, by which heights the surface is moved down (min) and up (max). Neither copy crosses the
/// surface, also where the camera's heights lie within its own.
HeightInterval sculpting_offsets(const SculptingParameters& p, const HeightInterval& camera,
                                 const HeightInterval& surface);

/// Begin and end of the disparities of every `step`-th pixel; begin is not below end where a line
/// of sight meets none of the surfaces.
using SparseBounds = cv::Mat_<cv::Vec2i>;
inline bool is_empty(const cv::Vec2i& bounds) { return bounds[1] <= bounds[0]; }

/// Steps 2 to 6, between a surface moved down by moves.min and one moved up by moves.max.
SparseBounds sparse_bounds(const RectifiedPair& pair, const HeightField& lower,
                           const HeightField& upper, const HeightInterval& moves, int step);

/// Step 7: what is empty becomes like the nearest that is not.
SparseBounds filled_by_nearest(const SparseBounds& sparse);
/// Every pixel is like the nearest grid point.
DisparityRange spread(const SparseBounds& sparse, cv::Size size, int step);

}  // namespace xgm::geo
