// SPDX-License-Identifier: Apache-2.0
// How good a surface is, by the metrics of the multi-view stereo benchmark: Bosch, Kurtz, Hagstrom,
// Brown: A multiple view stereo benchmark for satellite imagery (AIPR 2016).
#pragma once

#include <cstdint>
#include <string>

#include "xgm/base/json.hpp"
#include "xgm/geo/ground/raster.hpp"

namespace xgm::geo {

/// dz is surface minus truth, m.
struct SurfaceErrors {
  std::int64_t truth_cells = 0;  ///< that have a truth
  std::int64_t cells = 0;        ///< that have both
  double completeness = 0;       ///< share of truth_cells with |dz| < threshold, 0 to 1
  double coverage = 0;           ///< share of truth_cells that have a height, 0 to 1
  double median_error = 0;       ///< of |dz| over `cells`; NaN without any, as are the next
  double rmse = 0;
  double signed_median = 0;
};

/// Cell by cell. Throws UsageError if the sizes differ. `threshold` in m.
XGM_API SurfaceErrors compare_surfaces(const cv::Mat1f& surface, const cv::Mat1f& truth,
                                       double threshold = 1);

/// Leaves heights out that a filter has filled: where `source`, on the surface's grid, is 2
/// (source.tif of a run). Throws UsageError if the sizes differ.
XGM_API void remove_filled(Raster& surface, const Raster& source);

/// The surface on the truth's grid: itself if both have no georeference and one size; else bilinear
/// at the centres of the truth's cells, its heights taken from its datum to the truth's if both say
/// theirs. Throws UsageError if only one of the two has a georeference.
XGM_API cv::Mat1f on_grid_of(const Raster& surface, const Raster& truth);

/// How on_grid_of() brings the two together, a sentence: cell by cell, or by what it resamples and
/// whether heights change their datum. Throws Error as on_grid_of() does.
XGM_API std::string comparison_text(const Raster& surface, const Raster& truth);

/// For records; figures that are not known are null.
XGM_API Json to_json(const SurfaceErrors& errors);

}  // namespace xgm::geo
