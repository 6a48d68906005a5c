// SPDX-License-Identifier: Apache-2.0
// Kind "range_prior": which heights the ground can have at all, and so which disparities.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/image/rectified_pair.hpp"
#include "xgm/plugin.hpp"

namespace xgm::geo {

/// What is known of the ground when a window is matched; both may be null.
struct KnownSurfaces {
  const HeightField* dem = nullptr;
  /// The fused surface of a run at a quarter of the resolution: heights above the ellipsoid, in a
  /// projected CRS. Without cells if nothing could be matched there.
  const Raster* coarse = nullptr;
};

class XGM_API RangePrior : public Stage {
 public:
  static constexpr std::string_view kKind = "range_prior";
  static constexpr std::string_view kMeaning =
      "bounds the disparities of a satellite pair before it is matched";

  /// Lowest and highest ground in a window of the base image, for which the pair is then rectified.
  /// `dem` may be null.
  virtual HeightInterval heights(const SatelliteImage& base, const SatelliteImage& match,
                                 const cv::Rect& window, const HeightField* dem,
                                 const Context& context) const = 0;

  /// Whether it can do nothing without a DEM.
  virtual bool needs_dem() const { return false; }

  /// What bounds the search of a run at a quarter of the resolution, if run() wants to know the
  /// surface of that for a pair, whose heights() in some window are these; else null.
  virtual const Slot<RangePrior>* coarse_prior(const SatelliteImage& base,
                                               const SatelliteImage& match,
                                               const HeightInterval& heights,
                                               const HeightField* dem) const;

  /// The range of every pixel of the rectified base image. An empty interval: nothing is searched
  /// there. As it stands here: what ground between pair.heights has anywhere in the image.
  virtual DisparityRange run(const RectifiedPair& pair, const KnownSurfaces& known,
                             const Context& context) const;
};

/// Disparities of the points of a pixel between two heights, whole numbers outwards; empty if the
/// base camera finds no such point.
XGM_API std::optional<Interval> disparities_between(const RectifiedPair& pair,
                                                    cv::Point2d rectified,
                                                    const HeightInterval& heights);

/// How far apart the match image shows the lowest and the highest point of a line of sight, px, in
/// the middle of the base image: what has to be searched if no more is known. 0 if its camera finds
/// no such points.
XGM_API double parallax(const SatelliteImage& base, const SatelliteImage& match,
                        const HeightInterval& heights);

/// What a DEM knows of a window of an image, by every 16th pixel, or fewer of large windows.
struct DemCoverage {
  HeightInterval heights;       ///< lowest and highest place; of no meaning if `share` is 0
  double share = 0;             ///< of the pixels that have a height
  std::vector<cv::Point> gaps;  ///< pixels that have none
};
XGM_API DemCoverage dem_coverage(const SatelliteImage& image, const cv::Rect& window,
                                 const HeightField& dem);

/// Lowest and highest place of a DEM in a window of an image. Throws Error if it covers none of it.
XGM_API HeightInterval dem_heights(const SatelliteImage& image, const cv::Rect& window,
                                   const HeightField& dem);

}  // namespace xgm::geo
