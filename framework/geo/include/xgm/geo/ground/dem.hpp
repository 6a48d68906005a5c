// SPDX-License-Identifier: Apache-2.0
// A digital elevation model: a raster of heights with what they are counted from.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "xgm/geo/ground/area.hpp"
#include "xgm/geo/ground/height_field.hpp"
#include "xgm/geo/ground/raster.hpp"

namespace xgm::geo {

/// Bilinear between the centres of cells; no height where one of the four has none.
class XGM_API Dem final : public HeightField {
 public:
  /// `raster` has a CRS with heights; they are turned into heights above the ellipsoid cell by
  /// cell. `name` is what errors call it. Throws UsageError.
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

/// Reads the tiles of a DEM, each a raster or "FILE,DATUM" with a vertical datum of with_heights()
/// in place of what the file says (a surface of ours says it as "vertical_datum"); or a folder,
/// with or without a datum, for all rasters in it. Tiles of one grid are one raster, so that there
/// is no seam between them; of those that overlap, the first that has a height counts. Only what
/// lies in `box`, and a little around it, is read. Throws UsageError, which names the file: what it
/// counts heights from is not said, or no tile lies in the box.
XGM_API std::shared_ptr<const HeightField> read_dem(const std::vector<std::string>& files,
                                                    const std::optional<DegreeBox>& box = {});
/// Of one file, all of it.
XGM_API std::shared_ptr<const HeightField> read_dem(const std::string& file);
/// The files that read_dem() reads: those of folders, without datums.
XGM_API std::vector<std::string> dem_files(const std::vector<std::string>& files);
/// Of "FILE,DATUM": the datum; "" of a file or folder alone.
XGM_API std::string dem_datum(const std::string& text);

}  // namespace xgm::geo
