// SPDX-License-Identifier: Apache-2.0
// Values on a grid on the ground: DEMs, DSMs and their layers.
#pragma once

#include <map>
#include <opencv2/core.hpp>
#include <string>

#include "xgm/geo/ground/crs.hpp"

namespace xgm::geo {

/// Where the cells of a grid lie, north up. A cell's value stands at its centre.
struct GridPlace {
  double left = 0;     ///< x of the left edge of the first column, in units of the CRS
  double top = 0;      ///< y of the upper edge of the first row
  double step_x = 1;   ///< to the next column
  double step_y = -1;  ///< to the next row; negative: to the south

  cv::Point2d centre(int column, int row) const {
    return {left + (column + 0.5) * step_x, top + (row + 0.5) * step_y};
  }
  /// Column and row of a place; whole at the centres of cells.
  cv::Point2d cell(cv::Point2d place) const {
    return {(place.x - left) / step_x - 0.5, (place.y - top) / step_y - 0.5};
  }
};

struct Raster {
  cv::Mat1f values;  ///< NaN where there is none
  GridPlace place;
  Crs crs;                                      ///< empty: no georeference
  std::map<std::string, std::string> metadata;  ///< of the file: "vertical_datum", ...
};

/// The CRS of a raster with what its heights are counted from, if either the CRS says that, or
/// "vertical_datum" in the metadata says the ellipsoid; else without. Throws Error if PROJ does not
/// know it.
XGM_API Crs crs_with_heights(const Crs& crs, const std::map<std::string, std::string>& metadata);

/// What a raster file says of its values.
struct RasterHead {
  cv::Size size;
  int bands = 0;
  GridPlace place;
  Crs crs;
  std::map<std::string, std::string> metadata;
};
/// Any format of GDAL. Throws Error, which names the file: unreadable, rotated.
XGM_API RasterHead read_raster_head(const std::string& file);
/// The file, what its format keeps in files beside it (cameras, georeferences), and what it refers
/// to, such as the sources of a VRT; but not *.aux.xml, which programs that show a raster write.
/// Throws Error.
XGM_API std::vector<std::string> files_of_raster(const std::string& file);
/// A window of it; the nodata value of the file becomes NaN. Throws Error, which names the file:
/// unreadable, no such band, rotated.
XGM_API Raster read_raster_window(const std::string& file, const cv::Rect& window, int band = 1);
/// All of it.
XGM_API Raster read_raster(const std::string& file, int band = 1);
/// Cloud-optimised GeoTIFF of 32-bit floats with overviews, NaN as nodata. Complete or not there.
/// GeoTIFF has no projected CRS of three dimensions: it is written as one of two, and its heights
/// as "vertical_datum".
XGM_API void write_raster(const std::string& file, const Raster& raster);

/// Codes for each cell, 0 to 255, on the grid of a raster.
struct LabelRaster {
  cv::Mat1b values;
  GridPlace place;
  Crs crs;
  std::map<std::string, std::string> metadata;  ///< what the codes mean: "code_1", ...
};
/// The same with 8-bit values, none of them nodata; overviews have the code of the nearest cell.
XGM_API void write_labels(const std::string& file, const LabelRaster& labels);

}  // namespace xgm::geo
