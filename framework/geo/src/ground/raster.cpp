// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/raster.hpp"

#include <gdal_priv.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "ground/gdal.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"

namespace xgm::geo {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// In place; compared as doubles, since a tag may say more digits than a float has.
void remove_nodata(cv::Mat1f& values, GDALRasterBand& band) {
  int has_nodata = 0;
  const auto nodata = static_cast<float>(band.GetNoDataValue(&has_nodata));
  for (float& value : values) {
    if (!std::isfinite(value) || (has_nodata != 0 && value == nodata)) value = kNone;
  }
}

void require(bool done, const std::string& file, const std::string& what) {
  if (!done) throw Error(file + ": " + what + ": " + QuietGdal::message());
}

GridPlace place_of(GDALDataset& dataset, const std::string& file) {
  double t[6];
  if (dataset.GetGeoTransform(t) != CE_None) return {0, 0, 1, 1};
  if (t[2] != 0 || t[4] != 0) {
    throw Error(file + ": the raster is rotated; warp it north up first (gdalwarp)");
  }
  return {t[0], t[3], t[1], t[5]};
}

/// The bytes of the file, made in memory: it gets its name when it is complete.
std::string encode(GDALDriver& cog, GDALDataset& dataset, const std::string& file) {
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=YES", "RESAMPLING=AVERAGE",
                                 nullptr};
  const std::string name =
      "/vsimem/xgm/" + std::to_string(reinterpret_cast<std::uintptr_t>(&dataset));
  const DatasetPtr copy(
      cog.CreateCopy(name.c_str(), &dataset, FALSE, const_cast<char**>(options), nullptr, nullptr));
  require(copy != nullptr, file, "cannot be written");
  copy->FlushCache();
  vsi_l_offset size = 0;
  const GByte* const bytes = VSIGetMemFileBuffer(name.c_str(), &size, FALSE);
  std::string encoded(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  VSIUnlink(name.c_str());
  VSIUnlink((name + ".aux.xml").c_str());
  return encoded;
}

}  // namespace

Raster read_raster(const std::string& file, int band_number) {
  const DatasetPtr dataset = open_raster(file);
  const QuietGdal quiet;
  if (band_number < 1 || band_number > dataset->GetRasterCount()) {
    throw Error(file + ": has " + std::to_string(dataset->GetRasterCount()) + " bands, no band " +
                std::to_string(band_number));
  }
  GDALRasterBand& band = *dataset->GetRasterBand(band_number);
  Raster raster;
  raster.values.create(band.GetYSize(), band.GetXSize());
  require(band.RasterIO(GF_Read, 0, 0, band.GetXSize(), band.GetYSize(), raster.values.data,
                        band.GetXSize(), band.GetYSize(), GDT_Float32, 0, 0) == CE_None,
          file, "cannot be read to its end");
  remove_nodata(raster.values, band);
  raster.place = place_of(*dataset, file);
  const char* const crs = dataset->GetProjectionRef();
  raster.crs = crs != nullptr ? crs : "";
  for (char** entry = dataset->GetMetadata(); entry != nullptr && *entry != nullptr; ++entry) {
    const std::string text(*entry);
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos)
      raster.metadata[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return raster;
}

void write_raster(const std::string& file, const Raster& raster) {
  GDALAllRegister();
  const QuietGdal quiet;
  GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDriver* const cog = GetGDALDriverManager()->GetDriverByName("COG");
  require(memory != nullptr && cog != nullptr, file,
          "this GDAL cannot write cloud-optimised GeoTIFF");
  const DatasetPtr dataset(
      memory->Create("", raster.values.cols, raster.values.rows, 1, GDT_Float32, nullptr));
  require(dataset != nullptr, file, "not enough memory");
  double t[6] = {raster.place.left,  raster.place.step_x, 0, raster.place.top, 0,
                 raster.place.step_y};
  if (!raster.crs.empty()) {
    dataset->SetGeoTransform(t);
    const bool is_ellipsoidal = has_ellipsoidal_heights(raster.crs);
    const Crs crs = is_ellipsoidal ? horizontal(raster.crs) : raster.crs;
    require(dataset->SetProjection(crs.c_str()) == CE_None, file, "has an unknown CRS");
    if (is_ellipsoidal) {
      dataset->SetMetadataItem("vertical_datum", std::string(kEllipsoidalHeights).c_str());
    }
  }
  for (const auto& [name, value] : raster.metadata) {
    dataset->SetMetadataItem(name.c_str(), value.c_str());
  }
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  band.SetNoDataValue(kNone);
  const cv::Mat1f values =
      raster.values.isContinuous() ? raster.values : cv::Mat1f(raster.values.clone());
  require(band.RasterIO(GF_Write, 0, 0, values.cols, values.rows, values.data, values.cols,
                        values.rows, GDT_Float32, 0, 0) == CE_None,
          file, "cannot be written");
  write_file(file, encode(*cog, *dataset, file));
}

}  // namespace xgm::geo
