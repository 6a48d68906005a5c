// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "ground/gdal.hpp"
#include "ground/paths.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/ground/area.hpp"

namespace xgm::geo {
namespace {

/// What GDAL calls the CRS of a layer or a raster, as WKT; empty: none.
Crs crs_of(const OGRSpatialReference* reference) {
  if (reference == nullptr) return {};
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  const bool written = reference->exportToWkt(&text, options) == OGRERR_NONE;
  const Crs crs = written && text != nullptr ? text : "";
  CPLFree(text);
  return crs;
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  void add(const OGRGeometry& geometry, const CrsTransform& to_degrees) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPolygon) {
      for (const OGRLinearRing* ring : *geometry.toPolygon()) add_ring(*ring, to_degrees);
    } else if (type == wkbMultiPolygon || type == wkbGeometryCollection) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part, to_degrees);
    } else {
      other_ = geometry.getGeometryName();
    }
  }

  Outline outline() const {
    if (!rings_.empty()) return rings_;
    throw UsageError(file_ + ": holds no polygon" +
                     (other_.empty() ? "" : ", but geometries of type " + other_) +
                     "; give one around the area");
  }

 private:
  void add_ring(const OGRLinearRing& ring, const CrsTransform& to_degrees) {
    std::vector<cv::Point2d> points;
    for (const OGRPoint& point : ring) {
      const cv::Vec3d p = to_degrees.inverse({point.getX(), point.getY(), 0});
      points.emplace_back(p[0], p[1]);
    }
    if (points.size() > 1 && points.front() == points.back()) points.pop_back();
    if (points.size() >= 3) rings_.push_back(std::move(points));
  }

  std::string file_, other_;
  Outline rings_;
};

Outline read_polygons(GDALDataset& dataset, const std::string& file) {
  Reader reader(file);
  for (OGRLayer* layer : dataset.GetLayers()) {
    const Crs crs = crs_of(layer->GetSpatialRef());
    if (crs.empty()) {
      throw UsageError(file + ": layer '" + layer->GetName() +
                       "' has no CRS; assign one (ogr2ogr -a_srs)");
    }
    const CrsTransform to_degrees("EPSG:4326", horizontal(crs));
    for (const OGRFeatureUniquePtr& feature : *layer) {
      const OGRGeometry* const geometry = feature->GetGeometryRef();
      if (geometry != nullptr) reader.add(*geometry, to_degrees);
    }
  }
  return reader.outline();
}

Outline corners_of(GDALDataset& raster, const std::string& file) {
  double t[6];
  const Crs crs = crs_of(raster.GetSpatialRef());
  if (crs.empty() || raster.GetGeoTransform(t) != CE_None) {
    throw UsageError(file +
                     ": is a raster without a CRS, whose place is not known; give one that has a "
                     "CRS, or a file with a polygon");
  }
  const CrsTransform to_degrees("EPSG:4326", horizontal(crs));
  std::vector<cv::Point2d> corners;
  for (const cv::Point2d corner :
       {cv::Point2d(0, 0), cv::Point2d(1, 0), cv::Point2d(1, 1), cv::Point2d(0, 1)}) {
    const double x = corner.x * raster.GetRasterXSize(), y = corner.y * raster.GetRasterYSize();
    const cv::Vec3d p =
        to_degrees.inverse({t[0] + x * t[1] + y * t[2], t[3] + x * t[4] + y * t[5], 0});
    corners.emplace_back(p[0], p[1]);
  }
  return {corners};
}

}  // namespace

Outline read_outline(const std::string& file) {
  GDALAllRegister();
  const QuietGdal quiet;
  if (!is_there(file)) throw UsageError(file + ": there is no such file");
  const DatasetPtr dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (dataset == nullptr) {
    throw UsageError(file +
                     ": is no area: neither a file with polygons (GeoJSON, Shapefile, KML) nor a "
                     "raster that GDAL can read");
  }
  try {
    return dataset->GetRasterCount() > 0 ? corners_of(*dataset, file)
                                         : read_polygons(*dataset, file);
  } catch (const UsageError&) {
    throw;
  } catch (const Error& error) {  // its coordinates are not those of its CRS
    throw UsageError(file + ": " + error.message());
  }
}

}  // namespace xgm::geo
