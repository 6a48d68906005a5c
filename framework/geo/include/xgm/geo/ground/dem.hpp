// SPDX-License-Identifier: Apache-2.0
// A digital elevation model: a raster of heights with what they are counted from.
#pragma once

#include <memory>
#include <string>

#include "xgm/geo/ground/height_field.hpp"
#include "xgm/geo/ground/raster.hpp"

namespace xgm::geo {

/// Bilinear between the centres of cells; no height where one of the four has none.
class XGM_API Dem final : public HeightField {
 public:
  /// `raster` has a CRS with heights; they are turned into heights above the ellipsoid cell by
  /// cell. `name` is what errors call it. Throws Error.
  Dem(Raster raster, const std::string& name);
  ~Dem() override;

  std::optional<double> height(double longitude, double latitude) const override;
  HeightInterval bounds() const override { return bounds_; }
  double posting() const override { return posting_; }

 private:
  cv::Mat1d heights_;  // above the ellipsoid; NaN: none
  GridPlace place_;
  std::unique_ptr<CrsTransform> to_grid_;  // from longitude and latitude; null: they are the grid's
  HeightInterval bounds_;
  double posting_ = 0;
};

/// `file` is a raster, or "FILE,DATUM" with a vertical datum of with_heights() in place of what the
/// file says; a surface of ours says it as "vertical_datum". Throws UsageError if neither says what
/// the heights are counted from.
XGM_API std::shared_ptr<const Dem> read_dem(const std::string& file);
/// The file's name without a datum.
XGM_API std::string dem_file(const std::string& file);

}  // namespace xgm::geo
