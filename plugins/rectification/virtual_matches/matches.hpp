// SPDX-License-Identifier: Apache-2.0
// Where both cameras see the same points of the ground: what rectifications are fitted to and
// judged by.
#pragma once

#include <vector>

#include "xgm/geo/stage/rectification.hpp"

namespace xgm::geo {

/// Places of the window, in each direction, and heights at which both cameras are compared.
inline constexpr int kPlaces = 7;
inline constexpr int kHeights = 5;

/// Where one ground point is seen.
struct VirtualMatch {
  cv::Point2d base, match;
  int height = 0;  ///< index of its height, 0 to kHeights - 1
};

/// Small windows and low heights are widened, for the direction of epipolar lines shows only over
/// some length. Throws Error if the window is empty, the heights are none, the cameras look along
/// the same lines, or the base camera finds no ground in most of the window.
std::vector<VirtualMatch> virtual_matches(const SatelliteImage& base, const SatelliteImage& match,
                                          const cv::Rect& window, const HeightInterval& heights);

/// The part of a rectified plane that shows a window of the base image, and what it may correspond
/// to. `geometry` need not know its size yet. Whole pixels.
cv::Rect frame(const Rectification& geometry, const std::vector<VirtualMatch>& matches,
               const cv::Rect& window);

/// Root mean square of what the matches differ in y, px.
double residual_of(const Rectification& geometry, const std::vector<VirtualMatch>& matches);

}  // namespace xgm::geo
