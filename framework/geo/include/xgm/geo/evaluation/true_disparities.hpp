// SPDX-License-Identifier: Apache-2.0
// What a true surface says of the disparities of a rectified satellite pair.
#pragma once

#include <memory>
#include <vector>

#include "xgm/evaluation/metrics.hpp"
#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/image/rectified_pair.hpp"

namespace xgm::geo {

/// Casts the sights of pixels on a true surface. Safe to use from several threads.
class XGM_API TrueDisparities {
 public:
  /// Heights above the ellipsoid, in a CRS in metres. Throws Error if the raster says otherwise, or
  /// nothing.
  explicit TrueDisparities(const Raster& surface);
  ~TrueDisparities();

  struct Sight {
    double disparity = 0;  ///< px, by the cameras of the pair
    bool visible = false;  ///< whether the match image shows the point, too
  };
  /// Of a pixel of the rectified base image; empty where it shows nothing of the surface.
  std::optional<Sight> at(const RectifiedPair& pair, cv::Point2d rectified) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Compares the maps of any number of windows with the truth, in every other row and column.
class XGM_API DisparityJudge {
 public:
  explicit DisparityJudge(const Raster& surface) : truth_(surface) {}
  void add(const RectifiedPair& pair, const DisparityMap& map);
  /// "all" and, if there are any, "non-occluded"; thresholds 0.5, 1, 2 and 4 px. Nothing if no
  /// pixel could be judged.
  std::vector<RegionEvaluation> evaluate() const;

 private:
  TrueDisparities truth_;
  std::vector<float> found_, true_;    // NaN: not found
  std::vector<std::uint8_t> visible_;  // 255 or 0
};

}  // namespace xgm::geo
