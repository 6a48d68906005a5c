// SPDX-License-Identifier: Apache-2.0
// The least-squares problem: biases of all cameras and the ground points of all tracks at once.
#pragma once

#include <vector>

#include "plugins/pointing/bundle_adjustment/tracks.hpp"

namespace xgm::geo {

struct AdjustmentSettings {
  double prior = 10;        ///< how far cameras may be off, standard deviation, px
  double loss = 1;          ///< where residuals begin to count less, px
  bool keep_first = false;  ///< the first image stays where it is
};

struct Adjustment {
  std::vector<cv::Point2d> biases;  ///< what each projection is moved by, px
  std::size_t tracks = 0;           ///< that were used
  double median_before = 0;         ///< of the distances of observations and projections, px
  double median_after = 0;
  cv::Vec3d datum;  ///< what the ground points moved by in the median: east, north, up, m
};

/// Tracks alone cannot tell a shift of all the ground with all the images: of all solutions, the
/// prior takes the one with the smallest biases. The same for any number of threads.
XGM_API Adjustment adjust(const std::vector<RpcCamera>& cameras, const std::vector<Track>& tracks,
                          const AdjustmentSettings& settings);

}  // namespace xgm::geo
